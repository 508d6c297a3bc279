#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps solids three ways: run_solids.py [--modules DIRECTORY] FOLDER...

A folder has solid.vtu and case.json (see make_solids.py), or folders that have. Each solid is swept
with both caps named, with the caps exchanged and with nothing named, default settings; one line a
sweep, then the figures of all. `right` with nothing named: all hexahedra are certified, and the caps
are those of case.json, either way round, or the least scaled Jacobian is no lower than that of
the sweep between those. The worst twentieth of the least scaled Jacobians is that of the sweeps
whose floor is no lower than 0.25. Needs the Python package of HexSweep (--modules: where it was built).
"""

import argparse
import json
import resource
import subprocess
import sys
import time
from pathlib import Path

WAYS = ("named", "exchanged", "nothing")
LONGEST = 180  # seconds of CPU time, of a solid
PATIENCE = 10 * LONGEST  # by the clock: other work may share the machine
GOAL = 0.25  # least scaled Jacobian, where the source quads' own allow it (the floor)


def sweep_once(solid, case, way):
    import hexsweep
    import vtk

    messages = []
    sweep = hexsweep.vtkOneToOneSweep()
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(solid))
    sweep.SetInputConnection(reader.GetOutputPort())
    caps = [case["source_face_ids"], case["target_face_ids"]]
    if way == "exchanged":
        caps.reverse()
    if way != "nothing":
        for face in caps[0]:
            sweep.AddSourceFaceId(face)
        for face in caps[1]:
            sweep.AddTargetFaceId(face)

    def note(_object, _event, text):
        messages.append(text.strip().replace("\n", " "))

    note.CallDataType = vtk.VTK_STRING
    sweep.AddObserver("ErrorEvent", note)
    sweep.AddObserver("WarningEvent", note)
    start = time.process_time()
    sweep.Update()
    seconds = time.process_time() - start
    hexes = sweep.GetOutput()
    result = {"way": way, "cpu": round(seconds, 2), "hexes": hexes.GetNumberOfCells(), "messages": messages}
    if hexes.GetNumberOfCells():
        data = hexes.GetFieldData()
        value = lambda name: data.GetArray(name).GetTuple1(0)
        ids = lambda name: [int(data.GetArray(name).GetTuple1(i)) for i in range(data.GetArray(name).GetNumberOfTuples())]
        result.update(bad=int(value("SweepReportNotCertified")), least=value("SweepReportMinScaledJacobian"),
                      mean=value("SweepReportMeanScaledJacobian"),
                      floor=value("SweepReportFloorScaledJacobian"),
                      source=ids("SweepReportSourceFaceIds"), target=ids("SweepReportTargetFaceIds"))
    return result


def sweep_solid(folder):
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))
    case = json.loads((folder / "case.json").read_text())
    for way in WAYS:
        print(json.dumps(sweep_once(folder / "solid.vtu", case, way)), flush=True)


def judge(case, results):
    """Says of every sweep whether it came out as it should."""
    caps = {tuple(sorted(case["source_face_ids"])), tuple(sorted(case["target_face_ids"]))}
    for way in WAYS:
        result = results.get(way)
        if result is None:
            results[way] = {"way": way, "cpu": LONGEST, "hexes": 0, "messages": ["no end, or a crash"]}
            result = results[way]
        result["certified"] = result["hexes"] > 0 and result["bad"] == 0
        result["right"] = result["certified"]
    nothing = results["nothing"]
    if nothing["hexes"]:
        meant = {tuple(sorted(nothing["source"])), tuple(sorted(nothing["target"]))} == caps
        named = max((results[w].get("least", -1) for w in ("named", "exchanged") if results[w]["certified"]), default=-1)
        nothing["right"] = nothing["certified"] and (meant or nothing["least"] >= named)
        nothing["caps"] = "meant" if meant else "others"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--modules", type=Path)
    parser.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.modules:
        sys.path.insert(0, str(options.modules))
    if options.one:
        sweep_solid(options.folders[0])
        return
    folders = []
    for folder in options.folders:
        folders += [folder] if (folder / "case.json").exists() else sorted(p.parent for p in folder.rglob("case.json"))
    everything = []
    for folder in folders:
        case = json.loads((folder / "case.json").read_text())
        command = [sys.executable, __file__, "--one", str(folder)]
        if options.modules:
            command += ["--modules", str(options.modules)]
        try:
            output = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE).stdout
        except subprocess.TimeoutExpired as late:
            output = (late.stdout or b"").decode()
        results = {}
        for line in output.splitlines():
            if line.startswith("{"):
                result = json.loads(line)
                results[result["way"]] = result
        judge(case, results)
        for way in WAYS:
            result = results[way]
            everything.append(result)
            print(f"{folder.name:>8} {way:>9} {'ok' if result['right'] else 'BAD':>3} "
                  f"bad {result.get('bad', '-')!s:>5} of {result['hexes']:>6} "
                  f"least {result.get('least', float('nan')):7.3f} mean {result.get('mean', float('nan')):6.3f} "
                  f"floor {result.get('floor', float('nan')):6.3f} "
                  f"cpu {result['cpu']:6.2f} {result.get('caps', '')} {' '.join(case['tags'] if 'tags' in case else [])} "
                  f"{'' if result['right'] else ' | '.join(result['messages'])[:400]}", flush=True)
    for way in WAYS:
        mine = [r for r in everything if r["way"] == way]
        least = sorted(r.get("least", -1.0) for r in mine if r.get("floor", GOAL) >= GOAL)
        silent = sum(1 for r in mine if not r["certified"] and not r["messages"])
        print(f"{way}: {sum(r['right'] for r in mine)} of {len(mine)} right, "
              f"{sum(r['certified'] for r in mine)} certified, {silent} bad without a message, "
              f"{sum(r['cpu'] > 10 for r in mine)} above 10 s, greatest {max(r['cpu'] for r in mine):.1f} s, "
              f"worst twentieth of the least scaled Jacobians up to {least[len(least) // 20] if least else float('nan'):.3f}")


if __name__ == "__main__":
    main()
