# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps one solid in ParaView's window, nothing typed; run by Utilities/screenshot.sh.

HEXSWEEP_CASE is the folder of the solid, or a CAD file; the file HEXSWEEP_READY is made when all is drawn.
"""

import os

from paraview import simple

folder = os.environ["HEXSWEEP_CASE"]
simple._DisableFirstRenderCameraReset()
if os.path.isdir(folder):
    solid = simple.XMLUnstructuredGridReader(
        registrationName="solid.vtu", FileName=[os.path.join(folder, "solid.vtu")]
    )
else:
    solid = simple.OpenDataFile(folder)
hexes = simple.OneToOneSweep(
    registrationName="OneToOneSweep",
    Solid=solid,
)
hexes.UpdatePipeline()
bounds = hexes.GetDataInformation().GetBounds()
centre = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))

view = simple.GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode = "Single Color"
view.Background = [1, 1, 1]
view.OrientationAxesLabelColor = [0.1, 0.1, 0.1]
display = simple.Show(hexes, view, "UnstructuredGridRepresentation")
display.Representation = "Surface With Edges"
display.EdgeColor = [0.25, 0.27, 0.30]
display.Ambient, display.Diffuse = 0.4, 0.6
simple.ColorBy(display, ("CELLS", "ScaledJacobian"))
table = simple.GetColorTransferFunction("ScaledJacobian")
table.ApplyPreset("Viridis (matplotlib)", True)
table.RescaleTransferFunction(0.0, 1.0)
table.UseBelowRangeColor, table.BelowRangeColor = 1, [0.84, 0.10, 0.11]
bar = simple.GetScalarBar(table, view)
bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
display.SetScalarBarVisibility(view, True)
simple.SetActiveSource(hexes)
view.CameraFocalPoint = centre
view.CameraPosition = [centre[0] + 0.7 * size, centre[1] - 2.2 * size, centre[2] + 1.3 * size]
view.CameraViewUp = [0, 0, 1]
view.ResetCamera()
simple.Render()
with open(os.environ["HEXSWEEP_READY"], "w", encoding="utf-8"):
    pass
