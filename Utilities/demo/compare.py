# SPDX-License-Identifier: BSD-3-Clause
"""Compares methods on all cases of Data/cases; run by `Utilities/demo.sh --compare`.

Prints one table: the affine method and HexSweep's Blend as they come, HexSweep as it is by default.
Then three pictures, affine beside HexSweep with a histogram below each: caps that are not parallel,
a curved trajectory, a growing hole. The figures go to compare.json, which Utilities/results.py takes
into the documentation.
"""

import argparse
import json
import os
import sys

from paraview import simple
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import chain  # noqa: E402
import histogram  # noqa: E402
import picture  # noqa: E402
from messages import messages_to  # noqa: E402
from result_tables import CASES, record_table  # noqa: E402

# Its linking sides collapse half way: there to be refused.
REFUSED = "bad_rings"

# Picture, case, degrees by which the case is bent.
PICTURES = [
    ("non_parallel_caps", "c_open", 60.0),
    ("curved_trajectory", "hole_twist120", 150.0),
    ("growing_hole", "fig7_growing_hole", 0.0),
]


def main():
    arguments = _parse()
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
    os.makedirs(arguments.output, exist_ok=True)
    names = sorted(os.listdir(arguments.data))
    records = [
        _record(os.path.join(arguments.data, name), arguments.output)
        for name in names
        if name != REFUSED and os.path.isdir(os.path.join(arguments.data, name))
    ]
    print("\n" + record_table(CASES, records))
    pictures = {}
    for name, model, degrees in PICTURES:
        case = chain.read_case(os.path.join(arguments.data, model))
        bent = chain.bent(case, degrees) if degrees else case
        pictures[name] = draw(name, bent, arguments.output)
    with open(os.path.join(arguments.output, "compare.json"), "w", encoding="utf-8") as file:
        json.dump({"cases": records, "pictures": pictures}, file, indent=1)
    print(f"Figures and pictures: {arguments.output}")


def _record(folder, output):
    case = chain.read_case(folder)
    print(f"    {case.name}", flush=True)
    stem = os.path.join(output, "compare_" + case.name)
    affine, harmonic = _both(case, stem)
    with messages_to(stem + "_raw.log", _ignore):
        raw = chain.sweep_harmonic(case, _ignore, raw=True)
    with messages_to(stem + "_blend.log", _ignore):
        blend = chain.sweep_blend(case, harmonic.target_quads, _ignore)
    report = chain.fetch(harmonic.hexes)
    return {
        "name": case.name,
        "hexes": report.GetNumberOfCells(),
        "inverted_quads_affine": chain.inverted_quads(affine),
        "inverted_quads_raw": chain.inverted_quads(raw),
        "inverted_quads": chain.inverted_quads(harmonic),
        "inverted_affine": chain.inverted_hexes(affine),
        "inverted_raw": chain.inverted_hexes(raw),
        "inverted_blend": chain.inverted_hexes(blend),
        "inverted": chain.inverted_hexes(harmonic),
        "not_certified": chain.uncertified_hexes(harmonic),
        "min_sj": round(chain.reported(report, "MinScaledJacobian"), 6),
        "floor_sj": round(chain.reported(report, "FloorScaledJacobian"), 6),
        "mean_sj": round(chain.reported(report, "MeanScaledJacobian"), 6),
        "seconds": round(harmonic.total_seconds, 2),
        "method": chain.reported(report, "Method"),
    }


def draw(name, case, output):
    """Writes <output>/<name>.png and returns the counts in its caption."""
    stem = os.path.join(output, name)
    affine, harmonic = _both(case, stem)
    picture.draw_beside(
        case, [(_title("Affine", affine), affine), (_title("HexSweep", harmonic), harmonic)],
        stem + "_cut.png",
    )
    histogram.draw_histograms_beside(
        [("affine", chain.scaled_jacobians(affine.hexes)),
         ("HexSweep", chain.scaled_jacobians(harmonic.hexes))],
        stem + "_histogram.png",
    )
    _stack([stem + "_histogram.png", stem + "_cut.png"], stem + ".png")
    print(f"    {name}.png", flush=True)
    return {
        "hexes": chain.fetch(harmonic.hexes).GetNumberOfCells(),
        "inverted_affine": chain.inverted_hexes(affine),
        "inverted": chain.inverted_hexes(harmonic),
    }


def _both(case, stem):
    with messages_to(stem + "_affine.log", _ignore):
        affine = chain.sweep_affine(case, _ignore)
    with messages_to(stem + ".log", _warn):
        harmonic = chain.sweep_harmonic(case, _ignore)
    return affine, harmonic


def _title(method, sweep):
    count = chain.fetch(sweep.hexes).GetNumberOfCells()
    inverted = chain.inverted_hexes(sweep)
    certified = "" if chain.uncertified_hexes(sweep) else ", all certified"
    return f"{method}: {inverted} of {count} hexes inverted{certified}"


def _stack(file_names, file_name):
    """Pictures of one width below each other, from the bottom up; the parts are removed."""
    append = vtkImageAppend()
    append.SetAppendAxis(1)
    for name in file_names:
        reader = vtkPNGReader()
        reader.SetFileName(name)
        append.AddInputConnection(reader.GetOutputPort())
    writer = vtkPNGWriter()
    writer.SetFileName(file_name)
    writer.SetInputConnection(append.GetOutputPort())
    writer.Write()
    for name in file_names:
        os.remove(name)


def _ignore(*_):
    pass


def _warn(line):
    print(f"      ! {line}", flush=True)


def _parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="HexSweep.so")
    parser.add_argument("--data", required=True, help="the folder of the cases")
    parser.add_argument("--output", required=True, help="where the results go")
    return parser.parse_args()


if __name__ == "__main__":
    main()
