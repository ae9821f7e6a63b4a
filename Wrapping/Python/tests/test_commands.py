"""Events, exceptions from commands, Ctrl-C, threads."""
import gc
import os
import signal
import subprocess
import sys
import threading
import time
import weakref

import numpy as np
import pytest


@pytest.fixture
def contours(ds, case):
    return case.upperContour, ds.ContourResample(case.upperContour, numberOfPoints=150)


class Mine(Exception):
    pass


def test_events_come_in_the_order_of_the_levels(ds, contours):
    method = ds.SilhouetteToContourRegistrationMethod()
    seen = []
    method.AddCommand(ds.sitkStartEvent, lambda: seen.append("start"))
    method.AddCommand(ds.sitkMultiResolutionIterationEvent, lambda: seen.append(method.GetCurrentLevel()))
    method.AddCommand(
        ds.sitkIterationEvent,
        lambda: seen.append((method.GetOptimizerIteration(), method.GetMetricValue(), method.GetOptimizerPosition())),
    )
    method.AddCommand(ds.sitkEndEvent, lambda: seen.append("end"))
    method.Execute(*contours)
    assert seen[0] == "start" and seen[-1] == "end"
    assert [entry for entry in seen if isinstance(entry, int)] == [0, 1, 2]
    iterations = [entry for entry in seen if isinstance(entry, tuple)]
    assert len(iterations) > 3 and all(len(entry[2]) == 4 and np.isfinite(entry[1]) for entry in iterations)
    assert method.GetOptimizerStopConditionDescription()


def test_numbers_of_events_are_simpleitks(ds):
    assert [int(e) for e in ds.EventEnum] == [0, 1, 2, 3, 4, 5, 6, 7, 9]
    with pytest.raises(ds.ArgumentError, match="no event 8"):
        ds.ContourDistanceFilter().AddCommand(8, lambda: None)


def test_command_objects_and_removal(ds, contours):
    class Counter(ds.Command):
        count = 0

        def Execute(self):
            self.count += 1

    method = ds.SilhouetteToContourRegistrationMethod()
    counter = Counter()
    number = method.AddCommand(ds.sitkIterationEvent, counter)
    assert method.HasCommand(ds.sitkIterationEvent) and not method.HasCommand(ds.sitkStartEvent)
    method.Execute(*contours)
    counted = counter.count
    assert counted > 0
    method.RemoveCommand(number)
    method.Execute(*contours)
    assert counter.count == counted and not method.HasCommand(ds.sitkIterationEvent)
    with pytest.raises(ds.ArgumentError):
        method.RemoveCommand(number)
    with pytest.raises(TypeError, match="can't be called"):
        method.AddCommand(ds.sitkIterationEvent, 3)


@pytest.mark.parametrize(
    "event", ["sitkStartEvent", "sitkProgressEvent", "sitkMultiResolutionIterationEvent", "sitkIterationEvent", "sitkEndEvent"]
)
def test_exception_of_a_command_comes_out_unchanged_and_the_object_can_run_again(ds, contours, event):
    method = ds.SilhouetteToContourRegistrationMethod()
    error = Mine("mine")

    def fail():
        raise error

    number = method.AddCommand(getattr(ds, event), fail)
    for _ in range(2):
        with pytest.raises(Mine) as caught:
            method.Execute(*contours)
        assert caught.value is error
        assert any(entry.name == "fail" for entry in caught.traceback)
    method.RemoveCommand(number)
    assert method.Execute(*contours).GetScale() > 0


def test_exception_ends_the_run_early(ds, contours):
    def run(fail_at):
        method = ds.SilhouetteToContourRegistrationMethod()
        count = []

        def step():
            count.append(1)
            if len(count) == fail_at:
                raise Mine()

        method.AddCommand(ds.sitkIterationEvent, step)
        if fail_at:
            with pytest.raises(Mine):
                method.Execute(*contours)
        else:
            method.Execute(*contours)
        return len(count)

    assert run(2) < run(0)


def test_abort_is_an_error_of_its_own(ds, contours):
    method = ds.SilhouetteToContourRegistrationMethod()
    method.AddCommand(ds.sitkIterationEvent, method.Abort)
    with pytest.raises(ds.AbortedError):
        method.Execute(*contours)


