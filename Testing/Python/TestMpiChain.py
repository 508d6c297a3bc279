# SPDX-License-Identifier: BSD-3-Clause
"""The chain on two MPI ranks with the serial reader: all data on rank 0, rank 1 empty.

Run by pvpython it starts mpirun on itself; run by pvbatch (the argument `ranks`) it is the body. An
empty piece is no error: the output must hold every hex and no error or warning may be written.
No rendering: only data.
"""

import json
import os
import subprocess
import sys

CASE = "taper10"


def start():
    here = os.path.abspath(__file__)
    command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", "2",
               "--mca", "btl_vader_single_copy_mechanism", "none",
               "pvbatch", "--force-offscreen-rendering", here, "ranks"]
    # pvpython has begun MPI for itself: what it left in the environment would make mpirun take its
    # own ranks for children of that run.
    environment = {
        name: value for name, value in os.environ.items()
        if not name.startswith(("OMPI_", "PMIX_", "ORTE_", "OPAL_"))
    }
    done = subprocess.run(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=280,
        check=False,
    )
    print(done.stdout)
    assert done.returncode == 0, f"mpirun pvbatch ended with {done.returncode}"
    for word in ("ERR|", "WARN|", "ERROR:", "Warning:"):
        assert word not in done.stdout, f"a rank wrote '{word}'"
    assert "the chain ran on 2 ranks" in done.stdout, "the body did not come to its end"


def body():
    from chain_testing import DATA_DIR, chain, quiet, read_case
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    with open(os.path.join(DATA_DIR, "cases", CASE, "case.json"), encoding="utf-8") as file:
        expected = json.load(file)["hexes"]
    sweep = chain.sweep_harmonic(read_case(CASE), quiet)
    information = sweep.hexes.GetDataInformation()
    assert information.GetNumberOfCells() == expected, information.GetNumberOfCells()
    assert information.GetCellDataInformation().GetArrayInformation(
        "ScaledJacobian").GetComponentRange(0)[0] > 0
    print(f"the chain ran on {ranks} ranks", flush=True)


if sys.argv[1:] == ["ranks"]:
    sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
    body()
else:
    start()
