# SPDX-License-Identifier: BSD-3-Clause
"""The whole job in one call, for scripts; the command line is the same job."""

import os
import types
import warnings

from .errors import SweepError, SweepWarning

# The other modules of the package are loaded by the calls: whoever wants the filters alone waits for none.
_FILES = ("output", "json", "picture", "plan")


def sweep(
    solid, *, size=None, layers=None, layer_size=None, source=None, target=None, volume=None, quads=None,
    quad_size=None, growth=None, both_ends=False, positions=None, direction=None, draft=None,
    imprint_tolerance=None, separate=False, plan=None, faces=None, feature_angle=None, tolerance=None,
    method=None, precision=None, threads=None, output=None, set_ids=None, role_sets=True, msh_version="4.1",
    binary=False, json=None, picture=None, boundary=False, progress=None,
):
    """Meshes a solid with hexahedra, and returns them as a vtkUnstructuredGrid.

        mesh = hexsweep.sweep("part.step", size=2.0)

    One body is swept between two caps, or between several along one direction; bodies that touch get
    one mesh that fits node for node. What is not named is found or chosen.

    What to mesh:
        solid:    name of a file (.step, .iges, .brep, .stl, .vtk, .vtu, .vtp, ...), or a VTK data set:
                  the closed surface of a solid, a volume mesh, or a collection of solids
        volume:   ids of the bodies to mesh (all)
        separate: mesh bodies that touch each by itself

    How fine:
        size:       edge length of the hexahedra (chosen: at most a quarter of a million)
        layers:     number of layers, or
        layer_size: their thickness, or
        positions:  where they meet, rising shares of the way in (0, 1)
        growth:     thickness of a layer over the last one's
        both_ends:  let layers grow from both caps
        quad_size:  edge length of the quads on the source cap

    Where to sweep, by ids of faces (`hexsweep faces FILE` lists them):
        source, target: the caps, one id or several (found)
        quads:          file or data set with the quads of the source cap (made)
        direction:      (x, y, z) of a sweep between several caps (found)
        draft:          degrees that sides may lean then
        imprint_tolerance: distance over size up to which curves of caps are one then
        plan:           bodies that touch: JSON file with the caps and layers of each; it is written, or
                        read and obeyed where it is there

    How the input is read:
        faces:         cell array of face ids (FaceId, then CellEntityIds, then by angle)
        feature_angle: without face ids: degrees between two faces (30)
        tolerance:     distance over edge length up to which points are one (1e-6)

    How it runs:
        method:    how the inside is filled, for comparison: automatic, blend, layer-march, ...
        precision: of coordinates, "double" or "single"
        threads:   how many, for this process from now on; the mesh is the same
        progress:  called with the fraction that is done

    What is written, beside what is returned; each file only once it is complete:
        output:      the mesh (.vtu, .vtk, .ex2, .exo, .e, .inp, .msh, ...)
        set_ids:     {"Inlet": 12}: ids of sets of nodes and sides, in place of their faces'
        role_sets:   whether there are sets Source, Target and Sides
        msh_version: "4.1" or "2.2"
        binary:      whether a .msh file has its numbers in binary
        json:        the whole report, for programs
        picture:     a .png of the hexahedra, cut open; needs a display or EGL

    What is returned:
        boundary: True: the pair of the hexahedra and of their outer quads, which have the face ids of the
                  solid (`BoundaryId`); False: the hexahedra alone

    The cell arrays `Validity` (0: proved valid at every point)
    and `ScaledJacobian` judge each hexahedron, the field data `SweepReport...` tell what was done.
    numpy sees the arrays without a copy:

        from vtkmodules.util.numpy_support import vtk_to_numpy
        points = vtk_to_numpy(mesh.GetPoints().GetData())                              # n x 3
        corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)  # m x 8
        quality = vtk_to_numpy(mesh.GetCellData().GetArray("ScaledJacobian"))          # m

    Raises SweepError where there is no mesh: the message says what is wrong, where, and how to mend it.
    Warns (SweepWarning) where some hexahedra are not certified, or input was mended.
    """
    from .files import picture as pictures
    from .sweeps import job

    options = types.SimpleNamespace(
        solid=_file_or_data(solid, "solid"), quads=_file_or_data(quads, "quads"),
        size=size, layers=layers, layer_size=layer_size, growth=growth, quad_size=quad_size,
        feature_angle=feature_angle, draft=draft, imprint_tolerance=imprint_tolerance, tolerance=tolerance,
        source=_numbers(source, "source", int), target=_numbers(target, "target", int),
        volumes=_numbers(volume, "volume", int), positions=_numbers(positions, "positions", float),
        direction=_numbers(direction, "direction", float), both_ends=both_ends, separate=separate,
        faces=faces, method=method, precision=precision, threads=_number(threads, "threads", int),
        plan=plan, output=output, json=json, picture=picture, set_ids=set_ids or {},
        role_sets=role_sets, msh_version=msh_version, binary=binary,
    )
    _normalize(options)

    def work(messages, tell):
        choices = job.check(options)
        with job.outputs(options) as new:
            if options.picture:
                pictures.check(options.picture)
            mesh = job.run(options, choices, new, messages, _followed_by(progress), tell)
            new.put_in_place()
        return mesh

    mesh = _heard(work)
    return (mesh.hexes, mesh.boundary) if boundary else mesh.hexes


