# SPDX-License-Identifier: BSD-3-Clause
"""What `hexsweep SOLID --quad-size SIZE --layers N -o FILE` does, in one process that tells its times.

Prints JSON: CPU seconds by stage, and of the main thread; those of the busiest thread are the main one's
and an equal share of the others'.
"""

import hashlib
import json
import os
import sys
import time

solid, size, layers, output, threads = sys.argv[1:]
if int(threads) > 1:
    os.environ["VTK_SMP_BACKEND_IN_USE"] = "STDThread"
    os.environ["VTK_SMP_MAX_THREADS"] = threads
else:
    os.environ["VTK_SMP_BACKEND_IN_USE"] = "Sequential"

from hexsweep import vtkOneToOneSweep  # noqa: E402
from hexsweep.commandline.messages import vtk_messages_said  # noqa: E402
from hexsweep.files.output import NewFile  # noqa: E402
from hexsweep.files.reading import read  # noqa: E402
from hexsweep.files.writing import Choices, write  # noqa: E402

messages = vtk_messages_said()
times = {"modules": time.process_time()}
with open("/proc/self/statm", encoding="ascii") as statm:
    memory_modules = int(statm.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2.0**20
sweep = vtkOneToOneSweep()
sweep.SetSolidData(read(solid, messages))
times["reading"] = time.process_time()
sweep.SetQuadSize(float(size))
sweep.SetNumberOfLayers(int(layers))
sweep.Update()
times["sweep"] = time.process_time()
hexes = sweep.GetOutputDataObject(0)
if hexes.GetNumberOfCells() == 0:
    sys.exit("there is no mesh")
with NewFile(output, [solid]) as new:
    write(sweep, new, Choices(), messages)
    new.put_in_place()
times["writing"] = time.process_time()

record = {"memory_modules": memory_modules}
before = 0.0
for name, at in times.items():
    record["cpu_" + name] = at - before
    before = at
main = time.thread_time()
others = time.process_time() - main
record["busiest"] = main + others / max(1, int(threads))
record["grid_memory"] = hexes.GetActualMemorySize() / 1024.0
bits = hashlib.sha256()
for array in (
    hexes.GetPoints().GetData(),
    hexes.GetCells().GetConnectivityArray(),
    *(hexes.GetCellData().GetArray(i) for i in range(hexes.GetCellData().GetNumberOfArrays())),
):
    bits.update(memoryview(array).cast("B"))
record["bits"] = bits.hexdigest()
stages = hexes.GetFieldData().GetAbstractArray("SweepReportStages")
seconds = hexes.GetFieldData().GetArray("SweepReportSeconds")
for i in range(stages.GetNumberOfValues()):
    record["stage_" + stages.GetValue(i)] = seconds.GetValue(i)
print(json.dumps(record))
