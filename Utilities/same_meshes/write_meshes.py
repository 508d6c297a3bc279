# SPDX-License-Identifier: BSD-3-Clause
"""Writes every mesh that HexSweep makes of Data as one .npz; run by Utilities/same-meshes.sh.

An .npz holds points, cells, all arrays of points, cells and field except times, and the warnings
and errors of the filter. A mesh that a filter refuses is one without cells.
"""

import argparse
import json
import os
import re
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(
    0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "demo")
)
from chain import read_case  # noqa: E402
from messages import messages_to  # noqa: E402

TIMES = {"SweepReportSeconds"}

# "(   1.2s) [thread] file.cxx:12  WARN| vtkClass (0x1234): text, perhaps of several lines"
_MESSAGE = re.compile(
    r"(WARN|ERR)\| +(vtk\w+) \(0x[0-9a-f]+\): *(.*?)(?=\n\( *[0-9.]+s\)|\Z)", re.S
)


def main():
    arguments = _parse()
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=vars(simple))
    os.makedirs(arguments.output)
    for name in sorted(os.listdir(os.path.join(arguments.data, "cases"))):
        sweep_case(
            os.path.join(arguments.data, "cases", name),
            Writer(os.path.join(arguments.output, "case_" + name)),
        )
    for name in sorted(os.listdir(os.path.join(arguments.data, "solids"))):
        sweep_solid(
            os.path.join(arguments.data, "solids", name),
            Writer(os.path.join(arguments.output, "solid_" + name)),
        )


def sweep_case(folder, writer):
    """The chain with default settings, and the filters that serve it, each alone."""
    case = read_case(folder)
    layers = _description(folder)["layers"]
    writer.write("disk_alone", [""], simple.HarmonicDiskMap(Input=case.source_surface))
    writer.write(
        "disk_with_partner",
        [""],
        simple.HarmonicDiskMap(
            Input=case.source_surface,
            Partner=case.target_surface,
            LinkingSides=case.linking_quads,
        ),
    )
    writer.write(
        "linking_sides",
        [""],
        simple.LinkingSideMesher(
            SourceQuads=case.source_quads,
            LinkingSurface=case.linking_quads,
            TargetSurface=case.target_surface,
            NumberOfLayers=layers,
        ),
    )
    target_quads = simple.SweepQuadProjector(
        SourceQuads=case.source_quads,
        TargetSurface=case.target_surface,
        LinkingSides=case.linking_quads,
        SourceSurface=case.source_surface,
    )
    writer.write("target", ["quads", "source_disk", "target_disk"], target_quads)
    hexes = simple.CageHexInterior(
        SourceQuads=case.source_quads,
        TargetQuads=target_quads,
        LinkingSides=case.linking_quads,
        GenerateTopologicalModel=1,
    )
    writer.write("interior", ["hexes", "topological_model"], hexes)


def sweep_solid(folder, writer):
    """From both ends, with the quads that lie beside the solid and with quads that are made."""
    description = _description(folder)
    solid, quads = (
        simple.XMLUnstructuredGridReader(FileName=[os.path.join(folder, name + ".vtu")])
        for name in ("solid", "source_quads")
    )
    source, target = description["source_face_ids"], description["target_face_ids"]
    size = description["quad_size"]
    ways = {
        "given": {"SourceQuads": quads, "SourceFaceIds": source, "TargetFaceIds": target},
        "made": {"SourceFaceIds": source, "QuadSize": size},
        "made_other_end": {"SourceFaceIds": target, "QuadSize": size},
    }
    for name, properties in ways.items():
        sweep = simple.OneToOneSweep(
            Solid=solid, NumberOfLayers=description["suggested_layers"], **properties
        )
        writer.write(name, ["hexes", "boundary"], sweep)


class Writer:
    """Runs filters and writes what comes out to files whose names begin alike."""

    def __init__(self, stem):
        self._stem = stem

    def write(self, name, outputs, proxy):
        """Writes one file an output; what several outputs are called follows the name."""
        log = f"{self._stem}_{name}.log"
        with messages_to(log, lambda line: None):
            proxy.UpdatePipeline()
        messages = _messages(log)
        os.remove(log)
        for port, output in enumerate(outputs):
            data = proxy.GetClientSideObject().GetOutputDataObject(port)
            file_name = "_".join(filter(None, [self._stem, name, output])) + ".npz"
            np.savez(file_name, **arrays_of(data), messages=np.array(messages))


def arrays_of(data):
    """All of a vtkUnstructuredGrid as a dictionary of numpy arrays."""
    count = data.GetNumberOfCells()
    arrays = {"cells/types": np.array([data.GetCellType(i) for i in range(count)], dtype=np.uint8)}
    if count:
        arrays["cells/offsets"] = vtk_to_numpy(data.GetCells().GetOffsetsArray())
        arrays["cells/connectivity"] = vtk_to_numpy(data.GetCells().GetConnectivityArray())
    if data.GetPoints():
        arrays["points"] = vtk_to_numpy(data.GetPoints().GetData())
    kinds = {
        "point": data.GetPointData(),
        "cell": data.GetCellData(),
        "field": data.GetFieldData(),
    }
    for kind, attributes in kinds.items():
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            if array.GetName() not in TIMES:
                arrays[f"{kind}/{array.GetName()}"] = _values(array)
    return arrays


def _values(array):
    if array.IsA("vtkStringArray"):
        return np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())], dtype=str)
    return vtk_to_numpy(array)


def _messages(log):
    """Each warning and error as one string, without what differs from run to run; those of the
    pipeline itself only repeat that a filter failed."""
    with open(log, encoding="utf-8") as file:
        found = _MESSAGE.findall(file.read())
    return [
        f"{kind} {name}: {text.strip()}"
        for kind, name, text in found
        if not name.endswith(("Executive", "Pipeline"))
    ]


def _description(folder):
    with open(os.path.join(folder, "case.json"), encoding="utf-8") as file:
        return json.load(file)


def _parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--plugin", required=True, help="HexSweep.so")
    parser.add_argument("--data", required=True, help="the folder with cases and solids")
    parser.add_argument("--output", required=True, help="where the files go; a new folder")
    return parser.parse_args()


if __name__ == "__main__":
    main()
