# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps models of Data/cases through the chained HexSweep filters; run by Utilities/demo.sh.

Each model is swept twice: by the usual affine method (raw, for comparison) and by HexSweep.
Prints one table and writes for each model <model>.vtu, three pictures (<model>.png, _cut.png and
_histogram.png) and what the filters warned about (<model>.log, _affine.log). What is inverted is
counted in the table, not hidden; it does not make the run fail.
"""

import argparse
import os
import sys
import time

from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import chain  # noqa: E402
import histogram  # noqa: E402
import picture  # noqa: E402
from messages import messages_to  # noqa: E402
from tables import text_table  # noqa: E402

COLUMNS = [
    ("model", "<"),
    ("hexes", ">"),
    ("quads inverted affine", ">"),
    ("quads inverted ours", ">"),
    ("hexes inverted affine", ">"),
    ("hexes inverted ours", ">"),
    ("not certified ours", ">"),
    ("min SJ", ">"),
    ("mean SJ", ">"),
    ("CPU seconds", ">"),
    ("Mhex/s", ">"),
]


def main():
    arguments = _parse()
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
    os.makedirs(arguments.output, exist_ok=True)
    rows = []
    for number, folder in enumerate(_folders(arguments.data, arguments.models), start=1):
        print(f"[{number}/{len(arguments.models)}] {os.path.basename(folder)}", flush=True)
        rows.append(sweep_model(folder, arguments.output))
    table = text_table(COLUMNS, rows)
    with open(os.path.join(arguments.output, "table.txt"), "w", encoding="utf-8") as file:
        file.write(table)
    print("\n" + table)
    print(f"Meshes, pictures, histograms: {arguments.output}")


def sweep_model(folder, output):
    """Sweeps one model both ways, writes its files and returns its table row."""
    case = chain.read_case(folder)
    stem = os.path.join(output, case.name)

    print(f"    affine, for comparison ({case.name}_affine.log)", flush=True)
    with messages_to(stem + "_affine.log", _message):
        affine = chain.sweep_affine(case, _progress)
    print(f"    HexSweep ({case.name}.log)", flush=True)
    with messages_to(stem + ".log", _message):
        harmonic = chain.sweep_harmonic(case, _progress)

    inverted = {
        "affine": chain.scaled_jacobians(affine.target_quads) <= 0,
        "ours": chain.scaled_jacobians(harmonic.target_quads) <= 0,
    }
    sj = {
        "affine": chain.scaled_jacobians(affine.hexes),
        "ours": chain.scaled_jacobians(harmonic.hexes),
    }

    start = time.perf_counter()
    # Debian's expat 2.5.0-1+deb12u2 cannot read the raw appended data that are the default.
    simple.SaveData(stem + ".vtu", proxy=harmonic.hexes, DataMode="Binary")
    histogram.draw_histogram(
        case.name, [("affine", sj["affine"]), ("HexSweep", sj["ours"])], stem + "_histogram.png"
    )
    picture.draw_sweep(
        case, affine, harmonic, inverted["affine"], inverted["ours"], case.name, stem + ".png"
    )
    picture.draw_hexes(case, harmonic, stem + "_cut.png")
    _progress("mesh, picture, histogram", time.perf_counter() - start)

    count = len(sj["ours"])
    return [
        case.name,
        str(count),
        str(chain.inverted_quads(affine)),
        str(chain.inverted_quads(harmonic)),
        str(chain.inverted_hexes(affine)),
        str(chain.inverted_hexes(harmonic)),
        str(chain.uncertified_hexes(harmonic)),
        f"{sj['ours'].min():.3f}",
        f"{sj['ours'].mean():.3f}",
        f"{harmonic.total_seconds:.2f}",
        f"{count / harmonic.total_seconds / 1e6:.3f}",
    ]


def _progress(stage, seconds):
    print(f"      {stage:<26} {seconds:8.2f} s", flush=True)


def _message(line):
    print(f"      ! {line}", flush=True)


def _folders(data, models):
    """The folder of each model; a model may be the beginning of a folder's name."""
    names = sorted(name for name in os.listdir(data) if os.path.isdir(os.path.join(data, name)))
    for model in models:
        found = [name for name in names if name == model] or [
            name for name in names if name.startswith(model)
        ]
        if len(found) != 1:
            sys.exit(f"model '{model}' names {len(found)} of: {', '.join(names)}")
        yield os.path.join(data, found[0])


def _parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="HexSweep.so")
    parser.add_argument("--data", required=True, help="the folder of the cases")
    parser.add_argument("--output", required=True, help="where the results go")
    parser.add_argument("models", nargs="+")
    return parser.parse_args()


if __name__ == "__main__":
    main()
