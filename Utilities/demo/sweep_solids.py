# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps CAD solids of Data/solids by the one filter OneToOneSweep; run by Utilities/demo.sh.

Each solid is swept with the quads that lie beside it, without any (they are made then), and from
its other end. Prints one table and writes <solid>.vtu (hexes), <solid>_boundary.vtu, a picture, and the
figures of all solids (solids.json), which Utilities/results.py takes into the documentation.
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
from result_tables import SOLIDS, record_table  # noqa: E402


def main():
    arguments = _parse()
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
    os.makedirs(arguments.output, exist_ok=True)
    records = []
    for folder in (os.path.join(arguments.data, name) for name in arguments.solids):
        print(os.path.basename(folder), flush=True)
        records.extend(sweep_solid(folder, arguments.output))
    with open(os.path.join(arguments.output, "solids.json"), "w", encoding="utf-8") as file:
        json.dump({"solids": records}, file, indent=1)
    print("\n" + record_table(SOLIDS, records))
    print(f"Meshes, figures and pictures: {arguments.output}")


def sweep_solid(folder, output):
    """Sweeps one solid three ways, writes the files of the first and returns their records."""
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
    records = []
    for number, (name, properties) in enumerate(ways):
        start = time.process_time()
        with messages_to(f"{stem}_{number}.log", lambda line: print("      ! " + line)):
            hexes = simple.OneToOneSweep(
                Solid=solid, NumberOfLayers=case["suggested_layers"], **properties
            )
            hexes.UpdatePipeline()
        seconds = time.process_time() - start
        records.append({"name": case["name"], "source_quads": name, **_figures(hexes, seconds)})
        if number == 0:
            # Debian's expat 2.5.0-1+deb12u2 cannot read the raw appended data that are the default.
            simple.SaveData(stem + ".vtu", proxy=hexes, DataMode="Binary")
            boundary = simple.OutputPort(hexes, 1)
            simple.SaveData(stem + "_boundary.vtu", proxy=boundary, DataMode="Binary")
            picture.draw_solid(solid, hexes, stem + ".png")
    return records


def _figures(hexes, seconds):
    data = fetch(hexes)
    count = data.GetNumberOfCells()
    layers = int(reported(data, "Layers"))
    quality = scaled_jacobians(hexes)
    return {
        "quads": count // layers,
        "layers": layers,
        "hexes": count,
        "inverted": int(reported(data, "Inverted") + reported(data, "Degenerate")),
        "not_certified": int(reported(data, "NotCertified")),
        "min_sj": round(float(quality.min()), 6),
        "floor_sj": round(reported(data, "FloorScaledJacobian"), 6),
        "mean_sj": round(float(quality.mean()), 6),
        "kept_edges": int(reported(data, "KeptEdges")),
        "seconds": round(seconds, 2),
    }


def _parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="HexSweep.so")
    parser.add_argument("--data", required=True, help="the folder of the solids")
    parser.add_argument("--output", required=True, help="where the results go")
    parser.add_argument("solids", nargs="+")
    return parser.parse_args()


if __name__ == "__main__":
    main()
