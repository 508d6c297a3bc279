# SPDX-License-Identifier: BSD-3-Clause
"""Names of element blocks in Exodus II files.

vtkExodusIIWriter calls all blocks of one grid alike. The names stand in a variable of fixed size of the file, which
is netCDF in its classic format (CDF-1 or CDF-2, "The NetCDF Classic Format Specification", Unidata); they are put
in place there. Files in another format stay as they are.
"""

import struct

_WIDTHS = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8}  # bytes of a value, by its type


class _Header:
    """Where variables begin, and how long their dimensions are."""

    def __init__(self, file):
        self._file = file
        magic = file.read(4)
        if magic not in (b"CDF\x01", b"CDF\x02"):
            raise ValueError("no classic netCDF")
        self._offset = ">q" if magic[3] == 2 else ">i"
        self._int()  # records
        self._tag()
        dimensions = [(self._name(), self._int())[1] for _ in range(self._count)]
        self._attributes()
        self.variables = {}
        self._tag()
        for _ in range(self._count):
            name = self._name()
            sizes = [dimensions[self._int()] for _ in range(self._int())]
            count, self._count = self._count, 0
            self._attributes()
            self._count = count
            self._int()  # type
            self._int()  # size
            (begin,) = struct.unpack(self._offset, file.read(struct.calcsize(self._offset)))
            self.variables[name] = begin, sizes

    def _int(self):
        return struct.unpack(">i", self._file.read(4))[0]

    def _tag(self):
        self._int()
        self._count = self._int()

    def _padded(self, length):
        return self._file.read(length + -length % 4)[:length]

    def _name(self):
        return self._padded(self._int()).decode()

    def _attributes(self):
        self._tag()
        for _ in range(self._count):
            self._name()
            width = _WIDTHS[self._int()]
            self._padded(width * self._int())


def put(path, names):
    """@param names: of element blocks by their ids; what is too long is cut."""
    with open(path, "r+b") as file:
        try:
            variables = _Header(file).variables
            (begin, (count, length)), (ids_begin, _) = variables["eb_names"], variables["eb_prop1"]
        except (ValueError, KeyError, struct.error):
            return
        file.seek(ids_begin)
        ids = struct.unpack(f">{count}i", file.read(4 * count))
        for place, number in enumerate(ids):
            if names.get(number):
                file.seek(begin + place * length)
                file.write(names[number].encode()[: length - 1].ljust(length, b"\0"))
