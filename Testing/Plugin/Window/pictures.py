# SPDX-License-Identifier: BSD-3-Clause
"""Compares what ParaView's view shows with a picture in Data/Baseline."""

import os

from hands import Stumbled, say
from paraview import simple
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = [500, 400]
ALLOWED = 100.0  # smoothed edges; another number of layers gives five times as much


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def bare(view):
    """Without what differs between versions of ParaView: colours behind, axes, legends."""
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    for representation in view.Representations:
        if representation.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation":
            representation.Visibility = 0
        elif hasattr(representation, "EdgeColor"):
            representation.EdgeColor = [0.1, 0.1, 0.1]


def expect_picture(view, name):
    """Of the view alone, and in a size of its own: neither the window nor its manager counts."""
    bare(view)
    made = os.path.join(os.environ["HEXSWEEP_TEST_OUTPUT_DIR"], name + ".png")
    simple.SaveScreenshot(made, view, ImageResolution=SIZE)
    wanted = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "Baseline", name + ".png")
    if not os.path.exists(wanted):
        raise Stumbled(f"there is no {wanted}; if it is right, copy {made}")
    difference = vtkImageDifference()
    difference.SetInputData(read(made))
    difference.SetImageData(read(wanted))
    difference.Update()
    error = difference.GetThresholdedError()
    say(f"{name}: {error:.1f} of {ALLOWED} allowed")
    if error > ALLOWED:
        raise Stumbled(f"{made} is not {wanted}: {error:.1f}")
