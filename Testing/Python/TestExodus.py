# SPDX-License-Identifier: BSD-3-Clause
"""A swept flange goes to an Exodus file with its block and sets, and comes back as it was.

Truth: what vtkExodusIIReader reads, for it takes the nodes of sides from the Exodus library; areas
from the flange's own triangles.
"""

import os

import numpy as np
from chain_testing import (
    DATA_DIR,
    OUTPUT_DIR,
    chain,
    check,
    faces_of,
    finish,
    points_of,
    simple,
)
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOExodus import vtkExodusIIReader

# vtkExodusIIReader gives points in single precision, whatever the file holds.
AS_READ = np.float32

SOURCE_FACE, TARGET_FACE, LAYERS, VOLUME = 3, 2, 6, 17
FILE = os.path.join(OUTPUT_DIR, "flange.ex2")


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def areas(points, faces):
    """Of triangles, or of quads as two triangles."""
    corners = points[faces]
    total = np.zeros(len(faces))
    for i in range(1, faces.shape[1] - 1):
        a, b = corners[:, i] - corners[:, 0], corners[:, i + 1] - corners[:, 0]
        total += np.linalg.norm(np.cross(a, b), axis=1) / 2
    return total


def read_back():
    """The hexahedra, and side sets and node sets by name."""
    reader = vtkExodusIIReader()
    reader.SetFileName(FILE)
    reader.UpdateInformation()
    kinds = (reader.ELEM_BLOCK, reader.SIDE_SET, reader.NODE_SET)
    ids = {}
    for kind in kinds:
        reader.SetAllArrayStatus(kind, 1)
        for i in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, i, 1)
            ids[kind, reader.GetObjectName(kind, i)] = reader.GetObjectId(kind, i)
    reader.GenerateGlobalNodeIdArrayOn()
    reader.GenerateGlobalElementIdArrayOn()
    reader.Update()
    found = {kind: {} for kind in kinds}
    output = reader.GetOutput()
    for kind, block in zip(kinds, (0, 4, 7)):
        sets = output.GetBlock(block)
        for i in range(sets.GetNumberOfBlocks()):
            name = sets.GetMetaData(i).Get(output.NAME())
            found[kind][name] = sets.GetBlock(i)
    return [found[kind] for kind in kinds], ids, kinds


def nodes_of(data):
    """Zero-based number in the file of each point: the reader renumbers them."""
    return vtk_to_numpy(data.GetPointData().GetArray("GlobalNodeId")) - 1


def rows_in_order(rows):
    return rows[np.lexsort(rows.T)]


def same_rows(a, b):
    return a.shape == b.shape and np.array_equal(rows_in_order(a), rows_in_order(b))


def quads_turned(points, faces):
    """Corner coordinates, 12 a quad, each quad from its lexicographically least corner on."""
    result = []
    for quad in points[faces]:
        least = min(range(4), key=lambda c: tuple(quad[c]))
        result.append(np.roll(quad, -least, axis=0).ravel())
    return np.array(result)


solid = simple.XMLUnstructuredGridReader(
    FileName=[os.path.join(DATA_DIR, "solids", "flange", "solid.vtu")]
)
numbered = simple.PythonCalculator(
    Input=solid, ArrayAssociation="Cell Data", ArrayName="VolumeId", Expression=f"0*FaceId+{VOLUME}"
)
quads = simple.XMLUnstructuredGridReader(
    FileName=[os.path.join(DATA_DIR, "solids", "flange", "source_quads.vtu")]
)
sweep = simple.OneToOneSweep(
    Solid=numbered, SourceQuads=quads, SourceFaceIds=[SOURCE_FACE], TargetFaceIds=[TARGET_FACE],
    NumberOfLayers=LAYERS,
)
sets = simple.SweepSets(Hexes=sweep, Boundary=simple.OutputPort(sweep, 1))
simple.SaveData(FILE, proxy=sets)

hexes = chain.fetch(sweep)
boundary = servermanager.Fetch(sweep, idx=1)
(blocks, side_sets, node_sets), ids, (_, side_kind, node_kind) = read_back()

