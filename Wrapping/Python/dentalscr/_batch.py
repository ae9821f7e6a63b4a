"""Many cases from Python: results one by one as they are done."""
from __future__ import annotations

import concurrent.futures
import functools
import multiprocessing
import os
import threading
import time
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, NamedTuple, Optional, Union, cast

from . import _core
from ._case import Case, register
from ._case_result import CaseResult
from ._errors import AbortedError, ArgumentError
from ._inputs import PathLike, as_path, is_path

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import _settings


class BatchItem(NamedTuple):
    """One case of :func:`batch`: its result, or what went wrong with it."""

    id: str
    result: Optional[CaseResult]
    #: What :func:`register` raised; None where there is a result.
    error: Optional[Exception]
    seconds: float


def _run(
    case: Any, output: Optional[str], arguments: Mapping[str, Any], stop: Optional[threading.Event] = None
) -> "tuple[Optional[CaseResult], Optional[Exception], float]":
    start = time.perf_counter()

    def look(share: float, stage: str) -> None:
        if stop is not None and stop.is_set():
            raise AbortedError("the batch was interrupted")

    try:
        return register(case, output, progress=None if stop is None else look, **arguments), None, time.perf_counter() - start
    except Exception as error:  # One bad case never stops the rest; the caller gets what it raised.
        return None, error, time.perf_counter() - start


def _name(cases: Union[PathLike, Mapping[str, Any], Iterable[Any]]) -> Dict[str, Any]:
    if isinstance(cases, Mapping):
        return dict(cases)
    given: Iterable[Any] = [cases] if is_path(cases) else cast("Iterable[Any]", cases)
    named: Dict[str, Any] = {}
    for number, case in enumerate(given, 1):
        for name, found in _core._FindBatchCases(as_path(case)) if is_path(case) else [(f"case{number}", case)]:
            if name in named:
                raise ArgumentError(f'two cases are called "{name}": give a dict of names and cases')
            named[name] = found
    return named


def _end(workers: Iterable[concurrent.futures.Executor]) -> None:
    """Ends processes in the midst of their cases, whose folders stay as they were."""
    for worker in workers:
        for process in list((getattr(worker, "_processes", None) or {}).values()):
            process.terminate()


def _make_worker(process: bool) -> concurrent.futures.Executor:
    """One worker: a pool of several would break as a whole with one of its processes, and take cases with it."""
    if process:
        # Spawned: a fork of a process with threads may hang.
        return concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"))
    return concurrent.futures.ThreadPoolExecutor(1)


def batch(
    cases: Union[PathLike, Mapping[str, Any], Iterable[Any]],
    output: Optional[PathLike] = None,
    *,
    jobs: Optional[int] = None,
    processes: bool = True,
    progress: Optional[Callable[[int, int, BatchItem], object]] = None,
    **arguments: Unpack[_settings.BatchSettings],
) -> Iterator[BatchItem]:
    """Registers many cases and yields each as it is done, in whatever order that is.

    Memory is that of the cases at work: what is not kept of a result is gone. For tables and a page, and to go on after
    a stop, there is ``dentalscr batch``.

    Parameters
    ----------
    cases : path, iterable or dict
        A folder, a table of case files, a case file or a pattern, as of ``dentalscr batch``; several of these,
        :class:`Case` objects or keywords of one; or a dict of case files, objects or keywords by name.
    output : path, optional
        Folder in which each case gets one of its own, named after it.
    jobs : int, optional
        Cases at a time; default: one a core.
    processes : bool, optional
        Whether each worker is a process: what breaks it leaves the others alone, and results come without their scans. Off:
        threads of this process, which :class:`Case` objects need.
    progress : callable, optional
        Called with the number that is done, the number of all, and the item.
    **arguments
        Of :func:`register`: ``preset``, ``options``, ``exclude``, ... ``threads`` is 1 by default.

    Yields
    ------
    BatchItem

    Raises
    ------
    KeyboardInterrupt
        On Ctrl-C, at once: the cases at work are given up, and what their folders held before is still there.
    """
    named = _name(cases)
    if processes and any(isinstance(case, Case) for case in named.values()):
        raise ArgumentError("a Case in memory goes to no other process: give case files, or processes=False")
    workers = jobs if jobs is not None else os.cpu_count() or 1
    if workers < 1:
        raise ArgumentError(f"{workers} jobs do nothing: give 1 or more")
    folder = None if output is None else Path(as_path(output))
    arguments = {"threads": 1, **arguments}
    idle = [_make_worker(processes) for _ in range(min(workers, len(named)))]
    waiting = iter(named.items())
    running: "Dict[concurrent.futures.Future[Any], tuple[str, concurrent.futures.Executor]]" = {}
    done = 0
    # Threads look at it while they register; processes are ended.
    stop = threading.Event()
    try:
        while True:
            # No more than are at work: a thousand results that nobody has asked for yet would fill the memory.
            while idle:
                following = next(waiting, None)
                if following is None:
                    break
                name, case = following
                task = functools.partial(
                    _run,
                    str(case) if is_path(case) else case,
                    None if folder is None else str(folder / name),
                    arguments,
                    None if processes else stop,
                )
                worker = idle.pop()
                try:
                    future = worker.submit(task)
                except concurrent.futures.BrokenExecutor:
                    # It died while it had nothing to do: no case's fault.
                    worker.shutdown(wait=False)
                    worker = _make_worker(processes)
                    future = worker.submit(task)
                running[future] = (name, worker)
            if not running:
                return
            finished, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in finished:
                name, worker = running.pop(future)
                failure = future.exception()
                if isinstance(failure, concurrent.futures.BrokenExecutor):
                    worker.shutdown(wait=False)
                    worker = _make_worker(processes)
                idle.append(worker)
                if failure is not None and not isinstance(failure, Exception):
                    raise failure
                result, error, seconds = (None, failure, 0.0) if failure is not None else future.result()
                done += 1
                item = BatchItem(name, result, error, seconds)
                if progress is not None:
                    progress(done, len(named), item)
                yield item
    except KeyboardInterrupt:
        stop.set()
        _end(worker for _, worker in running.values())
        raise
    finally:
        for worker in [*idle, *(worker for _, worker in running.values())]:
            worker.shutdown(wait=True, cancel_futures=True)
