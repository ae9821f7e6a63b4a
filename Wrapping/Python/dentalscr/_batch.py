"""Many cases from Python: results one by one as they are done."""
from __future__ import annotations

import concurrent.futures
import multiprocessing
import os
import time
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, Callable, Dict, NamedTuple, Optional, Union, cast

from ._case import Case, CaseResult, register
from ._errors import ArgumentError
from ._inputs import PathLike, as_path, is_path


class BatchItem(NamedTuple):
    """One case of :func:`batch`: its result, or what went wrong with it."""

    id: str
    result: Optional[CaseResult]
    #: What :func:`register` raised; None where there is a result.
    error: Optional[Exception]
    seconds: float


def _run(case: Any, output: Optional[str], arguments: Dict[str, Any]) -> "tuple[Optional[CaseResult], Optional[Exception], float]":
    start = time.perf_counter()
    try:
        return register(case, output, **arguments), None, time.perf_counter() - start
    except Exception as error:  # One bad case never stops the rest; the caller gets what it raised.
        return None, error, time.perf_counter() - start


def _find(folder: Path) -> Dict[str, Any]:
    """The cases below a folder as ``dentalscr batch`` names them."""
    files = sorted(path for path in folder.rglob("case.json") if not any(part.startswith(".") for part in path.parts[:-1]))
    if not files:
        raise ArgumentError(f"{folder} holds no case.json: name the case files themselves")
    return {"_".join(path.relative_to(folder).parent.parts) or folder.resolve().name: path for path in files}


def _name(cases: Union[PathLike, Mapping[str, Any], Iterable[Any]]) -> Dict[str, Any]:
    if isinstance(cases, Mapping):
        return dict(cases)
    if is_path(cases):
        path = Path(as_path(cast("PathLike", cases)))
        return _find(path) if path.is_dir() else {path.parent.resolve().name if path.name == "case.json" else path.stem: path}
    named: Dict[str, Any] = {}
    for number, case in enumerate(cast("Iterable[Any]", cases), 1):
        if is_path(case):
            path = Path(as_path(case))
            name = path.parent.resolve().name if path.name == "case.json" else path.stem
        else:
            name = f"case{number}"
        if name in named:
            raise ArgumentError(f'two cases are called "{name}": give a dict of names and cases')
        named[name] = case
    return named


def batch(
    cases: Union[PathLike, Mapping[str, Any], Iterable[Any]],
    output: Optional[PathLike] = None,
    *,
    jobs: Optional[int] = None,
    processes: bool = True,
    progress: Optional[Callable[[int, int, BatchItem], object]] = None,
    **arguments: Any,
) -> Iterator[BatchItem]:
    """Registers many cases and yields each as it is done, in whatever order that is.

    Memory is that of the cases at work: what is not kept of a result is gone. For tables and a page, and to go on after
    a stop, there is ``dentalscr batch``.

    Parameters
    ----------
    cases : folder, iterable or dict
        A folder with a ``case.json`` in each folder below; case files, :class:`Case` objects or keywords of one; or a dict
        of these by name.
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
    """
    named = _name(cases)
    if processes and any(isinstance(case, Case) for case in named.values()):
        raise ArgumentError("a Case in memory goes to no other process: give case files, or processes=False")
    workers = jobs if jobs is not None else os.cpu_count() or 1
    if workers < 1:
        raise ArgumentError(f"{workers} jobs do nothing: give 1 or more")
    folder = None if output is None else Path(as_path(output))
    arguments = {"threads": 1, **arguments}
    pool: concurrent.futures.Executor
    if processes:
        # Spawned: a fork of a process with threads may hang.
        pool = concurrent.futures.ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))
    else:
        pool = concurrent.futures.ThreadPoolExecutor(workers)
    waiting = iter(named.items())
    running: "Dict[concurrent.futures.Future[Any], str]" = {}
    done = 0
    try:
        while True:
            # No more than are at work: a thousand results that nobody has asked for yet would fill the memory.
            while len(running) < workers:
                following = next(waiting, None)
                if following is None:
                    break
                name, case = following
                given = str(case) if is_path(case) else case
                target = None if folder is None else str(folder / name)
                running[pool.submit(_run, given, target, arguments)] = name
            if not running:
                return
            finished, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in finished:
                name = running.pop(future)
                failure = future.exception()
                if failure is not None and not isinstance(failure, Exception):
                    raise failure
                result, error, seconds = (None, failure, 0.0) if failure is not None else future.result()
                done += 1
                item = BatchItem(name, result, error, seconds)
                if progress is not None:
                    progress(done, len(named), item)
                yield item
            if processes and any(isinstance(future.exception(), concurrent.futures.BrokenExecutor) for future in finished):
                # The worker died with its case; the others go on in new ones.
                pool.shutdown(wait=False)
                pool = concurrent.futures.ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