def test_case_is_aborted_by_its_progress(ds, case):
    def stop(share, stage):
        if share > 0.1:
            raise Mine(stage)

    for preset in ("robust", "paper"):
        with pytest.raises(Mine):
            ds.register(case, preset=preset, progress=stop)


def test_object_with_a_command_that_refers_to_it_is_collected(ds, contours):
    method = ds.SilhouetteToContourRegistrationMethod()
    method.AddCommand(ds.sitkAnyEvent, lambda: method.GetMetricValue())
    method.Execute(*contours)
    reference = weakref.ref(method)
    del method
    gc.collect()
    assert reference() is None


def test_one_object_does_not_run_twice_at_a_time(ds, contours):
    method = ds.SilhouetteToContourRegistrationMethod()
    method.AddCommand(ds.sitkIterationEvent, lambda: method.Execute(*contours))
    with pytest.raises(RuntimeError, match="running already"):
        method.Execute(*contours)


def test_other_threads_run_while_a_registration_does(ds, case):
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.perf_counter()
    ds.register(case)
    end = time.perf_counter()
    done.set()
    thread.join()
    # With the interpreter held throughout there would be none between.
    assert sum(start < t < end for t in ticks) > 5


def test_registrations_in_threads_give_the_same_bits(ds, case, contours):
    def run(results, i):
        moving = ds.ContourResample(case.upperContour, numberOfPoints=150)
        method = ds.SilhouetteToContourRegistrationMethod()
        method.AddCommand(ds.sitkIterationEvent, lambda: method.GetMetricValue())
        similarity = method.Execute(case.upperContour, moving).GetParameters()
        pose = ds.register(case)
        results[i] = (similarity, [jaw.P_pixel_from_mesh.tobytes() for jaw in pose.jaws.values()])

    results = [None] * 3
    threads = [threading.Thread(target=run, args=(results, i)) for i in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    alone = [None]
    run(alone, 0)
    assert results == alone * 3


def test_number_of_threads_changes_no_bit(ds, case):
    one, two = (ds.register(case, threads=count) for count in (1, 2))
    for name, jaw in one.jaws.items():
        assert np.array_equal(jaw.P_pixel_from_mesh, two.jaws[name].P_pixel_from_mesh)


def in_new_process(code, **keywords):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    return subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment, **keywords
    )


def test_ctrl_c_ends_a_long_run(ds):
    """Half a minute of work, interrupted: KeyboardInterrupt, and the object is usable after."""
    # A shell that started the tests in the background had them ignore the signal, and their children inherit that.
    code = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
import dentalscr as ds, numpy as np
t = np.linspace(0, 6.28, 400, endpoint=False)
curve = ds.Contour([ds.Polyline(np.c_[50 * np.cos(t) + 9 * np.cos(3 * t), 30 * np.sin(t)], closed=True)])
method = ds.SilhouetteToContourRegistrationMethod()
method.SetOptimizerAsExhaustive([40, 40, 40, 40])
first = []
def say():
    if not first:
        first.append(1); print("running", flush=True)
method.AddCommand(ds.sitkIterationEvent, say)
try:
    method.Execute(curve, curve)
    print("finished")
except KeyboardInterrupt:
    method.SetOptimizerAsLBFGSB()
    print("interrupted", method.Execute(curve, curve).GetScale() > 0)
"""
    process = in_new_process(code)
    assert process.stdout.readline().strip() == "running"
    process.send_signal(signal.SIGINT)
    try:
        out, errors = process.communicate(timeout=60)
    finally:
        process.kill()
    assert out.strip() == "interrupted True", out + errors


def test_forked_processes_register_too(ds, sample):
    """A pool of processes, made after the parent has used its threads."""
    code = f"""
import multiprocessing, dentalscr as ds
def run(threads):
    return ds.register({str(sample / "case.json")!r}, threads=threads).upper.P_pixel_from_mesh.tobytes()
if __name__ == "__main__":
    here = run(2)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        print(all(there == here for there in pool.map(run, [1, 1])))
"""
    process = in_new_process(code)
    out, errors = process.communicate(timeout=120)
    assert out.strip() == "True", out + errors