def check(mesh, *, progress=None):
    """Judges the hexahedra of a mesh, whoever made it, and returns their Quality.

        quality = hexsweep.check(mesh)
        print(quality)                       # numbers, and a table by scaled Jacobian
        assert quality.certified             # every hexahedron is proved valid at every point

    mesh:     a VTK data set, or the name of a file (.vtu, .vtk, Exodus II; .inp, .msh and others where
              meshio is installed)
    progress: called with the fraction that is done

    Raises SweepError where nothing can be judged; warns (SweepWarning) of hexahedra that are not valid,
    with the places of the first ten.
    """
    from .files import mesh_reading
    from .sweeps.quality import judge

    mesh = _file_or_data(mesh, "mesh")

    def work(messages, _tell):
        if isinstance(mesh, str):
            mesh_reading.check(mesh)
            grid, others = mesh_reading.read_mesh(mesh, messages)
        else:
            grid, others = mesh, mesh_reading.other_solid_cells(mesh, "the mesh")
        return judge(grid, others, _followed_by(progress))

    return _heard(work)


def _heard(work):
    """What `work` returns, called with VtkMessages and a function that takes warnings.
    @throw SweepError that of `work`, or with what filters said."""
    from .sweeps.settings import as_keywords
    from .vtk_messages import VtkMessages

    said = {"error": [], "warning": []}

    def tell(kind, words):
        said[kind].append(words)

    try:
        with VtkMessages(tell) as messages:
            result = work(messages, tell)
    except SweepError as error:
        raise SweepError(as_keywords(str(error) or " ".join(said["error"]))) from None
    for words in said["warning"]:
        warnings.warn(words, SweepWarning, stacklevel=3)
    return result


def _followed_by(progress):
    def follow(algorithm):
        if progress:
            algorithm.AddObserver("ProgressEvent", lambda *_: progress(algorithm.GetProgress()))
        return algorithm

    return follow


def _file_or_data(value, keyword):
    """@return the name of a file as text, or a data object. @throw SweepError."""
    if value is None and keyword == "quads":
        return None
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if not (hasattr(value, "IsA") and value.IsA("vtkDataObject")):
        raise SweepError(f"{keyword}: give the name of a file or a VTK data set, not {value!r:.60}.")
    return value


def _normalize(options):
    """Brings what was given into the types of the command line. @throw SweepError."""
    from .sweeps import settings

    for keyword, _, kind, _ in settings.SETTINGS:
        setattr(options, keyword, _number(getattr(options, keyword), keyword, kind))
    for name in _FILES:
        path = getattr(options, name)
        setattr(options, name, os.fspath(path) if path is not None else None)
    _one_of(options.method, "method", settings.METHODS)
    _one_of(options.precision, "precision", settings.PRECISIONS)
    _one_of(options.msh_version, "msh_version", ("2.2", "4.1"))
    options.set_ids = [
        (name, _number(number, f"set_ids[{name!r}]", int)) for name, number in options.set_ids.items()
    ]
    if options.direction and len(options.direction) != 3:
        raise SweepError(f"direction: give three numbers, not {len(options.direction)}.")
    options.settings = settings.of_filter(options)


def _one_of(value, keyword, known):
    if value is not None and value not in known:
        raise SweepError(f"{keyword}: {value!r} is none of {', '.join(known)}.")


def _numbers(values, keyword, kind):
    """@param values: one number, several, or none."""
    if values is None:
        return []
    if not hasattr(values, "__iter__") or isinstance(values, str):
        values = [values]
    return [_number(value, keyword, kind) for value in values]


def _number(value, keyword, kind):
    """@throw SweepError where it is no number of that kind; 6.0 is whole."""
    if value is None:
        return None
    try:
        number = kind(value)
        if number == value:
            return number
    except (TypeError, ValueError, OverflowError):
        pass
    raise SweepError(f"{keyword}: {value!r:.60} is no {'whole ' if kind is int else ''}number.")