# One block.
check(list(blocks) == [f"Volume {VOLUME}"], f"the blocks are {list(blocks)}")
block = blocks[f"Volume {VOLUME}"]
check(set(cell_array(block, "ObjectId")) == {VOLUME}, "the block's id is that of the volume")
nodes = nodes_of(block)
check(np.array_equal(np.sort(nodes), np.arange(hexes.GetNumberOfPoints())), "nodes of the block")
hex_points = points_of(hexes).astype(AS_READ)
check(np.array_equal(points_of(block), hex_points[nodes]), "coordinates of the block")
elements = cell_array(block, "GlobalElementId") - 1
check(
    np.array_equal(np.sort(elements), np.arange(hexes.GetNumberOfCells())), "elements of the block"
)
check(
    np.array_equal(nodes[faces_of(block)], faces_of(hexes)[elements]), "hexahedra of the block"
)
check(
    np.array_equal(
        cell_array(block, "ScaledJacobian"), cell_array(hexes, "ScaledJacobian")[elements]
    ),
    "cell data of the block",
)

# Side sets and node sets of each face, and of the parts.
triangles = chain.fetch(solid)
face_areas = areas(points_of(triangles), faces_of(triangles))
face_ids = cell_array(triangles, "FaceId")
boundary_ids, parts = cell_array(boundary, "BoundaryId"), cell_array(boundary, "BoundaryPart")
of_boundary = {f"Face ID:{face}": boundary_ids == face for face in np.unique(face_ids)}
of_boundary.update(Source=parts == 0, Target=parts == 1, Sides=parts == 2)
of_solid = {f"Face ID:{face}": face_ids == face for face in np.unique(face_ids)}
of_solid.update(Source=face_ids == SOURCE_FACE, Target=face_ids == TARGET_FACE)
of_solid["Sides"] = ~(of_solid["Source"] | of_solid["Target"])
check(set(side_sets) == set(of_boundary), f"side sets are {list(side_sets)}")
# The flange has faces 1 to 10, so that the ids of node sets are those of side sets and a hundred.
NODES = 100


def nodes_name(name):
    face = name.split(":")
    return f"Face nodes ID:{int(face[1]) + NODES}" if len(face) > 1 else name + " nodes"


check(
    set(node_sets) == {nodes_name(name) for name in of_boundary}, f"node sets are {list(node_sets)}"
)
points, faces = points_of(boundary).astype(AS_READ), faces_of(boundary)
for name, mask in of_boundary.items():
    side_set, node_set = side_sets[name], node_sets[nodes_name(name)]
    expected = face_areas[of_solid[name]].sum()
    area = areas(points_of(side_set), faces_of(side_set)).sum()
    check(abs(area / expected - 1) < 0.02, f"{name}: area {area}, of the solid {expected}")
    check(
        np.array_equal(
            rows_in_order(quads_turned(points_of(side_set), faces_of(side_set))),
            rows_in_order(quads_turned(points, faces[mask])),
        ),
        f"{name}: the sides are the boundary's quads, facing outward",
    )
    check(
        same_rows(points_of(node_set), points[np.unique(faces[mask])]),
        f"{name}: the nodes are those of the boundary's quads",
    )
    check(
        np.array_equal(hex_points[nodes_of(node_set)], points_of(node_set)),
        f"{name}: the nodes are those of the hexahedra",
    )
    side_id, node_id = ids[side_kind, name], ids[node_kind, nodes_name(name)]
    check(node_id == side_id + NODES, f"{name}: ids {side_id} and {node_id}")
    if name.startswith("Face"):
        check(side_id == int(name.split(":")[1]), f"{name}: id {side_id}")
names = [name for kind, name in ids if kind in (side_kind, node_kind)]
numbers = [number for (kind, _), number in ids.items() if kind in (side_kind, node_kind)]
for values in (names, numbers):
    check(
        len(set(values)) == len(values) == 2 * len(of_boundary), f"no two sets share any of {values}"
    )

# ParaView opens the file with another reader, which keeps double precision.
opened = simple.OpenDataFile(FILE)
opened.UpdatePipeline()
collection = opened.GetClientSideObject().GetOutputDataObject(0)
names = {  # in lower case, without spaces
    collection.GetMetaData(i).Get(collection.NAME()): i
    for i in range(collection.GetNumberOfPartitionedDataSets())
}
expected = {
    name.lower().replace(" ", "_") for face in of_boundary for name in (face, nodes_name(face))
}
check(expected <= set(names), f"ParaView shows {sorted(names)}")
in_paraview = collection.GetPartition(names[f"volume_{VOLUME}"], 0)
check(same_rows(points_of(in_paraview), points_of(hexes)), "coordinates in double precision")
check(same_rows(faces_of(in_paraview), faces_of(hexes)), "hexahedra in ParaView")
finish()
