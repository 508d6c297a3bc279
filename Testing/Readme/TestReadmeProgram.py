# SPDX-License-Identifier: BSD-3-Clause
"""Builds and runs the README's C++ program against an installed HexSweep; Examples/Chain holds it too.

Usage: TestReadmeProgram.py <cmake> <generator> <install prefix> <scratch folder>
"""

import os
import shutil
import subprocess
import sys

from readme_code import code_block

cmake, generator, prefix, scratch = sys.argv[1:]
source_dir = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
shutil.rmtree(scratch, ignore_errors=True)
os.makedirs(scratch)
for name, language in (("sweep.cxx", "cpp"), ("CMakeLists.txt", "cmake")):
    with open(os.path.join(scratch, name), "w", encoding="utf-8") as file:
        file.write(code_block(language))
    with open(os.path.join(source_dir, "Examples", "Chain", name), encoding="utf-8") as file:
        licence, program = file.read().split("\n", 1)
    if "SPDX" not in licence or program != code_block(language):
        sys.exit(f"Examples/Chain/{name} is not the README's program below its licence line")
os.symlink(os.path.join(source_dir, "Data"), os.path.join(scratch, "Data"))


def run(*command):
    print("+", *command, flush=True)
    subprocess.run(command, cwd=scratch, check=True)


run(cmake, "-G", generator, "-S", ".", "-B", "build",
    f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
run(cmake, "--build", "build")
run(os.path.join(scratch, "build", "sweep"))
judged = os.path.join(scratch, "c_open.vtu")
with open(judged, "rb") as file:
    head = file.read(65536).decode("latin-1")
if 'NumberOfCells="11440"' not in head:
    sys.exit("the program did not write the 11440 hexes of c_open")
