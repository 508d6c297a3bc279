# SPDX-License-Identifier: BSD-3-Clause
"""ParaView macro "Sweep quality": how good the hexahedra of the active source are.

Macros > Import new macro, choose this file. It colours the mesh by scaled Jacobian, draws the histogram beside
it, shows what is below a threshold, and labels the worst ten hexahedra. Whatever has hexahedra will do: a mesh
that is not judged is judged first (Hex Validity).
"""

from paraview import simple

THRESHOLD = 0.2
WORST = 10
BINS = 20
ARRAY = "ScaledJacobian"

# Runs where the data are. Ten a rank, where there are several.
_IS_WORST = f"(np.argsort(np.argsort({ARRAY}, kind='stable')) < {WORST}) & np.isfinite({ARRAY})"


def judged(source):
    """The source itself, where its hexahedra are judged, else with a verdict."""
    source.UpdatePipeline()
    if source.CellData[ARRAY] and source.CellData["Validity"]:
        return source
    filters = {}
    simple._add_functions(filters)  # those of plugins, too, whenever these were loaded
    if "HexValidity" not in filters:
        raise RuntimeError("Sweep quality: the plugin HexSweep is not loaded. Load it in Tools > Manage Plugins.")
    judge = filters["HexValidity"](registrationName="HexValidity", Input=source)
    judge.UpdatePipeline()
    count = judge.FieldData["SweepReportHexes"]
    if not count or count.GetRange()[1] == 0:
        simple.Delete(judge)
        simple.SetActiveSource(source)
        raise RuntimeError("Sweep quality: the active source has no hexahedra to judge. Click on a mesh of hexahedra.")
    return judge


def show_mesh(mesh, view):
    display = simple.Show(mesh, view)
    display.Representation = "Surface With Edges"
    simple.ColorBy(display, ("CELLS", ARRAY))
    colors = simple.GetColorTransferFunction(ARRAY)
    colors.ApplyPreset("Viridis (matplotlib)", True)  # in that of ParaView the best are red
    colors.RescaleTransferFunction(0.0, 1.0)
    colors.UseBelowRangeColor, colors.BelowRangeColor = 1, [0.84, 0.10, 0.11]
    display.SetScalarBarVisibility(view, True)
    display.Opacity = 0.5  # the worst may be inside
    return display


def show_low(mesh, view):
    low = simple.Threshold(registrationName=f"below {THRESHOLD}", Input=mesh, Scalars=["CELLS", ARRAY])
    low.ThresholdMethod = "Below Lower Threshold"
    low.LowerThreshold = THRESHOLD
    low.UpdatePipeline()
    if low.GetDataInformation().GetNumberOfCells() > 0:
        simple.ColorBy(simple.Show(low, view), ("CELLS", ARRAY))
    return low


def show_worst(mesh, view):
    # No programmable filter: ParaView of Debian 13 ends when it is to show the panel of one.
    simple.QuerySelect(QueryString=_IS_WORST, FieldType="CELL", Source=mesh)
    cells = simple.ExtractSelection(registrationName=f"worst {WORST} cells", Input=mesh)
    simple.ClearSelection(mesh)
    worst = simple.CellCenters(registrationName=f"worst {WORST}", Input=cells, VertexCells=1)
    worst.UpdatePipeline()
    display = simple.Show(worst, view)
    display.Representation = "Points"
    display.PointSize = 8.0
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.84, 0.10, 0.11]
    display.SelectionPointLabelVisibility = 1
    display.SelectionPointFieldDataArrayName = ARRAY
    display.SelectionPointLabelFormat = "%.3f"
    display.SelectionPointLabelColor = [0.1, 0.1, 0.1]
    simple.QuerySelect(QueryString="id >= 0", FieldType="POINT", Source=worst)
    return worst


def show_histogram(mesh, view):
    bars = simple.Histogram(registrationName="histogram", Input=mesh, SelectInputArray=["CELLS", ARRAY])
    bars.BinCount = BINS
    bars.UseCustomBinRanges, bars.CustomBinRanges = 1, [0.0, 1.0]
    layout = simple.GetLayout(view)
    chart = simple.CreateView("XYBarChartView")
    left = layout.SplitViewHorizontal(view, 0.6)
    layout.AssignView(left + 1, chart)
    simple.Show(bars, chart, "XYBarChartRepresentation").SeriesVisibility = ["bin_values"]
    chart.ChartTitle = "hexahedra by scaled Jacobian"
    return bars


def main():
    source = simple.GetActiveSource()
    if source is None:
        raise RuntimeError("Sweep quality: no source is active. Click on a mesh of hexahedra in the Pipeline Browser.")
    view = simple.GetActiveViewOrCreate("RenderView")
    mesh = judged(source)
    simple.Hide(source, view)
    show_mesh(mesh, view)
    show_low(mesh, view)
    show_worst(mesh, view)
    show_histogram(mesh, view)
    simple.SetActiveView(view)  # else eyes and colours would be those of the chart
    simple.SetActiveSource(mesh)
    simple.RenderAllViews()


main()
