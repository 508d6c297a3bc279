#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps every solid of CAD files by itself, with default settings, and prints a table.

    python3 Testing/CADFiles/run_files.py --modules build/release/lib/python3.11/site-packages FOLDER...

A solid is certified, meshed (some hexahedra are not certified), refused (with why), or late. Each file
is read, and each solid swept, in a process of its own. Not part of the tests: the files are others'.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import time

EXTENSIONS = (".step", ".stp", ".iges", ".igs", ".brep")
MOST_SECONDS = 120
MOST_SOLIDS = 6  # of a file


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("--modules", required=True, help="where the package hexsweep is")
    parser.add_argument("--worker", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.worker is not None:
        print(json.dumps(work(options.folders[0], int(options.worker))))
        return
    totals = {}
    print(f"{'file':<44} {'read s':>6} {'solids':>6}  solid by solid: certified (hexes, least SJ), refused: why")
    for name in sorted(files(options.folders)):
        read = run(options, name, -1)
        if "error" in read:
            add(totals, "files not read")
            print(f"{os.path.basename(name)[:44]:<44} {'':>6} {'':>6}  {read['error'][:150]}", flush=True)
            continue
        print(f"{os.path.basename(name)[:44]:<44} {read['seconds']:6.1f} {read['solids']:6}  {read['warnings'][:120]}", flush=True)
        for solid in range(min(read["solids"], MOST_SOLIDS)):
            swept = run(options, name, solid)
            add(totals, swept["verdict"])
            print(f"    {solid + 1:>3} {swept['verdict']:<9} {swept['text'][:150]}", flush=True)
    print(", ".join(f"{count} {what}" for what, count in sorted(totals.items())))


def files(folders):
    for folder in folders:
        for place, _, names in os.walk(folder):
            yield from (os.path.join(place, name) for name in names if name.lower().endswith(EXTENSIONS))


def add(totals, what):
    totals[what] = totals.get(what, 0) + 1


def run(options, name, solid):
    """@param solid: its number from 0 on; -1: the file is only read."""
    command = [sys.executable, __file__, "--modules", options.modules, "--worker", str(solid), name]
    environment = dict(os.environ, PYTHONPATH=options.modules)
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=MOST_SECONDS, env=environment, check=False)
    except subprocess.TimeoutExpired:
        return {"verdict": "late", "text": f"not done after {MOST_SECONDS} s", "error": "not read in time"}
    if done.returncode != 0:
        words = (done.stderr.strip().splitlines() or ["no message"])[-1]
        return {"verdict": "crashed", "text": f"status {done.returncode}: {words}", "error": f"crashed: {words}"}
    return json.loads(done.stdout.splitlines()[-1])


def work(name, solid):
    from hexsweep import vtkCADReader, vtkOneToOneSweep
    from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    reader = vtkCADReader()
    said = collected(reader)
    reader.SetFileName(name)
    begin = time.process_time()
    reader.Update()
    solids = reader.GetOutput()
    if said["ErrorEvent"]:
        return {"error": said["ErrorEvent"][0], "verdict": "refused", "text": said["ErrorEvent"][0]}
    if solid < 0:
        return {
            "seconds": time.process_time() - begin,
            "solids": solids.GetNumberOfPartitionedDataSets(),
            "warnings": " ".join(said["WarningEvent"]).replace(name + ": ", ""),
        }
    sweep = vtkOneToOneSweep()
    said = collected(sweep)
    sweep.SetSolidData(solids.GetPartition(solid, 0))
    begin = time.process_time()
    sweep.Update()
    if said["ErrorEvent"]:
        return {"verdict": "refused", "text": said["ErrorEvent"][0]}
    hexes = sweep.GetOutput()
    reports = {key: hexes.GetFieldData().GetArray("SweepReport" + key) for key in (
        "NotCertified", "MinScaledJacobian", "SnappedNodes", "UnsnappedNodes")}
    value = {key: array.GetTuple1(0) if array else -1 for key, array in reports.items()}
    return {
        "verdict": "certified" if value["NotCertified"] == 0 else "meshed",
        "text": (
            f"{hexes.GetNumberOfCells()} hexes, least SJ {value['MinScaledJacobian']:.3f}, "
            f"{value['NotCertified']:.0f} not certified, {value['UnsnappedNodes']:.0f} of "
            f"{value['SnappedNodes'] + value['UnsnappedNodes']:.0f} nodes off the surfaces, "
            f"{time.process_time() - begin:.1f} s"
        ),
    }


def collected(algorithm):
    said = {"ErrorEvent": [], "WarningEvent": []}

    def observer(event):
        def observe(_algorithm, _event, text):
            words = re.sub(r"\A(ERROR|Warning): In .*?, line \d+\n\w+ \(\w+\): ", "", text)
            said[event].append(" ".join(words.split()))

        observe.CallDataType = "string0"
        return observe

    for event in said:
        algorithm.AddObserver(event, observer(event))
    return said


if __name__ == "__main__":
    main()
