# SPDX-License-Identifier: BSD-3-Clause
"""Quality histograms of two meshes of one model in the same bins."""

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  (the 2D chart's device)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkRectf, vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView

COLOURS = [(228, 150, 60), (49, 104, 142)]


def draw_histogram(title, series, file_name, bin_width=0.05):
    """`series` is a list of (name, scaled Jacobians); the bars show the share of all hexes.

    All inverted hexes are in one bin left of zero, which is there even when it is empty.
    """
    shares = [_shares(values, bin_width) for _, values in series]
    names = [_legend(name, values) for name, values in series]
    chart = _chart(title, names, shares, COLOURS, np.max(shares), bin_width)
    _write([chart], (1400, 800), file_name)


def draw_histograms_beside(series, file_name, size=(1600, 520), bin_width=0.05):
    """A chart for each of `series`, side by side, with the same bins and the same scale."""
    shares = [_shares(values, bin_width) for _, values in series]
    charts = []
    width = size[0] / len(series)
    for place, (name, values) in enumerate(series):
        chart = _chart(
            "", [_legend(name, values)], shares[place : place + 1], COLOURS[place:],
            np.max(shares), bin_width,
        )
        chart.SetAutoSize(False)
        chart.SetSize(vtkRectf(place * width, 0, width, size[1]))
        charts.append(chart)
    _write(charts, size, file_name)


def _edges(bin_width):
    return np.arange(-1, round(1 / bin_width) + 1) * bin_width


def _shares(values, bin_width):
    binned = np.where(values > 0, np.minimum(values, 1.0), -0.5 * bin_width)
    counts, _ = np.histogram(binned, bins=_edges(bin_width))
    return 100.0 * counts / len(values)


def _chart(title, names, shares, colours, highest, bin_width):
    """Bars of one colour for each of `shares`, called by `names`, up to `highest` per cent."""
    edges = _edges(bin_width)
    table = vtkTable()
    _add_column(table, "centre", 0.5 * (edges[1:] + edges[:-1]))
    for name, column in zip(names, shares):
        _add_column(table, name, column)

    chart = vtkChartXY()
    chart.SetTitle(title)
    chart.GetTitleProperties().SetFontSize(30)
    chart.GetTitleProperties().SetBold(True)
    chart.SetBarWidthFraction(0.9)
    for column, colour in enumerate(colours[: len(names)], start=1):
        bars = chart.AddPlot(vtkChart.BAR)
        bars.SetInputData(table, 0, column)
        bars.SetColor(*colour, 255)
        bars.GetPen().SetColor(*colour, 255)

    _axis(chart.GetAxis(vtkAxis.BOTTOM), "Scaled Jacobian")
    bottom = chart.GetAxis(vtkAxis.BOTTOM)
    bottom.SetBehavior(vtkAxis.FIXED)
    bottom.SetRange(edges[0], edges[-1])
    _ticks(bottom, bin_width)
    _axis(chart.GetAxis(vtkAxis.LEFT), "Share of the hexes (%)")
    chart.GetAxis(vtkAxis.LEFT).SetBehavior(vtkAxis.FIXED)
    # Room for the legend above the bars.
    chart.GetAxis(vtkAxis.LEFT).SetRange(0.0, 1.2 * highest)
    chart.SetShowLegend(True)
    legend = chart.GetLegend()
    legend.SetHorizontalAlignment(vtkChartLegend.LEFT)
    legend.SetVerticalAlignment(vtkChartLegend.TOP)
    legend.SetLabelSize(22)
    legend.SetInline(True)
    legend.GetPen().SetLineType(0)
    return chart


def _write(charts, size, file_name):
    view = vtkContextView()
    view.GetRenderer().SetBackground(1, 1, 1)
    window = view.GetRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*size)
    window.SetMultiSamples(0)
    for chart in charts:
        view.GetScene().AddItem(chart)
    view.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(file_name)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def _legend(name, values):
    inverted = int((values <= 0).sum())
    return f"{name}: {inverted} inverted, min {values.min():.3f}, mean {values.mean():.3f}"


def _add_column(table, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
    array.SetName(name)
    table.AddColumn(array)


def _ticks(axis, bin_width):
    """A name below the bin of the inverted, then every tenth."""
    positions, labels = vtkDoubleArray(), vtkStringArray()
    for position in (-0.5 * bin_width, *np.arange(0.1, 1.01, 0.1)):
        positions.InsertNextValue(position)
        labels.InsertNextValue("inverted" if position < 0 else f"{position:.1f}")
    axis.SetCustomTickPositions(positions, labels)


def _axis(axis, title):
    axis.SetTitle(title)
    axis.GetTitleProperties().SetFontSize(24)
    axis.GetTitleProperties().SetBold(False)
    axis.GetLabelProperties().SetFontSize(20)
    axis.GetGridPen().SetColor(225, 225, 225, 255)
