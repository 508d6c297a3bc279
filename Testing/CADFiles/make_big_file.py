#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a STEP file of any size: copies of the solids of another one, beside each other.

    python3 Testing/CADFiles/make_big_file.py Data/cad/pin_in_plate.step 300 /tmp/big.step

The second word is the size in megabytes. What it is for: hexsweep on a file whose reading takes minutes
must show progress, stop where it is aborted (but for the kernel's parsing), and end with a mesh or one
error. Not part of the tests.
"""

import re
import sys

_ENTITY = re.compile(r"#(\d+)")
_PLACE = re.compile(r"(CARTESIAN_POINT\s*\(\s*'[^']*'\s*,\s*\(\s*)([^,()]+)((?:,[^,()]+){2}\))")


def main(source, megabytes, target):
    with open(source, encoding="latin-1") as file:
        text = file.read()
    begin = text.index("DATA;") + len("DATA;")
    end = text.index("ENDSEC;", begin)
    data = text[begin:end].replace("\n", "")
    entities = [entity.strip() + ";\n" for entity in data.split(";") if entity.strip()]
    last = max(int(number) for number in _ENTITY.findall(data))
    places = [float(x) for _, x, _ in _PLACE.findall(data)]
    step = 2.0 * (max(places) - min(places)) + 1.0
    # Copies that touch nothing: only what lies in space is moved, once, at its last level.
    body = "".join(entities)
    written = 0
    copies = 0
    with open(target, "w", encoding="latin-1") as file:
        file.write(text[:begin] + "\n")
        while written < megabytes * 1e6:
            numbered = _ENTITY.sub(lambda match: f"#{int(match[1]) + copies * last}", body)
            moved = _PLACE.sub(lambda match: f"{match[1]}{float(match[2]) + copies * step:.9E}{match[3]}", numbered)
            file.write(moved)
            written += len(moved)
            copies += 1
        file.write(text[end:])
    print(f"{target}: {copies} copies, {written / 1e6:.0f} MB")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]), sys.argv[3])
