# SPDX-License-Identifier: BSD-3-Clause
"""64 blocks that touch, on one rank and on two: the same mesh, bit for bit; a bad block is named.

Run by pvpython it starts mpirun on itself; run by pvbatch (the argument `ranks`) it is the body. No
rendering: only data.
"""

import os
import pickle
import subprocess
import sys
import tempfile
import time

BLOCKS = 4
SIZE = 0.2


def start():
    with tempfile.TemporaryDirectory() as folder:
        one, _ = run(folder, 1)
        two, told = run(folder, 2)
        assert len(one) == 1 and len(two) == 2
        whole = merged(one)
        assert merged(two) == whole, "two ranks make another mesh than one"
        assert all(part["cells"] for part in two), "a rank has nothing"
        assert "Warning" not in told and "WARN" not in told, told
        print(f"CPU of one rank {one[0]['seconds']:.2f} s, of two", *(f"{part['seconds']:.2f}" for part in two))
        bad, told = run(folder, 2, "bad")
        assert {cell[0] for cell in merged(bad)[1].values()} == set(range(1, BLOCKS**3 + 1)) - {22}
        assert told.count("volume 22 has no hexahedra") == 1, told


def run(folder, ranks, *words):
    """@return what each rank has, and what they printed."""
    command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks),
               "--mca", "btl_vader_single_copy_mechanism", "none",
               "pvbatch", "--symmetric", "--force-offscreen-rendering", os.path.abspath(__file__), "ranks", folder, *words]
    # pvpython has begun MPI for itself: what it left in the environment would make mpirun take its
    # own ranks for children of that run.
    environment = {
        name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "ORTE_", "OPAL_"))
    }
    environment["VTK_SMP_MAX_THREADS"] = "1"
    done = subprocess.run(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=200, check=False,
    )
    assert done.returncode == 0, f"mpirun pvbatch ended with {done.returncode}: {done.stdout}"
    parts = []
    for rank in range(ranks):
        path = os.path.join(folder, str(rank))
        with open(path, "rb") as file:
            parts.append(pickle.load(file))
        os.remove(path)
    return parts, done.stdout


def merged(parts):
    """Places by global id, and cells by global id; what two ranks have must be the same."""
    points, cells = {}, {}
    for part in parts:
        for number, place in part["points"].items():
            assert points.setdefault(number, place) == place, f"node {number} is in two places"
        assert not cells.keys() & part["cells"].keys(), "a hexahedron is on two ranks"
        cells.update(part["cells"])
    return points, cells


def lattice(with_bad):
    """The surfaces of the blocks; number 22, inside, may be a tetrahedron by itself."""
    from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPartitionedDataSetCollection, vtkPolyData

    corners = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
    numbers = {}
    collection = vtkPartitionedDataSetCollection()
    for cell in range(BLOCKS**3):
        x, y, z = cell % BLOCKS, cell // BLOCKS % BLOCKS, cell // BLOCKS**2
        places = [(x + (i & 1), y + (i >> 1 & 1), 0.8 * (z + (i >> 2))) for i in range(8)]
        triangles, faces = [], []
        for face, (a, b, c, d) in enumerate(corners):
            node = [x, y, z]
            node[face // 2] += face % 2
            number = numbers.setdefault((face // 2, *node), len(numbers) + 1)
            triangles += [(a, b, c), (a, c, d)]
            faces += [number, number]
        if with_bad and cell == 21:
            middle = [sum(place[k] for place in places) / 8 for k in range(3)]
            places = [[middle[k] + 0.2 * (i == k + 1) for k in range(3)] for i in range(4)]
            triangles, faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)], [1001, 1002, 1003, 1004]
        data, points, polys, ids = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkIdTypeArray()
        points.SetDataTypeToDouble()
        ids.SetName("FaceId")
        for place in places:
            points.InsertNextPoint(place)
        for triangle, face in zip(triangles, faces):
            polys.InsertNextCell(3, triangle)
            ids.InsertNextValue(face)
        data.SetPoints(points)
        data.SetPolys(polys)
        data.GetCellData().AddArray(ids)
        collection.SetPartition(cell, 0, data)
    return collection


def body(folder, with_bad):
    from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    import hexsweep

    rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
    sweep = hexsweep.vtkAssemblySweep()
    sweep.SetInputDataObject(lattice(with_bad) if rank == 0 else vtkPartitionedDataSetCollection())
    sweep.SetSize(SIZE)
    begin = time.process_time()
    sweep.Update()
    part = {"seconds": time.process_time() - begin, "points": {}, "cells": {}}
    volumes = sweep.GetOutput()
    assert volumes.GetNumberOfPartitionedDataSets() == BLOCKS**3
    for volume in range(BLOCKS**3):
        if volumes.GetNumberOfPartitions(volume) == 0:
            continue
        grid = volumes.GetPartition(volume, 0)
        if grid.GetNumberOfCells() == 0:
            continue
        assert grid.GetFieldData().GetArray("SweepReportNotCertified").GetValue(0) == 0
        nodes = memoryview(grid.GetPointData().GetGlobalIds())
        for i, node in enumerate(nodes):
            part["points"][node] = grid.GetPoint(i)
        corners = memoryview(grid.GetCells().GetConnectivityArray())
        for c, cell in enumerate(memoryview(grid.GetCellData().GetGlobalIds())):
            part["cells"][cell] = (volume + 1, *(nodes[i] for i in corners[8 * c: 8 * c + 8]))
    with open(os.path.join(folder, str(rank)), "wb") as file:
        pickle.dump(part, file)


if sys.argv[1:2] == ["ranks"]:
    body(sys.argv[2], sys.argv[3:] == ["bad"])
else:
    start()
