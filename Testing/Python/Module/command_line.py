# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command line share."""

import json
import os
import re
import subprocess
import sys
import tempfile

_FOLDER = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "solids", "flange")
SOLID = os.path.join(_FOLDER, "solid.vtu")
with open(os.path.join(_FOLDER, "case.json"), encoding="utf-8") as _file:
    CASE = json.load(_file)
SOURCE = [str(i) for i in CASE["source_face_ids"]]
COARSE = ["--source", *SOURCE, "--layers", "4", "--quad-size", "5"]
OLD = b"what the user had here before"


def command(*arguments):
    return [sys.executable, "-m", "hexsweep", *arguments]


def run(*arguments, **options):
    return subprocess.run(
        command(*arguments), timeout=100, check=False, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, encoding="utf-8", **options,
    )


def refused(*arguments, part, **options):
    """One line on stderr, with `part` in it, exit status 1 and nothing on stdout."""
    done = run(*arguments, **options)
    lines = done.stderr.splitlines()
    assert done.returncode == 1, (arguments, done.returncode, done.stderr)
    assert len(lines) == 1 and lines[0].startswith("hexsweep: error: "), (arguments, done.stderr)
    assert part in lines[0] and lines[0].endswith("."), (arguments, lines[0])
    assert not re.search(r"\b0x[0-9a-f]+|\.cxx|ERR\||vtkInformation", lines[0]), lines[0]
    assert done.stdout == "", done.stdout
    return lines[0]


def temporary_folder():
    return tempfile.TemporaryDirectory(dir=os.environ["HEXSWEEP_TEST_OUTPUT_DIR"])


def old_file(folder, name):
    path = os.path.join(folder, name)
    with open(path, "wb") as file:
        file.write(OLD)
    return path


def expect_only(folder, *names):
    """The folder has these files and no others; old ones byte for byte."""
    assert sorted(os.listdir(folder)) == sorted(names), os.listdir(folder)
    for name in names:
        with open(os.path.join(folder, name), "rb") as file:
            assert file.read() == OLD, name
