# SPDX-License-Identifier: BSD-3-Clause
"""A file that takes the place of an old one when it is complete, and not before."""

import contextlib
import os
import shutil
import stat

from ..errors import SweepError

# What must be free beyond the file once it is written: more than a library holds back at its end.
_SLACK = 1 << 16


class NewFiles:
    """Some files, each a NewFile, by what they are for."""

    def __init__(self, files):
        self.files = files
        self.paths = {use: file.path for use, file in files.items()}

    def put_in_place(self):
        """@throw SweepError."""
        for use, file in self.files.items():
            if use != "mesh":  # whoever wrote the mesh has done so
                file.make_sure()
            file.put_in_place()


@contextlib.contextmanager
def new_files(inputs, **names):
    """NewFiles for the names that are given, without one for others.
    @throw SweepError as NewFile, and where two would be the same file."""
    names = {use: name for use, name in names.items() if name}
    places = {}
    for name in names.values():
        other = places.setdefault(os.path.realpath(name), name)
        if other is not name:
            raise SweepError(f"{name}: is the same file as the output {other}. Name another one.")
    with contextlib.ExitStack() as stack:
        yield NewFiles(
            {use: stack.enter_context(NewFile(name, inputs)) for use, name in names.items()}
        )


class NewFile:
    """A file beside the one that it is to replace; leaves nothing where it was not put in place.

    @throw SweepError before any work where the output cannot be written or would be one of the inputs.
    """

    def __init__(self, name, inputs):
        self.name = name
        self._place = os.path.realpath(name)  # a link stays, what it points to is replaced
        self._mode = _mode_at(name, self._place, inputs)
        self.folder = os.path.dirname(self._place)
        self._folder_handle = None
        stem, extension = os.path.splitext(os.path.basename(self._place))
        # Known before it is there, so that an interrupt in between leaves nothing.
        self.path = os.path.join(self.folder, f".{stem[:100]}.{os.urandom(4).hex()}{extension}")

    def __enter__(self):
        try:
            # By this the file is found again where the folder is moved meanwhile.
            if os.unlink in os.supports_dir_fd:
                self._folder_handle = os.open(self.folder, os.O_RDONLY)
            os.close(os.open(self.path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600))
        except OSError as error:
            self.__exit__()
            why = f"{self.folder}: {error.strerror}"
            raise SweepError(f"{self.name}: cannot be written: {why}.") from None
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        with contextlib.suppress(OSError):  # it is in place, or a writer has removed it
            os.remove(self.path)
        if self._folder_handle is not None:
            with contextlib.suppress(OSError):
                os.unlink(os.path.basename(self.path), dir_fd=self._folder_handle)
            os.close(self._folder_handle)

    def is_begun(self):
        try:
            return os.path.getsize(self.path) > 0
        except OSError:
            return False

    def make_sure(self):
        """Brings the file to the disk. @throw SweepError where there is none or no room for it."""
        try:
            with open(self.path, "r+b") as file:
                size = os.fstat(file.fileno()).st_size
                # Fills holes that a library may have left where it met a full disk, and finds out
                # whether there is room for what it held back until the end.
                if hasattr(os, "posix_fallocate"):
                    os.posix_fallocate(file.fileno(), 0, size + _SLACK)
                    file.truncate(size)
                os.fsync(file.fileno())
        except OSError as error:
            raise self.failure(error.strerror) from None
        if size == 0:
            raise self.failure("the file is empty")

    def put_in_place(self):
        """@throw SweepError."""
        try:
            os.chmod(self.path, self._mode)
            os.replace(self.path, self._place)
            if self._folder_handle is not None:
                with contextlib.suppress(OSError):  # some file systems cannot
                    os.fsync(self._folder_handle)
        except OSError as error:
            raise self.failure(error.strerror) from None

    def failure(self, why):
        """@return a SweepError that tells what is left on the disk."""
        try:
            free = f" ({shutil.disk_usage(self.folder).free / 1e6:.1f} MB are free there)"
        except OSError:
            free = ""
        kept = " The old file is as it was." if os.path.lexists(self._place) else ""
        return SweepError(f"{self.name}: cannot be written: {why}{free}.{kept}")


def _mode_at(name, place, inputs):
    """Permissions for the new file. @throw SweepError where it must not or cannot go there."""
    try:
        old = os.stat(place)
    except FileNotFoundError:
        folder = os.path.dirname(place)
        if not os.path.isdir(folder):
            raise SweepError(f"{name}: cannot be written: the folder {folder} does not exist.") from None
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
    except OSError as error:
        raise SweepError(f"{name}: cannot be written: {error.strerror}.") from None
    if stat.S_ISDIR(old.st_mode):
        raise SweepError(f"{name}: is a folder. Name a file in it.")
    if not stat.S_ISREG(old.st_mode):
        raise SweepError(f"{name}: is no regular file, and would be replaced by one.")
    for other in inputs:
        if os.path.samestat(old, os.stat(other)):
            raise SweepError(f"{name}: is the same file as the input {other}. Name another one.")
    if not os.access(place, os.W_OK):
        raise SweepError(f"{name}: cannot be written: it is read-only.")
    return stat.S_IMODE(old.st_mode)
