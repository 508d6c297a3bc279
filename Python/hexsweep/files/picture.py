# SPDX-License-Identifier: BSD-3-Clause
"""A picture of hexahedra, cut open and coloured by scaled Jacobian."""

import os

from ..errors import SweepError
from ..process import Died, in_child
from .formats import extension_of

_SIZE = 1600, 1200
_INK = 0.1, 0.1, 0.1


def check(file_name):
    """@throw SweepError where no picture can be made: without a display VTK ends the process."""
    if extension_of(file_name) != ".png":
        raise SweepError(f"{file_name}: only .png pictures are written.")
    try:
        in_child(_render_nothing)
    except (Died, SweepError):
        raise SweepError(
            f"{file_name}: a picture needs a display or EGL, and there is none "
            "(set DISPLAY, call xvfb-run hexsweep, or leave --picture out)."
        ) from None


def draw(grid, path):
    """In a process of its own, as check(). @throw SweepError."""
    in_child(lambda: _draw(grid, path))


def _render_nothing():
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    window = _window(8, 8)
    window.Render()
    return True


def _draw(grid, path):
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter

    window = _window(*_SIZE)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    window.AddRenderer(renderer)
    mapper = _mapper(grid)
    renderer.AddActor(_actor(mapper))
    renderer.AddActor2D(_scale(mapper.GetLookupTable()))
    _look(renderer, grid)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode() != 0:
        raise SweepError(f"{path}: the picture cannot be written.")
    return True


def _window(width, height):
    """To be called first: what is made before these modules are there draws nothing."""
    import vtkmodules.vtkRenderingFreeType
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    return window


def _cut_normal(grid):
    """Across the second longest side of the box, so that the cut is long and the rest not flat."""
    bounds = grid.GetBounds()
    axis = sorted(range(3), key=lambda k: bounds[2 * k + 1] - bounds[2 * k])[1]
    return [-float(k == axis) for k in range(3)]


def _half(grid):
    """Whole hexahedra, those whose centre is behind the middle plane."""
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

    plane = vtkPlane()
    plane.SetOrigin(grid.GetCenter())
    plane.SetNormal(_cut_normal(grid))
    half = vtkExtractGeometry()
    half.SetInputData(grid)
    half.SetImplicitFunction(plane)
    half.ExtractInsideOff()
    half.ExtractBoundaryCellsOn()
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(half.GetOutputPort())
    return surface


def _mapper(grid):
    from vtkmodules.vtkCommonCore import vtkLookupTable
    from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

    table = vtkLookupTable()
    table.SetHueRange(0.0, 0.6)  # red to blue
    table.SetSaturationRange(0.75, 0.55)
    table.SetBelowRangeColor(0.55, 0.0, 0.35, 1.0)  # inverted
    table.UseBelowRangeColorOn()
    table.SetRange(0.0, 1.0)
    table.Build()
    mapper = vtkPolyDataMapper()
    half = _half(grid)
    mapper.SetInputConnection(half.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("ScaledJacobian")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    return mapper


def _actor(mapper):
    from vtkmodules.vtkRenderingCore import vtkActor

    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.2, 0.2, 0.2)
    look.SetAmbient(0.35)
    look.SetDiffuse(0.65)
    look.SetInterpolationToFlat()
    return actor


def _scale(table):
    from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

    scale = vtkScalarBarActor()
    scale.SetLookupTable(table)
    scale.SetTitle("Scaled Jacobian")
    scale.SetNumberOfLabels(6)
    scale.SetLabelFormat("%.1f")
    scale.SetUnconstrainedFontSize(True)
    scale.SetBarRatio(0.25)
    scale.SetPosition(0.86, 0.2)
    scale.SetPosition2(0.12, 0.6)
    for text in (scale.GetTitleTextProperty(), scale.GetLabelTextProperty()):
        text.SetColor(*_INK)
        text.SetFontSize(24)
        text.ShadowOff()
        text.ItalicOff()
        text.BoldOff()
    return scale


def _look(renderer, grid):
    """Onto the cut, from above and aside."""
    normal = _cut_normal(grid)
    axis = max(range(3), key=lambda k: abs(normal[k]))
    up = [float(k == (2 if axis != 2 else 1)) for k in range(3)]
    side = [float(k not in (axis, up.index(1.0))) for k in range(3)]
    middle = grid.GetCenter()
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(middle)
    camera.SetPosition(
        [m - n + 0.45 * u + 0.35 * s for m, n, u, s in zip(middle, normal, up, side)]
    )
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.Zoom(1.1)
    camera.SetWindowCenter(0.12, 0.0)  # beside the scale
