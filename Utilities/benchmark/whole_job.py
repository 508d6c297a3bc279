# SPDX-License-Identifier: BSD-3-Clause
"""The whole job of a user against gmsh's: a flange with seven holes, from file to file.

gmsh goes from the geometry to hexahedra (recombined quads, extruded, written); we from the triangles of
the same solid. Both run as processes, in turns; CPU seconds and memory are the kernel's count of them.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import page  # noqa: E402

PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GEOMETRY = os.path.join(PROJECT, "Testing", "Benchmarks")
# A million hexahedra, as many layers as give them equal edges.
MILLION = {"size": 0.62, "layers": 50}
# Triangles over quads: what describes the circles well enough for the quads on them.
TRIANGLES = 1.2 / 0.62


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default="build/benchmark")
    parser.add_argument("--sizes", type=float, nargs="+", default=[1e5, 1e6])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--runs-of-largest", type=int, default=3, help="from ten million on")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    jobs = [
        compare(size, arguments.runs if size < 1e7 else arguments.runs_of_largest, arguments.output)
        for size in arguments.sizes
    ]
    record = {"machine": machine(), "jobs": jobs}
    with open(os.path.join(arguments.output, "whole_job.json"), "w", encoding="utf-8") as file:
        json.dump(record, file, indent=1)
    page.write(record, os.path.join(PROJECT, "Documentation"))


def compare(hexes, runs, output):
    scale = (hexes / 1e6) ** (1.0 / 3.0)
    size, layers = MILLION["size"] / scale, round(MILLION["layers"] * scale)
    place = lambda name: os.path.join(output, f"{name}_{hexes:.0f}")  # noqa: E731
    solid = place("solid") + ".vtk"
    process(gmsh("-2", "flange_surface.geo", {"lc": TRIANGLES * size}, solid))
    peer = gmsh("-3", "flange_hexes.geo", {"lc": size, "L": layers}, place("gmsh") + ".vtk")
    process(peer)
    quads = quality_of(place("gmsh") + ".vtk")["hexes"] / layers
    ours = place("hexsweep") + ".vtu"
    command = lambda threads: worker(solid, quad_size, layers, ours, threads)  # noqa: E731
    quad_size = size
    process(command(1))
    quad_size *= (quality_of(ours)["hexes"] / layers / quads) ** 0.5
    samples = {"gmsh": [], "one": [], "two": []}
    bits = set()
    for _ in range(runs):
        samples["gmsh"].append(process(peer))
        for name, threads in (("one", 1), ("two", 2)):
            samples[name].append(process(command(threads)))
            bits.add(samples[name][-1]["bits"])
    result = {name: medians(values) for name, values in samples.items()}
    result["gmsh"].update(quality_of(place("gmsh") + ".vtk"))
    result["one"].update(quality_of(ours))
    result.update(asked=hexes, layers=layers, runs=runs, same_bits=len(bits) == 1)
    print(json.dumps(result, indent=1), flush=True)
    return result


def gmsh(mode, script, numbers, output):
    words = [["-setnumber", name, repr(value)] for name, value in numbers.items()]
    return ["gmsh", mode, *sum(words, []), "-format", "vtk", "-bin", "-nt", "1", "-v", "1",
            "-o", output, os.path.join(GEOMETRY, script)]


def worker(solid, size, layers, output, threads):
    return [sys.executable, os.path.join(os.path.dirname(os.path.abspath(__file__)), "our_job.py"),
            solid, repr(size), str(layers), output, str(threads)]


def process(words):
    """@return CPU seconds, peak of memory in MB, what it printed (JSON) in addition."""
    began = time.time()
    with subprocess.Popen(words, stdout=subprocess.PIPE) as child:
        printed = child.stdout.read()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{' '.join(words)}: exit status {child.returncode}")
    result = {"cpu": usage.ru_utime + usage.ru_stime, "memory": usage.ru_maxrss / 1024.0,
              "wall": time.time() - began}
    lines = printed.decode().strip().splitlines()
    if lines and lines[-1].startswith("{"):
        result.update(json.loads(lines[-1]))
    return result


def medians(samples):
    return {name: statistics.median(sample[name] for sample in samples)
            for name, value in samples[0].items() if isinstance(value, (int, float))}


def quality_of(path):
    """Of the hexahedra in a file, by VTK's Verdict."""
    words = [sys.executable, os.path.join(os.path.dirname(os.path.abspath(__file__)), "quality.py"), path]
    return json.loads(subprocess.run(words, check=True, stdout=subprocess.PIPE).stdout)


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    version = subprocess.run(["gmsh", "--version"], check=True, capture_output=True, text=True)
    return {
        "processor": names[0] if names else platform.processor(),
        "processors": os.cpu_count(),
        "gmsh": (version.stdout + version.stderr).strip(),
        "python": platform.python_version(),
    }


if __name__ == "__main__":
    main()
