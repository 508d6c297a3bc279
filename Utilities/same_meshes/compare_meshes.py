# SPDX-License-Identifier: BSD-3-Clause
"""Compares two folders of write_meshes.py bit for bit; run by Utilities/same-meshes.sh.

Prints one line a mesh, and below it the first differences. Exits with 1 if there are any.
"""

import os
import sys

import numpy as np

# Differences told a mesh.
TOLD = 5


def main():
    old, new = sys.argv[1:]
    names = sorted(set(os.listdir(old)) | set(os.listdir(new)))
    different = sum(_tell(name, old, new) for name in names)
    if not names:
        sys.exit("no meshes")
    print(f"{len(names) - different} of {len(names)} meshes are the same")
    sys.exit(1 if different else 0)


def _tell(name, old, new):
    """Prints what there is to say about one mesh; returns whether it differs."""
    label = name[: -len(".npz")]
    files = [os.path.join(folder, name) for folder in (old, new)]
    for file, which in zip(files, ("OLD", "NEW")):
        if not os.path.exists(file):
            print(f"DIFFERENT {label}: {which} has no such mesh")
            return True
    with np.load(files[0]) as before, np.load(files[1]) as after:
        differences, remarks = compare(before, after)
        refused = before["cells/types"].size == 0
        what = "refused" if refused else f"{before['cells/types'].size} cells"
        arrays = len(before.files) - 1
    print(f"{'DIFFERENT' if differences else 'same'} {label}: {what}, {arrays} arrays")
    for line in differences[:TOLD] + remarks:
        print("    " + line)
    if len(differences) > TOLD:
        print(f"    and {len(differences) - TOLD} more arrays")
    return bool(differences)


def compare(before, after):
    """(differences, remarks) as lines, of two meshes that map names to arrays."""
    differences, remarks = [], []
    for key in before.files:
        if key == "messages":
            continue
        if key not in after.files:
            differences.append(f"{key}: missing in NEW")
        else:
            line = difference(before[key], after[key])
            if line and same_numbers(before[key], after[key]):
                remarks.append(f"{key}: the same numbers, {line}")
            elif line:
                differences.append(f"{key}: {line}")
    remarks += [f"{key}: only in NEW" for key in after.files if key not in before.files]
    line = difference(before["messages"], after["messages"])
    if line:
        # Of a mesh that is refused the message is all there is.
        refused = before["cells/types"].size == 0
        (differences if refused else remarks).append(f"messages: {line}")
    return differences, remarks


def difference(before, after):
    """Where two arrays differ first, as text; empty if they are the same bit for bit."""
    if before.dtype.kind != after.dtype.kind or before.shape != after.shape:
        return f"{_form(before)} in OLD, {_form(after)} in NEW" + _unequal_lists(before, after)
    if before.dtype.kind != "U" and before.dtype != after.dtype:
        return f"{_form(before)} in OLD, {_form(after)} in NEW"
    if before.size == 0:
        return ""
    differs = before != after if before.dtype.kind == "U" else _bits(before) != _bits(after)
    if not differs.any():
        return ""
    tuples = differs.reshape(len(before), -1).any(axis=1)
    first = int(np.argmax(tuples))
    return (
        f"{int(tuples.sum())} of {len(before)} tuples differ, first tuple {first}: "
        f"{_text(before[first])} in OLD, {_text(after[first])} in NEW"
    )


def same_numbers(before, after):
    """Whether counts became integers: one is whole numbers of another type than the other."""
    kinds = {before.dtype.kind, after.dtype.kind}
    return kinds == {"f", "i"} and before.shape == after.shape and bool((before == after).all())


def _unequal_lists(before, after):
    """Lists of strings are short enough to be told as a whole."""
    if before.dtype.kind == "U" or after.dtype.kind == "U":
        return f": {before.tolist()}, {after.tolist()}"
    return ""


def _bits(array):
    """The bytes of each tuple: NaN equals NaN, -0 does not equal 0."""
    contiguous = np.ascontiguousarray(array)
    return contiguous.view(np.uint8).reshape(len(array), -1)


def _form(array):
    return f"{'strings' if array.dtype.kind == 'U' else array.dtype.name} {array.shape}"


def _text(values):
    if values.ndim == 0:
        return repr(values.item())
    return "(" + ", ".join(repr(value) for value in values.tolist()) + ")"


if __name__ == "__main__":
    main()
