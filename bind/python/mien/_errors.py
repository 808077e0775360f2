"""What mien raises. Every class of it is one of `mien`: a traceback says mien.Error."""
from __future__ import annotations

import contextlib
import errno
import os
import pathlib
from typing import Any, Iterator, Optional, Union

Path = Union[str, "os.PathLike[str]"]


class Error(ValueError):
    """Why something failed: an address, `where`, and a sentence, `what`."""

    def __init__(self, where: str, what: str) -> None:
        super().__init__(f"{where}: {what}" if where else what)
        self.where = where
        self.what = what

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.where, self.what)


class Cancelled(Error):
    """A progress asked to stop."""


class FileError(Error, OSError):
    """A file that cannot be read or written: an OSError, too."""

    def __init__(self, where: str, what: str, number: Optional[int] = None, file: Optional[str] = None) -> None:
        super().__init__(where, what)
        self.filename = file
        if number:
            self.errno, self.strerror = number, os.strerror(number)

    def __str__(self) -> str:
        return f"{self.where}: {self.what}"

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.where, self.what, self.errno, self.filename)


class MissingFile(FileError, FileNotFoundError):
    """A file, or the folder of one to be written, that is not there."""


class ForbiddenFile(FileError, PermissionError):
    """A file that this user may not read or write."""


class Warned(UserWarning):
    """What was odd in a table, a plan or a motion, and did not stop the work: as Python warns, so `warnings` can make errors of it."""


for _one in (Error, Cancelled, FileError, MissingFile, ForbiddenFile, Warned):
    _one.__module__ = "mien"


def file_error(error: Error, cause: OSError, file: Path, more: str = "") -> FileError:
    """The error as one of files, of the kind that the system tells of."""
    kind = MissingFile if isinstance(cause, FileNotFoundError) else ForbiddenFile if isinstance(cause, PermissionError) else FileError
    return kind(error.where, error.what + more, cause.errno, os.fspath(file))


@contextlib.contextmanager
def reading(file: Path, hint: str = "") -> Iterator[None]:
    """What is wrong with a file itself, and not with what it says, is an OSError of its kind; `hint` follows where none is there."""
    try:
        yield
    except FileError:
        raise
    except OSError as cause:
        raise file_error(Error(os.fspath(file), f"cannot be read: {cause.strerror}"), cause, file) from None
    except Error as error:
        try:
            with open(file, "rb") as there:
                there.read(1)
        except OSError as cause:
            raise file_error(error, cause, file, hint * isinstance(cause, FileNotFoundError)) from None
        raise


@contextlib.contextmanager
def writing(file: Path) -> Iterator[None]:
    """The same of a file that is to be written: its folder is missing, or closed to this user, or it is a folder itself."""
    try:
        yield
    except (FileError, Cancelled):
        raise
    except OSError as cause:
        raise file_error(Error(os.fspath(file), f"cannot be written: {cause.strerror}"), cause, file) from None
    except Error as error:
        hindrance = _hindrance(pathlib.Path(file))
        if hindrance is None:
            raise
        raise file_error(error, hindrance, file) from None


def _hindrance(file: pathlib.Path) -> Optional[OSError]:
    try:
        os.stat(file.parent)
    except OSError as cause:
        return cause
    if file.is_dir():
        return IsADirectoryError(errno.EISDIR, "")
    if not os.access(file.parent, os.W_OK):
        return PermissionError(errno.EACCES, "")
    return None
