# SPDX-License-Identifier: BSD-3-Clause
"""The mesh into a file, by VTK's writers, whose word is not taken for it."""

from .. import vtkSweepAbaqusWriter, vtkSweepGmshWriter, vtkSweepSets
from ..errors import SweepError
from ..vtk_messages import library_messages
from . import checking, exodus_names
from .formats import ABAQUS, EXODUS, GMSH, MESHIO, WRITTEN, check_meshio, extension_of

_MOST_INT32 = 1 << 31


class Choices:
    """What can be chosen of a file beside its format."""

    def __init__(self, role_sets=True, set_ids=(), msh_version="4.1", binary=False):
        """@param set_ids: pairs of a set's name and its id."""
        self.role_sets, self.set_ids = role_sets, set_ids
        self.msh_version, self.binary = msh_version, binary


def check(file_name, choices):
    """@throw SweepError where such a file cannot be written here."""
    extension = extension_of(file_name)
    if extension not in WRITTEN:
        raise SweepError(f"{file_name}: only {', '.join(WRITTEN)} files are written.")
    if extension in MESHIO:
        check_meshio(file_name)
    if choices.set_ids and extension in (".vtu", ".vtk"):
        raise SweepError(f"{file_name}: has no sets, whose ids --set could choose.")


def write(sweep, new, choices, messages):
    """@param new: NewFile. @param choices: Choices. @param messages: VtkMessages.
    @return the sets as vtkSweepSets gives them, nothing where the format has none.
    @throw SweepError where it went wrong."""
    extension = extension_of(new.path)
    source, writer, difference_of = _writer_for(extension, sweep, choices)
    writer.SetFileName(new.path)
    with messages.errors_collected() as errors, library_messages(errors):
        done = writer.Write()
        if done and extension in EXODUS and not errors:
            exodus_names.put(new.path, _volume_names(source.GetOutputDataObject(0)))
    if new.is_begun() or not errors:
        new.make_sure()
    if errors or not done or writer.GetErrorCode() != 0:
        told = [error.replace(f"{new.path} cannot be written: ", "") for error in errors]
        raise new.failure(f"the writer failed{_first(told)}")
    with messages.errors_collected(warnings_too=True) as errors, library_messages(errors):
        difference = difference_of(new.path, source.GetOutputDataObject(0))
    if errors or difference:
        raise new.failure(f"the file that was written {difference or 'is damaged'}{_first(errors)}")
    return source.GetOutputDataObject(0) if source is not sweep else None


def _volume_names(sets):
    """By id; nothing where volumes have no names."""
    names = sets.GetFieldData().GetAbstractArray("VolumeNames")
    if names:
        return {number: names.GetValue(number) for number in range(names.GetNumberOfValues())}
    name = sets.GetFieldData().GetAbstractArray("VolumeName")
    return {1: name.GetValue(0)} if name else {}


def _first(errors):
    return ": " + " ".join(errors[0].split()).rstrip(".") if errors else ""


def _writer_for(extension, sweep, choices):
    """@return the algorithm whose output is written, the writer, and a function of path and that
    output that says how the file differs from it."""
    if extension == ".vtu":
        return sweep, _xml_writer(sweep), lambda path, _: checking.xml_damage(path)
    if extension == ".vtk":
        return sweep, _legacy_writer(sweep), checking.legacy_difference
    sets = vtkSweepSets()
    sets.SetHexesConnection(sweep.GetOutputPort(0))
    sets.SetBoundaryConnection(sweep.GetOutputPort(1))
    sets.SetRoleSets(choices.role_sets)
    for name, number in choices.set_ids:
        sets.AddSetId(name, number)
    sets.Update()
    if sets.GetErrorCode() != 0:
        raise SweepError()  # it has said why
    if extension in MESHIO:
        from . import meshio_files

        return sets, _MeshioWriter(sets, meshio_files.write), meshio_files.difference
    if extension in EXODUS:
        writer, difference_of = _exodus_writer(), checking.exodus_difference
    elif extension in ABAQUS:
        writer, difference_of = vtkSweepAbaqusWriter(), lambda path, _: checking.text_damage(path)
    elif extension in GMSH:
        writer, difference_of = _gmsh_writer(choices)
    writer.SetInputConnection(sets.GetOutputPort())
    return sets, writer, difference_of


def _gmsh_writer(choices):
    writer = vtkSweepGmshWriter()
    writer.SetFileVersion(22 if choices.msh_version == "2.2" else 41)
    writer.SetBinary(choices.binary)
    return writer, lambda path, _: checking.gmsh_damage(path, choices.binary)


class _MeshioWriter:
    """meshio in the form of a VTK writer."""

    def __init__(self, sets, write_file):
        self._sets, self._write, self._path = sets, write_file, None

    def SetFileName(self, path):
        self._path = path

    def Write(self):
        try:
            self._write(self._sets.GetOutputDataObject(0), self._path)
        except Exception as error:
            why = str(error) or type(error).__name__
            raise SweepError(f"meshio cannot write such a file: {why}.") from None
        return 1

    def GetErrorCode(self):
        return 0


def _exodus_writer():
    try:
        from vtkmodules.vtkIOExodus import vtkExodusIIWriter
    except ImportError:
        raise SweepError("this VTK has no Exodus II writer; write a .vtu file.") from None
    writer = vtkExodusIIWriter()
    # It takes ids from the names of blocks, and writes the names with the ids in them. Once it has
    # made a table of names it modifies itself, before any name is written.
    writer.AddObserver("ModifiedEvent", _leave_out_ids)
    return writer


def _leave_out_ids(writer, _event):
    """Of the names of sets, but for those of faces that have no other name."""
    metadata = writer.GetModelMetadata()
    for names in (metadata.GetSideSetNames(), metadata.GetNodeSetNames()) if metadata else ():
        for i in range(names.GetNumberOfValues() if names else 0):
            name, mark, _ = names.GetValue(i).rpartition(" ID:")
            if mark and name not in ("Face", "Face nodes"):
                names.SetValue(i, name)


def _legacy_writer(sweep):
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter

    writer = vtkUnstructuredGridWriter()
    writer.SetInputConnection(sweep.GetOutputPort(0))
    writer.SetFileTypeToBinary()
    return writer


def _xml_writer(sweep):
    from .. import vtkHexGridWriter

    grid = sweep.GetOutputDataObject(0)
    writer = vtkHexGridWriter()
    writer.SetInputConnection(sweep.GetOutputPort(0))
    # Of what every reader of Debian 12 and 13 accepts, the fastest: see Documentation/Results.md.
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToLZ4()
    writer.SetCompressionLevel(9)
    if grid.GetCells().GetNumberOfConnectivityIds() < _MOST_INT32:
        writer.SetIdTypeToInt32()
    return writer
