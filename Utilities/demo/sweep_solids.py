# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps CAD solids of Data/solids by the one filter OneToOneSweep; run by Utilities/demo.sh.

Each solid is swept with the quads that lie beside it, without any (they are made then), and from
its other end. Prints one table and writes <solid>.vtu (hexes), <solid>_boundary.vtu and a picture.
"""

import argparse
import json
import os
import sys
import time

from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import picture  # noqa: E402
from chain import fetch, reported, scaled_jacobians  # noqa: E402
from messages import messages_to  # noqa: E402
from tables import text_table  # noqa: E402

COLUMNS = [
    ("solid", "<"),
    ("source quads", "<"),
    ("quads", ">"),
    ("layers", ">"),
    ("hexes", ">"),
    ("inverted", ">"),
    ("not certified", ">"),
    ("min SJ", ">"),
    ("floor SJ", ">"),
    ("mean SJ", ">"),
    ("CAD edges", ">"),
    ("seconds", ">"),
]


def main():
    arguments = _parse()
    simple.LoadPlugin(arguments.plugin, remote=False, ns=vars(simple))
    os.makedirs(arguments.output, exist_ok=True)
    rows = []
    for folder in (os.path.join(arguments.data, name) for name in arguments.solids):
        print(os.path.basename(folder), flush=True)
        rows.extend(sweep_solid(folder, arguments.output))
    table = text_table(COLUMNS, rows)
    with open(os.path.join(arguments.output, "solids.txt"), "w", encoding="utf-8") as file:
        file.write(table)
    print("\n" + table)
    print(f"Meshes and pictures: {arguments.output}")


def sweep_solid(folder, output):
    """Sweeps one solid three ways, writes the files of the first and returns the table's rows."""
    with open(os.path.join(folder, "case.json"), encoding="utf-8") as file:
        case = json.load(file)
    solid, quads = (
        simple.XMLUnstructuredGridReader(FileName=[os.path.join(folder, name + ".vtu")])
        for name in ("solid", "source_quads")
    )
    for reader in (solid, quads):
        reader.UpdatePipeline()
    source, target = case["source_face_ids"], case["target_face_ids"]
    ways = [
        ("given", {"SourceQuads": quads, "SourceFaceIds": source, "TargetFaceIds": target}),
        ("made", {"SourceFaceIds": source, "QuadSize": case["quad_size"]}),
        ("made, other end", {"SourceFaceIds": target, "QuadSize": case["quad_size"]}),
    ]
    stem = os.path.join(output, case["name"])
    rows = []
    for number, (name, properties) in enumerate(ways):
        start = time.perf_counter()
        with messages_to(f"{stem}_{number}.log", lambda line: print("      ! " + line)):
            hexes = simple.OneToOneSweep(
                Solid=solid, NumberOfLayers=case["suggested_layers"], **properties
            )
            hexes.UpdatePipeline()
        rows.append([case["name"], name] + _figures(hexes, time.perf_counter() - start))
        if number == 0:
            # Debian's expat 2.5.0-1+deb12u2 cannot read the raw appended data that are the default.
            simple.SaveData(stem + ".vtu", proxy=hexes, DataMode="Binary")
            boundary = simple.OutputPort(hexes, 1)
            simple.SaveData(stem + "_boundary.vtu", proxy=boundary, DataMode="Binary")
            picture.draw_solid(solid, hexes, stem + ".png")
    return rows


def _figures(hexes, seconds):
    data = fetch(hexes)
    count = data.GetNumberOfCells()
    layers = int(reported(data, "Layers"))
    quality = scaled_jacobians(hexes)
    return [
        str(count // layers),
        str(layers),
        str(count),
        str(int(reported(data, "Inverted") + reported(data, "Degenerate"))),
        str(int(reported(data, "NotCertified"))),
        f"{quality.min():.3f}",
        f"{reported(data, 'FloorScaledJacobian'):.3f}",
        f"{quality.mean():.3f}",
        str(int(reported(data, "KeptEdges"))),
        f"{seconds:.2f}",
    ]


def _parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="HexSweep.so")
    parser.add_argument("--data", required=True, help="the folder of the solids")
    parser.add_argument("--output", required=True, help="where the results go")
    parser.add_argument("solids", nargs="+")
    return parser.parse_args()


if __name__ == "__main__":
    main()
