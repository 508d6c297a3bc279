# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/Benchmarks.md and its pictures, of what whole_job.py measured."""

import datetime
import os

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

STAGES = ("modules", "reading", "sweep", "writing")


def write(record, folder):
    jobs = record["jobs"]
    pictures = os.path.join(folder, "pictures")
    _plot(jobs, os.path.join(pictures, "benchmark_time.png"), "CPU seconds", [
        ("gmsh", [job["gmsh"]["cpu"] for job in jobs]),
        ("HexSweep, one thread", [job["one"]["cpu"] for job in jobs]),
        ("HexSweep, busiest of two threads", [job["two"]["busiest"] for job in jobs]),
    ])
    _plot(jobs, os.path.join(pictures, "benchmark_memory.png"), "peak of the memory in MB", [
        ("gmsh", [job["gmsh"]["memory"] for job in jobs]),
        ("HexSweep, one thread", [job["one"]["memory"] for job in jobs]),
        ("HexSweep's output grid", [job["one"]["grid_memory"] for job in jobs]),
    ])
    with open(os.path.join(folder, "Benchmarks.md"), "w", encoding="utf-8") as file:
        file.write(_text(record))


def _text(record):
    machine, jobs = record["machine"], record["jobs"]
    return f"""# Benchmarks

The whole job of a user with default settings: a flange (a disk of radius 50, a bore, six bolt holes), from a file
to the file of its hexahedra, beside gmsh {machine["gmsh"]}, which only extrudes. Made by `Utilities/benchmark.sh`;
do not edit. {datetime.date.today()}, {machine["processor"]}, {machine["processors"]} processors,
Python {machine["python"]}. Both are processes that take turns; medians of {_runs(jobs)} runs. gmsh goes from the geometry
to a binary .vtk; HexSweep from the triangles of the same solid to a .vtu, with certificates of all hexahedra.
The single stages have peers of their own: [Testing/Benchmarks](../Testing/Benchmarks/README.md).

## Ratios to gmsh

{_table(["hexahedra", "CPU, one thread", "peak memory", "least SJ: ours, gmsh's", "mean SJ: ours, gmsh's"],
        [_ratios(job) for job in jobs])}

![CPU seconds by the number of hexahedra](pictures/benchmark_time.png)

## Growth, threads, memory

{_table(["hexahedra", "CPU a hexahedron, against the row above", "busiest of two threads over one thread",
         "same bits", "peak memory over the grid's"],
        [_growth(job, before) for job, before in zip(jobs, [None, *jobs])])}

![Memory by the number of hexahedra](pictures/benchmark_memory.png)

## Seconds

{_table(["hexahedra", "layers", "gmsh", "HexSweep", *STAGES, "source quads"], [_seconds(job) for job in jobs])}

CPU seconds. "modules" is Python and VTK until they are loaded, "reading" that of the solid, "writing" with the check
that the file is whole; "source quads" is a part of "sweep" by the clock on the wall, which other work on the machine
makes longer.

## What writing costs

A million hexahedra with all arrays, VTK's writer and reader of Debian 12 (CPU seconds; 796 k hexahedra, measured once):

| .vtu | writing | reading | MB |
|---|---|---|---|
| zlib, ids of 64 bits (VTK's default) | 3.49 | 1.82 | 53 |
| none | 2.43 | 3.01 | 140 |
| LZ4, ids of 32 bits: what `hexsweep` writes | 1.33 | 1.56 | 73 |
| LZ4, appended, in base64 | 1.36 | 1.19 | 74 |
| LZ4, appended, raw | 0.24 | 0.20 | 56 |

Most of it is base64. Raw data are not taken: VTK 9.1 cannot read them with one of the versions of expat that Debian 12
has had.
"""


def _runs(jobs):
    return " and ".join(str(n) for n in sorted({job["runs"] for job in jobs}))


def _table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def _count(job):
    return f"{job['one']['hexes']:,}".replace(",", " ")


def _ratios(job):
    ours, peer = job["one"], job["gmsh"]
    return [_count(job), f"{ours['cpu'] / peer['cpu']:.2f}", f"{ours['memory'] / peer['memory']:.2f}",
            f"{ours['least']:.3f}, {peer['least']:.3f}", f"{ours['mean']:.3f}, {peer['mean']:.3f}"]


def _growth(job, before):
    one = job["one"]
    each = one["cpu"] / one["hexes"]
    growth = f"{each / (before['one']['cpu'] / before['one']['hexes']):.2f}" if before else ""
    modules = _memory_of_modules(job)
    return [_count(job), growth, f"{job['two']['busiest'] / one['busiest']:.2f}",
            "yes" if job["same_bits"] else "NO", f"{(one['memory'] - modules) / one['grid_memory']:.2f}"]


def _memory_of_modules(job):
    return job["one"].get("memory_modules", 0.0)


def _seconds(job):
    one = job["one"]
    return [_count(job), str(job["layers"]), f"{job['gmsh']['cpu']:.2f}", f"{one['cpu']:.2f}",
            *(f"{one['cpu_' + stage]:.2f}" for stage in STAGES), f"{one['stage_Source quads']:.2f}"]


def _plot(jobs, path, label, curves):
    figure, axes = pyplot.subplots(figsize=(6.0, 4.0))
    for (name, values), marker in zip(curves, "os^"):
        axes.loglog([job["one"]["hexes"] for job in jobs], values, marker=marker, label=name)
    axes.set_xlabel("hexahedra")
    axes.set_ylabel(label)
    axes.grid(True, which="both", alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
