# SPDX-License-Identifier: BSD-3-Clause
"""Runs each filter, and looks whether its page names all arrays that come out.

    TestGuideArrays.py SOURCE_DIR
"""

import json
import sys
from pathlib import Path

import hexsweep
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

ROOT = Path(sys.argv[1])
sys.path[:0] = [str(ROOT / "Utilities" / "guide"), str(ROOT / "Testing" / "Guide")]
import arrays  # noqa: E402
from check_guide import own_text  # noqa: E402

FLANGE = ROOT / "Data" / "solids" / "flange"
CASE = ROOT / "Data" / "cases" / "fig8_concave_twisted_hole"


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def names_of(data):
    """Of all arrays of a data object, whatever it consists of."""
    found = set()
    if isinstance(data, vtkCompositeDataSet):
        walk = data.NewIterator()
        while not walk.IsDoneWithTraversal():
            found |= names_of(walk.GetCurrentDataObject())
            walk.GoToNextItem()
    for kind in (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.FIELD, vtkDataObject.ROW):
        attributes = data.GetAttributesAsFieldData(kind)
        if attributes:
            found |= {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}
    return found


def of_outputs(algorithm):
    algorithm.Update()
    assert algorithm.GetErrorCode() == 0
    return set().union(*(names_of(algorithm.GetOutputDataObject(i)) for i in range(algorithm.GetNumberOfOutputPorts())))


def cad(name):
    reader = hexsweep.vtkCADReader()
    reader.SetFileName(str(ROOT / "Data" / "cad" / (name + ".step")))
    reader.Update()
    return reader


def swept(algorithm, solid, size):
    algorithm.SetSolidData(solid)
    algorithm.SetSize(size)
    return algorithm


def sides_of_flange():
    case = json.loads((FLANGE / "case.json").read_text(encoding="utf-8"))
    faces = [face for pair in case["loop_pairs"] for face in pair["linking_face_ids"]]
    caps = sorted(case["source_face_ids"] + case["target_face_ids"])
    assert caps == [2, 3] and sorted(faces) == [1, *range(4, 11)]
    threshold = vtkThreshold()
    threshold.SetInputData(read(FLANGE / "solid.vtu"))
    threshold.SetInputArrayToProcess(0, 0, 0, 1, "FaceId")
    threshold.SetLowerThreshold(2)
    threshold.SetUpperThreshold(3)
    threshold.InvertOn()
    threshold.Update()
    mesher = hexsweep.vtkLinkingSideMesher()
    mesher.SetSourceQuadsData(read(FLANGE / "source_quads.vtu"))
    mesher.SetLinkingSurfaceData(threshold.GetOutput())
    mesher.SetNumberOfLayers(4)
    return mesher


def projector(with_sides, method=0):
    algorithm = hexsweep.vtkSweepQuadProjector()
    algorithm.SetSourceQuadsData(read(CASE / "source_quads.vtu"))
    algorithm.SetTargetSurfaceData(read(CASE / "target_surface.vtu"))
    if with_sides:
        algorithm.SetLinkingSidesData(read(CASE / "linking_quads.vtu"))
    algorithm.SetMethod(method)
    return algorithm


def disk_map(partner):
    algorithm = hexsweep.vtkHarmonicDiskMap()
    algorithm.SetInputData(read(CASE / "source_surface.vtu"))
    if partner:
        algorithm.SetPartnerData(read(CASE / "target_surface.vtu"))
    algorithm.SetOutputDisk(True)
    return algorithm


def interior():
    far = projector(True)
    far.Update()
    algorithm = hexsweep.vtkCageHexInterior()
    algorithm.SetSourceQuadsData(read(CASE / "source_quads.vtu"))
    algorithm.SetTargetQuadsData(far.GetOutput())
    algorithm.SetLinkingSidesData(read(CASE / "linking_quads.vtu"))
    algorithm.SetGenerateTopologicalModel(True)
    return algorithm


def sets(sweep):
    algorithm = hexsweep.vtkSweepSets()
    algorithm.SetHexesConnection(sweep.GetOutputPort(0))
    algorithm.SetBoundaryConnection(sweep.GetOutputPort(1))
    return algorithm


def table(algorithm):
    algorithm.SetInputData(read(FLANGE / "solid.vtu"))
    return algorithm


def judged():
    algorithm = hexsweep.vtkHexValidity()
    algorithm.SetInputData(hexsweep.sweep(str(FLANGE / "solid.vtu"), size=6.0))
    return algorithm


def assembly():
    algorithm = hexsweep.vtkAssemblySweep()
    algorithm.SetInputDataObject(cad("tee_blocks").GetOutputDataObject(0))
    return algorithm


flange, block = read(FLANGE / "solid.vtu"), cad("named_block")
one = swept(hexsweep.vtkOneToOneSweep(), block.GetOutputDataObject(0), 0.3)
found = {
    "CADReader": of_outputs(block),
    "OneToOneSweep": of_outputs(one) | of_outputs(swept(hexsweep.vtkOneToOneSweep(), flange, 5.0)),
    "ManyToManySweep": of_outputs(
        swept(hexsweep.vtkManyToManySweep(), cad("counterbore_plate").GetOutputDataObject(0), 6.0)
    ),
    "AssemblySweep": of_outputs(assembly()),
    "SweepCandidates": of_outputs(table(hexsweep.vtkSweepCandidates())),
    "SolidFaces": of_outputs(table(hexsweep.vtkSolidFaces())),
    "HexValidity": of_outputs(judged()),
    "SweepSets": of_outputs(sets(one)),
    "HarmonicDiskMap": of_outputs(disk_map(False)) | of_outputs(disk_map(True)),
    "LinkingSideMesher": of_outputs(sides_of_flange()),
    "SweepQuadProjector": of_outputs(projector(True)) | of_outputs(projector(False)) | of_outputs(projector(True, 1)),
    "CageHexInterior": of_outputs(interior()),
}
# Filters that stand on others, or hand on what those put out: the pages of these tell of it.
STANDS_ON = {
    "SweepQuadProjector": ["HarmonicDiskMap"],
    "CageHexInterior": ["SweepQuadProjector", "HexValidity"],
    "OneToOneSweep": ["CADReader", "HexValidity", "LinkingSideMesher", "SweepQuadProjector"],
    "ManyToManySweep": ["OneToOneSweep"],
    "AssemblySweep": ["CADReader", "HexValidity"],
    "HexValidity": ["ManyToManySweep"],  # it judges the mesh of one
    "SweepSets": ["OneToOneSweep"],
}
TABLES = {"SweepCandidates", "SolidFaces"}


def page(name):
    return own_text((ROOT / "Documentation" / "guide" / "filters" / f"{name}.md").read_text(encoding="utf-8"))


def told_by(name):
    """The filter, and all that it stands on."""
    seen, left = [], [name]
    while left:
        seen.append(left.pop())
        left += [other for other in STANDS_ON.get(seen[-1], ()) if other not in seen]
    return seen


known = arrays.names(ROOT)
problems = []
for name, names in found.items():
    assert names, name
    text = "".join(page(one) for one in told_by(name))
    public = names if name in TABLES else names & known
    problems += [f"{name}.md: does not name {array}" for array in sorted(public) if f"`{array}`" not in text]
print("\n".join(problems))
sys.exit(1 if problems else 0)
