"""What every process object has beside its own members."""
from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Callable, Mapping, Union

from . import _core
from ._errors import ArgumentError
from ._events import Command

if TYPE_CHECKING:
    _Base = _core.ProcessObject
else:
    _Base = object

CommandLike = Union[Callable[[], object], Command]


class Observable:
    """Commands: called in the thread that runs, with the interpreter taken."""

    def AddCommand(self: Any, event: int, command: CommandLike) -> int:
        """Calls the command at each such event.

        Parameters
        ----------
        event : EventEnum or int
            ``sitkIterationEvent`` and the like; SimpleITK's constants are the same numbers.
        command : callable without arguments, or Command

        Returns
        -------
        int
            A number for :meth:`RemoveCommand`.
        """
        call = command if callable(command) else getattr(command, "Execute", None)
        if not callable(call):
            raise TypeError(f"{command!r} can't be called and has no Execute()")
        commands = self.__dict__.setdefault("_commands", {})
        key: int = self.__dict__.get("_key", 0) + 1
        self.__dict__["_key"] = key
        commands[key] = (self._AddCommand(int(event), key), int(event), call)
        return key

    def RemoveCommand(self: Any, number: int) -> None:
        """Removes a command by the number that :meth:`AddCommand` returned."""
        commands = self.__dict__.get("_commands", {})
        if number not in commands:
            raise ArgumentError(f"there is no command {number}")
        self._RemoveCommand(commands.pop(number)[0])

    def RemoveAllCommands(self) -> None:
        """Removes every command that was added here."""
        for number in list(self.__dict__.get("_commands", {})):
            self.RemoveCommand(number)

    def HasCommand(self, event: int) -> bool:
        """Whether a command waits for this event."""
        return any(entry[1] == int(event) for entry in self.__dict__.get("_commands", {}).values())

    def _InvokeCommand(self, key: int) -> None:
        entry = self.__dict__.get("_commands", {}).get(key)
        if entry is not None:
            entry[2]()


class ProcessObject(Observable, _Base):
    """Commands: called in the thread that runs :meth:`Execute`, with the interpreter taken.

    An exception in a command ends the run at the next point where it can be ended and comes out of ``Execute``
    unchanged. Ctrl-C does the same with ``KeyboardInterrupt``.
    """


if not TYPE_CHECKING:
    # Its classes inherit these from the compiled part; who asks the class itself for them must find them, too.
    for _name in ("GetGlobalDefaultNumberOfThreads", "SetGlobalDefaultNumberOfThreads"):
        setattr(ProcessObject, _name, staticmethod(getattr(_core.ProcessObject, _name)))


def apply_settings(process: Any, settings: Mapping[str, object]) -> None:
    """Keywords of a procedural twin: ``sigma=0.5`` is ``SetSigma(0.5)``; True and False switch too."""
    for name, value in settings.items():
        setter = getattr(process, "Set" + name[:1].upper() + name[1:], None)
        if setter is None:
            raise TypeError(f"{type(process).__name__} has no Set{name[:1].upper()}{name[1:]}() for {name!r}")
        try:
            setter(value)
        except TypeError as error:
            # The binding lists signatures; of an enumeration the values are of use.
            taken = re.search(r": dentalscr\._core\.([\w.]+)[,)]", str(error).partition("self: ")[2].partition(",")[2])
            if not isinstance(value, str) or taken is None:
                raise
            kind: Any = _core
            for part in taken[1].split("."):
                kind = getattr(kind, part)
            if not hasattr(kind, "__members__"):
                raise
            raise ArgumentError(f"{name} is no {value!r}; use one of {', '.join(kind.__members__)}") from None
