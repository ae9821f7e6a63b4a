"""What goes wrong, as exceptions: all of them are RuntimeError, with the message of the C++ class."""
from __future__ import annotations


class Error(RuntimeError):
    """Base of every error that the toolkit raises."""


class InputError(Error):
    """An input that can't be used: ``str()`` is one line that names the file, the field and the remedy."""

    file: str = ""
    field: str = ""
    problem: str = ""
    remedy: str = ""


class MissingFileError(InputError, FileNotFoundError):
    """A file that is not there, named in a call or in a case file; also Python's FileNotFoundError."""

    def __str__(self) -> str:
        return str(self.args[0])


class FilterError(Error):
    """A process object refuses or fails; the message names the value and what to do."""

    location: str = ""


class AbortedError(FilterError):
    """A run was ended by ``Abort()``."""


class ArgumentError(Error, ValueError):
    """A value that makes no sense; also a ValueError."""
