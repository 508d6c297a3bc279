# SPDX-License-Identifier: BSD-3-Clause
"""Says where a list of the interior methods is not the one of Interior/InteriorStarts.

    python3 check_methods.py SOURCE_DIR

The methods have numbers in Core, in a C++ enumeration, in setters and in two XML files of the plugin, and
the guide has a table of them. A method that one of these lacks cannot be chosen there.
"""
import re
import sys
from pathlib import Path


def enumerators(text, name):
    """@return pairs of name and number of an enumeration."""
    body = re.search(rf"enum (?:class )?{name}\b[^{{]*{{(.*?)}}", text, re.S).group(1)
    return [(word, int(number)) for word, number in re.findall(r"(\w+) = (\d+)", body)]


def snake(name):
    """HarmonicCoordinates -> HARMONIC_COORDINATES"""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).upper()


def entries(text):
    """@return pairs of name and number that the XML's property Method offers."""
    body = re.search(r'<IntVectorProperty name="Method".*?</EnumerationDomain>', text, re.S).group(0)
    return [(word, int(number)) for word, number in re.findall(r'<Entry text="(\w+)" value="(\d+)"', body)]


def setters(text):
    """@return pairs of name and what the setter sets."""
    return re.findall(r"void SetMethodTo(\w+)\(\) { this->SetMethod\((\w+)\); }", text)


def difference(place, have, want):
    """@return what a list lacks and has too much, or None where it is as it is wanted."""
    if have == want:
        return None
    missing = [method for method in want if method not in have]
    others = [method for method in have if method not in want]
    return f"{place}: missing {missing}, not methods {others}" if missing or others else f"{place}: not in order"


def problems_of(root):
    def read(path):
        return (root / path).read_text(encoding="utf-8")

    methods = enumerators(read("Filters/Core/Interior/InteriorStarts.h"), "InteriorKind")
    starts = read("Filters/Core/Interior/InteriorStarts.cxx")
    table = re.findall(r'{ "(\w+)", \w+ }', starts.split("Methods[] = {", 1)[1].split("};", 1)[0])
    interior = read("Filters/vtkCageHexInterior.h")
    constants = [(snake(name), number) for name, number in methods]
    numbered = [(name, str(number)) for name, number in methods]
    guide = read("Documentation/guide/method.md").split("| `Method` | places", 1)[1].split("\n\n", 1)[0]
    offered = re.search(r"--method {(.*?)}", read("Documentation/guide/commandline.md")).group(1)
    found = {
        "Filters/Core/Interior/InteriorStarts.cxx": (table, [name for name, _ in methods]),
        "Filters/vtkCageHexInterior.h": (enumerators(interior, "MethodType"), constants),
        "Filters/vtkCageHexInterior.h, setters": (
            setters(interior), [(name, snake(name)) for name, _ in methods]),
        "Filters/vtkOneToOneSweep.h, setters": (setters(read("Filters/vtkOneToOneSweep.h")), numbered),
        "Plugin/CageHexInterior.xml": (entries(read("Plugin/CageHexInterior.xml")), methods),
        "Plugin/OneToOneSweep.xml": (entries(read("Plugin/OneToOneSweep.xml")), methods),
        "Documentation/guide/method.md, table": (
            re.findall(r"^\| `(\w+)`", guide, re.M), [name for name, _ in methods if name != "Automatic"]),
        "Documentation/guide/commandline.md, --method": (
            offered.split(","), [name.lower().replace("_", "-") for name, _ in constants]),
    }
    return [problem for place, (have, want) in found.items() if (problem := difference(place, have, want))]


if __name__ == "__main__":
    problems = problems_of(Path(sys.argv[1]))
    print("\n".join(problems))
    sys.exit(1 if problems else 0)
