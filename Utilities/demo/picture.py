# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a swept mesh: its caps, and the mesh cut open and coloured by scaled Jacobian."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from arrays import points_of
from chain import fetch

INK = [0.1, 0.1, 0.1]
CAP = [0.86, 0.88, 0.91]
INVERTED = [0.84, 0.10, 0.11]
PANELS = [2000, 1760]
EDGE = [0.25, 0.27, 0.30]
FACES = [[0.55, 0.71, 0.85], [0.98, 0.75, 0.50], [0.66, 0.84, 0.60], [0.96, 0.65, 0.65],
         [0.79, 0.70, 0.87], [0.98, 0.90, 0.55], [0.60, 0.85, 0.82], [0.86, 0.80, 0.74]]


def draw_sweep(case, affine, harmonic, affine_inverted, harmonic_inverted, title, file_name):
    """Two rows of two: the source quads, both projections of them with inverted quads in red, and
    the hexes cut open.

    `affine` and `harmonic` are chain.Sweep, the `_inverted` a truth value for each target quad.
    """
    source = points_of(fetch(case.source_quads))
    target = points_of(fetch(harmonic.target_quads))
    frame = _Frame(source, target, points_of(fetch(harmonic.hexes)))

    simple._DisableFirstRenderCameraReset()
    layout = simple.CreateLayout(name=title)
    views = [_view() for _ in range(4)]
    # ParaView's layout is a binary tree: the children of cell i are 2i + 1 and 2i + 2.
    layout.SplitVertical(0, 0.5)
    layout.SplitHorizontal(1, 0.5)
    layout.SplitHorizontal(2, 0.5)
    for cell, view in enumerate(views, start=3):
        layout.AssignView(cell, view)
    layout.SetSize(*PANELS)
    for view in views:
        view.ViewSize = [PANELS[0] // 2, PANELS[1] // 2]

    counts = [int(affine_inverted.sum()), int(harmonic_inverted.sum())]
    none = np.zeros(fetch(case.source_quads).GetNumberOfCells(), dtype=bool)
    _draw_cap(views[0], case.source_quads, none, "Source quads", *frame.source_camera())
    _draw_cap(views[1], affine.target_quads, affine_inverted,
              f"Affine projection: {counts[0]} inverted", *frame.target_camera())
    _draw_cap(views[2], harmonic.target_quads, harmonic_inverted,
              f"HexSweep projection: {counts[1]} inverted", *frame.target_camera())
    draw_cut(views[3], harmonic.hexes, frame, "Hexes cut open")

    simple.SaveScreenshot(file_name, layout, ImageResolution=PANELS, SeparatorWidth=0)
    for view in views:
        simple.Delete(view)
    simple.RemoveLayout(layout)


def draw_hexes(case, sweep, file_name, size=(1600, 1000)):
    """The hexes cut open alone, large."""
    frame = _Frame(points_of(fetch(case.source_quads)), points_of(fetch(sweep.target_quads)),
                   points_of(fetch(sweep.hexes)))
    simple._DisableFirstRenderCameraReset()
    view = _view()
    view.ViewSize = list(size)
    draw_cut(view, sweep.hexes, frame, "")
    simple.SaveScreenshot(file_name, view, ImageResolution=list(size))
    simple.Delete(view)


def draw_solid(solid, hexes, file_name, size=(1800, 620)):
    """A tessellated solid with its faces in colours, and beside it its hexes, whole and cut open."""
    data = fetch(hexes)
    points = points_of(data)
    layer = vtk_to_numpy(data.GetPointData().GetArray("SweepLayer"))
    frame = _Frame(points[layer == 0], points[layer == layer.max()], points)
    frame.cut_lengthwise(points)
    simple._DisableFirstRenderCameraReset()
    layout = simple.CreateLayout(name=file_name)
    views = [_view() for _ in range(3)]
    layout.SplitHorizontal(0, 1.0 / 3.0)
    layout.SplitHorizontal(2, 0.5)
    for cell, view in zip((1, 5, 6), views):
        layout.AssignView(cell, view)
        view.ViewSize = [size[0] // 3, size[1]]
    layout.SetSize(*size)

    display = simple.Show(solid, views[0], "UnstructuredGridRepresentation")
    display.Representation = "Surface With Edges"
    display.EdgeColor = EDGE
    display.LineWidth = 0.4
    display.Ambient, display.Diffuse, display.Specular = 0.45, 0.6, 0.0
    simple.ColorBy(display, ("CELLS", "FaceId"), separate=True)
    table = simple.GetColorTransferFunction("FaceId", display, separate=True)
    ids = np.unique(vtk_to_numpy(fetch(solid).GetCellData().GetArray("FaceId")))
    table.RGBPoints = [
        value
        for i, number in enumerate(ids)
        for step in (-0.499, 0.499)
        for value in (number + step, *FACES[i % len(FACES)])
    ]
    table.ColorSpace = "RGB"
    display.SetScalarBarVisibility(views[0], False)
    _title(views[0], "The solid, its CAD faces in colours")
    _look(views[0], points_of(fetch(solid)), *frame.cut_camera(), room=(0.03, 0.12))
    _show_quality(hexes, views[1])
    _title(views[1], "Hexes")
    _look(views[1], points, *frame.cut_camera(), room=(0.17, 0.12))
    draw_cut(views[2], hexes, frame, "Hexes cut open")
    simple.SaveScreenshot(file_name, layout, ImageResolution=list(size), SeparatorWidth=0)
    for view in views:
        simple.Delete(view)
    simple.RemoveLayout(layout)


def draw_beside(case, sweeps, file_name, size=(1600, 760)):
    """Two meshes of one case cut open, side by side, with all that is inverted in front of the cut.

    `sweeps` are two pairs of a title and a chain.Sweep.
    """
    first = sweeps[0][1]
    frame = _Frame(points_of(fetch(case.source_quads)), points_of(fetch(first.target_quads)),
                   points_of(fetch(first.hexes)))
    simple._DisableFirstRenderCameraReset()
    layout = simple.CreateLayout(name=file_name)
    layout.SplitHorizontal(0, 0.5)
    views = [_view(), _view()]
    for cell, view in enumerate(views, start=1):
        layout.AssignView(cell, view)
    layout.SetSize(*size)
    seen = []
    for view, (title, sweep) in zip(views, sweeps):
        view.ViewSize = [size[0] // 2, size[1]]
        seen.append(draw_cut(view, sweep.hexes, frame, title))
        seen.append(_show_inverted(view, sweep.hexes))
    # One camera for both: the same hex is at the same place.
    for view in views:
        _look(view, np.concatenate(seen), *frame.cut_camera(), room=(0.19, 0.09))
    simple.SaveScreenshot(file_name, layout, ImageResolution=list(size), SeparatorWidth=0)
    for view in views:
        simple.Delete(view)
    simple.RemoveLayout(layout)


def _show_inverted(view, hexes):
    """All hexes that are inverted at a corner, in red; returns their points."""
    bad = simple.Threshold(Input=hexes, Scalars=["CELLS", "ScaledJacobian"])
    # Not above: there a 0 counts as not given.
    bad.LowerThreshold, bad.UpperThreshold = -2.0, 0.0
    bad.UpdatePipeline()
    if fetch(bad).GetNumberOfCells() == 0:
        return np.empty((0, 3))
    display = simple.Show(bad, view, "UnstructuredGridRepresentation")
    display.Representation = "Surface With Edges"
    simple.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = INVERTED
    display.EdgeColor = [0.45, 0.05, 0.06]
    display.LineWidth = 0.6
    return points_of(fetch(bad))


def draw_cut(view, hexes, frame, title):
    """Whole hexes on one side of a plane along the sweep, coloured by scaled Jacobian.

    Returns the points (n x 3) of the surface that is seen.
    """
    clip = simple.Clip(Input=hexes, ClipType="Plane", Crinkleclip=1)
    clip.ClipType.Origin = list(frame.centre)
    clip.ClipType.Normal = list(frame.cut_normal)
    clip.Invert = 1
    # The closed skin first: it is what can be seen, and its edges are the edges of whole hexes.
    skin = simple.ExtractSurface(Input=clip)
    _show_quality(skin, view)
    _title(view, title)
    points = _points_of_surface(skin)
    _look(view, points, *frame.cut_camera(), room=(0.17, 0.12 if title else 0.03))
    return points


def _show_quality(mesh, view):
    """The mesh in the colours of its scaled Jacobian, with a scale below it."""
    display = simple.Show(mesh, view)
    display.Representation = "Surface With Edges"
    display.EdgeColor = EDGE
    display.LineWidth = 0.6
    display.Ambient, display.Diffuse, display.Specular = 0.45, 0.6, 0.0
    simple.ColorBy(display, ("CELLS", "ScaledJacobian"), separate=True)
    table = simple.GetColorTransferFunction("ScaledJacobian", display, separate=True)
    table.ApplyPreset("Viridis (matplotlib)", True)
    table.RescaleTransferFunction(0.0, 1.0)
    table.UseBelowRangeColor = 1
    table.BelowRangeColor = INVERTED
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = "Scaled Jacobian (red: inverted)", ""
    bar.Orientation, bar.WindowLocation = "Horizontal", "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = [0.16, 0.03], 0.68, 18
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize, bar.LabelFontSize = 18, 16
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.2f", "%.1f"
    bar.DrawAnnotations = 0
    bar.UseCustomLabels, bar.CustomLabels = 1, [0.25, 0.5, 0.75]
    display.SetScalarBarVisibility(view, True)


def _draw_cap(view, quads, inverted, title, direction, up):
    # The verdict travels as a cell array of a copy; the chain's own data stay as they are.
    data = fetch(quads)
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    array = numpy_to_vtk(inverted.astype("uint8"), deep=True)
    array.SetName("Inverted")
    copy.GetCellData().AddArray(array)
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(copy)
    producer.UpdatePipeline()

    display = simple.Show(producer, view, "UnstructuredGridRepresentation")
    display.Representation = "Surface With Edges"
    display.EdgeColor = EDGE
    display.LineWidth = 0.8
    display.Ambient, display.Diffuse, display.Specular = 0.35, 0.65, 0.0
    simple.ColorBy(display, ("CELLS", "Inverted"), separate=True)
    table = simple.GetColorTransferFunction("Inverted", display, separate=True)
    table.RGBPoints = [0.0, *CAP, 0.499, *CAP, 0.501, *INVERTED, 1.0, *INVERTED]
    table.ColorSpace = "RGB"
    display.SetScalarBarVisibility(view, False)
    if inverted.any():
        _outline_inverted(view, producer)
    _title(view, title)
    _look(view, points_of(data), direction, up, room=(0.04, 0.12))


def _outline_inverted(view, quads):
    """Thick red edges: a quad turned inside out is often too thin for its own colour to show."""
    bad = simple.Threshold(
        Input=quads, Scalars=["CELLS", "Inverted"], LowerThreshold=1, UpperThreshold=1
    )
    display = simple.Show(bad, view, "UnstructuredGridRepresentation")
    display.Representation = "Wireframe"
    simple.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = INVERTED
    display.LineWidth = 3


def _points_of_surface(proxy):
    return vtk_to_numpy(fetch(proxy).GetPoints().GetData()).astype(float)


def _view():
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    return view


def _title(view, text):
    if not text:
        return
    display = simple.Show(simple.Text(Text=text), view)
    display.WindowLocation = "Upper Center"
    display.FontSize = 20
    display.Color = INK


def _look(view, points, direction, up, room):
    """A parallel view from `direction` that fits `points` (n x 3) between the text.

    `room` is the pair of fractions of the height, below and above, that are kept free.
    """
    forward = -_unit(np.asarray(direction))
    right = _unit(np.cross(forward, up))
    axes = np.array([right, np.cross(right, forward), forward])
    inside = points @ axes.T
    low, high = inside.min(axis=0), inside.max(axis=0)
    width, height = (high - low)[:2]
    aspect = view.ViewSize[0] / view.ViewSize[1]
    full = max(height / (1.0 - sum(room)), width / aspect / 0.94)
    middle = 0.5 * (low + high)
    middle[1] += 0.5 * (room[1] - room[0]) * full
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.5 * full
    view.CameraFocalPoint = list(middle @ axes)
    view.CameraPosition = list((middle - [0.0, 0.0, 2.0 * max(width, height)]) @ axes)
    view.CameraViewUp = list(axes[1])
    simple.Render(view)


class _Frame:
    """Directions to look from, taken from the mesh: no model is placed by hand."""

    def __init__(self, source, target, hexes):
        self.centre = 0.5 * (hexes.min(axis=0) + hexes.max(axis=0))
        self._source_centre, self._target_centre = source.mean(axis=0), target.mean(axis=0)
        sweep = self._target_centre - self._source_centre
        bend = hexes.mean(axis=0) - 0.5 * (self._target_centre + self._source_centre)
        self._source_normal = _plane_normal(source)
        self._target_normal = _plane_normal(target)
        normal = np.cross(sweep, bend)
        self.is_bent = np.linalg.norm(normal) > 0.02 * np.ptp(hexes, axis=0).max() ** 2
        if self.is_bent:
            # A bent sweep: cut it in the plane of its spine.
            self.cut_normal, self._cut_up = _unit(normal), _unit(bend)
        else:
            axis = _unit(sweep)
            self.cut_normal = _unit(np.cross(axis, _least_aligned(axis)))
            self._cut_up = axis
        # The affine map that carries the source's points to the target's turns the camera with
        # them, so that the same quad is found at the same place in both pictures.
        self._turn = np.linalg.lstsq(
            source - self._source_centre, target - self._target_centre, rcond=None
        )[0]

    def cut_lengthwise(self, points):
        """Lets the cut show as much as it can: its normal is where the mesh is thinnest."""
        if self.is_bent:
            return
        axis = self._cut_up
        across = points - points.mean(axis=0)
        across = across - np.outer(across @ axis, axis)
        self.cut_normal = _unit(np.linalg.svd(across, full_matrices=False)[2][1])
        if self.cut_normal @ np.ones(3) > 0:
            self.cut_normal = -self.cut_normal

    def target_camera(self):
        """Direction and up vector that show the target cap from outside the volume."""
        outward = self._target_normal * np.sign(
            self._target_normal @ (self._target_centre - self.centre) or 1.0
        )
        up = self._source_up() @ self._turn
        return outward, _unit(up - (up @ outward) * outward)

    def source_camera(self):
        """The same side of the quads: the source cap seen through the volume."""
        _, up = self.target_camera()
        side = self.target_camera()[0] @ _unit(
            np.cross(self._source_up() @ self._turn, self._source_right() @ self._turn)
        )
        front = np.cross(self._source_up(), self._source_right())
        return _unit(front) * np.sign(side or 1.0), self._source_up()

    def cut_camera(self):
        """Direction and up vector that look onto the cut, a little from above and aside."""
        right = np.cross(self._cut_up, self.cut_normal)
        return self.cut_normal + 0.45 * self._cut_up + 0.35 * right, self._cut_up

    def _source_up(self):
        up = _least_aligned(self._source_normal)
        return _unit(up - (up @ self._source_normal) * self._source_normal)

    def _source_right(self):
        return np.cross(self._source_up(), self._source_normal)


def _plane_normal(points):
    return np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][2]


def _least_aligned(direction):
    """The coordinate axis that is farthest from `direction`: y before x before z among equals."""
    order = [1, 0, 2]
    axis = min(order, key=lambda i: (round(abs(direction[i]), 6), order.index(i)))
    return np.eye(3)[axis]


def _unit(vector):
    return vector / np.linalg.norm(vector)
