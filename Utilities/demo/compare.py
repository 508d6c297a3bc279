# SPDX-License-Identifier: BSD-3-Clause
"""Compares methods on all cases of Data/cases; run by `Utilities/demo.sh --compare`.

Prints and writes one table (compare.txt): the affine method and HexSweep's Blend as they come,
HexSweep as it is by default. Then three pictures, affine beside HexSweep with a histogram below
each: caps that are not parallel, a curved trajectory, a growing hole.
"""

import argparse
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
from tables import text_table  # noqa: E402

COLUMNS = [
    ("case", "<"),
    ("hexes", ">"),
    ("inverted affine", ">"),
    ("inverted Blend", ">"),
    ("inverted ours", ">"),
    ("not certified ours", ">"),
    ("min SJ", ">"),
    ("floor SJ", ">"),
    ("mean SJ", ">"),
    ("seconds", ">"),
    ("what ran", "<"),
]

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
    simple.LoadPlugin(arguments.plugin, remote=False, ns=vars(simple))
    os.makedirs(arguments.output, exist_ok=True)
    names = sorted(os.listdir(arguments.data))
    rows = [
        _row(os.path.join(arguments.data, name), arguments.output)
        for name in names
        if name != REFUSED and os.path.isdir(os.path.join(arguments.data, name))
    ]
    table = text_table(COLUMNS, rows)
    with open(os.path.join(arguments.output, "compare.txt"), "w", encoding="utf-8") as file:
        file.write(table)
    print("\n" + table)
    for name, model, degrees in PICTURES:
        case = chain.read_case(os.path.join(arguments.data, model))
        draw(name, chain.bent(case, degrees) if degrees else case, arguments.output)
    print(f"Table and pictures: {arguments.output}")


def _row(folder, output):
    case = chain.read_case(folder)
    print(f"    {case.name}", flush=True)
    affine, harmonic = _both(case, os.path.join(output, "compare_" + case.name))
    with messages_to(os.path.join(output, "compare_" + case.name + "_blend.log"), _ignore):
        blend = chain.sweep_blend(case, harmonic.target_quads, _ignore)
    report = chain.fetch(harmonic.hexes)
    return [
        case.name,
        str(report.GetNumberOfCells()),
        str(chain.inverted_hexes(affine)),
        str(chain.inverted_hexes(blend)),
        str(chain.inverted_hexes(harmonic)),
        str(chain.uncertified_hexes(harmonic)),
        f"{chain.reported(report, 'MinScaledJacobian'):.3f}",
        f"{chain.reported(report, 'FloorScaledJacobian'):.3f}",
        f"{chain.reported(report, 'MeanScaledJacobian'):.3f}",
        f"{harmonic.total_seconds:.2f}",
        chain.reported(report, "Method"),
    ]


def draw(name, case, output):
    """Writes <output>/<name>.png."""
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
