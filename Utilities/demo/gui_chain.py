# SPDX-License-Identifier: BSD-3-Clause
"""Builds the chain on one case in ParaView's window; run by Utilities/screenshot.sh.

HEXSWEEP_CASE is the folder of the case; the file HEXSWEEP_READY is made when all is drawn.
"""

import os

from paraview import simple

case = os.environ["HEXSWEEP_CASE"]


def read(name):
    return simple.XMLUnstructuredGridReader(
        registrationName=name + ".vtu", FileName=[os.path.join(case, name + ".vtu")]
    )


simple._DisableFirstRenderCameraReset()
source_quads, linking = read("source_quads"), read("linking_quads")
source_surface, target_surface = read("source_surface"), read("target_surface")
source_disk = simple.HarmonicDiskMap(
    registrationName="HarmonicDiskMap (source)",
    Input=source_surface, Partner=target_surface, LinkingSides=linking,
)
target_disk = simple.HarmonicDiskMap(
    registrationName="HarmonicDiskMap (target)",
    Input=target_surface, Partner=source_surface, LinkingSides=linking,
)
target_quads = simple.SweepQuadProjector(
    registrationName="SweepQuadProjector",
    SourceQuads=source_quads, TargetSurface=target_disk, LinkingSides=linking,
    SourceSurface=source_disk,
)
target_quads.DiskMaps = "FromInput"
interior = simple.CageHexInterior(
    registrationName="CageHexInterior",
    SourceQuads=source_quads, TargetQuads=target_quads, LinkingSides=linking,
)
verdict = simple.HexValidity(registrationName="HexValidity", Input=interior)
clip = simple.Clip(registrationName="Clip", Input=verdict, ClipType="Plane", Crinkleclip=1)
verdict.UpdatePipeline()
bounds = verdict.GetDataInformation().GetBounds()
centre = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
clip.ClipType.Origin = centre
clip.ClipType.Normal = [0, -1, 0]

view = simple.GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode = "Single Color"
view.Background = [1, 1, 1]
view.OrientationAxesLabelColor = [0.1, 0.1, 0.1]
display = simple.Show(clip, view, "UnstructuredGridRepresentation")
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
simple.SetActiveSource(interior)
simple.HideInteractiveWidgets(proxy=clip.ClipType)
view.CameraFocalPoint = centre
view.CameraPosition = [centre[0] + 0.7 * size, centre[1] - 2.2 * size, centre[2] + 1.3 * size]
view.CameraViewUp = [0, 0, 1]
view.ResetCamera()
simple.Render()
with open(os.environ["HEXSWEEP_READY"], "w", encoding="utf-8"):
    pass
