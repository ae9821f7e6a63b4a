"""Events under SimpleITK's names and numbers, so that its own constants serve as well."""
from __future__ import annotations

import enum


class EventEnum(enum.IntEnum):
    """What a command can wait for. ``sitkMultiResolutionIterationEvent`` is also a ``sitkIterationEvent``."""

    sitkAnyEvent = 0
    sitkAbortEvent = 1
    sitkDeleteEvent = 2
    sitkEndEvent = 3
    sitkIterationEvent = 4
    sitkProgressEvent = 5
    sitkStartEvent = 6
    sitkUserEvent = 7
    sitkMultiResolutionIterationEvent = 9


sitkAnyEvent = EventEnum.sitkAnyEvent
sitkAbortEvent = EventEnum.sitkAbortEvent
sitkDeleteEvent = EventEnum.sitkDeleteEvent
sitkEndEvent = EventEnum.sitkEndEvent
sitkIterationEvent = EventEnum.sitkIterationEvent
sitkProgressEvent = EventEnum.sitkProgressEvent
sitkStartEvent = EventEnum.sitkStartEvent
sitkUserEvent = EventEnum.sitkUserEvent
sitkMultiResolutionIterationEvent = EventEnum.sitkMultiResolutionIterationEvent


class Command:
    """An observer as a class: override :meth:`Execute`."""

    def Execute(self) -> None:
        """Called at each event that the command was added for; it takes and returns nothing."""
        raise NotImplementedError("override Execute()")
