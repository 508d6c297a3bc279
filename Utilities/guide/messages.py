# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings from the C++ sources, with a "…" for what they fill in, as lists in Markdown."""

import re

# Subject, and the sources that speak of it: the first that fits counts.
SUBJECTS = {
    "cad": ("IO/CAD/",),
    "writing": ("IO/Mesh/", "Filters/HexSweepSetNames", "Filters/HexSweepBoundarySets", "Filters/vtkHexGridWriter"),
    "assemblies": ("Filters/Core/Assemblies/", "Filters/vtkAssemblySweep", "Filters/HexSweepAssembly"),
    "caps": ("Filters/Core/Stacks/", "Filters/HexSweepStack", "Filters/vtkManyToManySweep"),
    "sides": ("Filters/Core/Linking/", "Filters/HexSweepLinking", "Filters/vtkLinkingSideMesher"),
    "quads": ("Filters/Core/CapQuads/", "Filters/Core/DiskMaps/", "Filters/HexSweepProjection",
              "Filters/HexSweepCapDisk", "Filters/vtkSweepQuadProjector", "Filters/vtkHarmonicDiskMap"),
    "inside": ("Filters/Core/Interior/", "Filters/Core/Hexahedra/", "Filters/HexSweepInterior",
               "Filters/HexSweepHex", "Filters/HexSweepCage", "Filters/vtkCageHexInterior", "Filters/vtkHexValidity"),
    "solids": ("Filters/Core/Solids/", "Filters/HexSweepSolid", "Filters/HexSweepBod", "Filters/HexSweepBest",
               "Filters/vtkSolidFaces", "Filters/vtkOneToOneSweep", "Filters/Core/Surfaces/"),
    "input": ("Filters/",),
}
_SITE = re.compile(
    r"(?:throw (?:InvalidInput|SolverFailure)|[wW]arnings(?:\.|->)(?:push_back|emplace_back)"
    r"|vtkWarningMacro|vtkErrorMacro|(?<![A-Za-z>])tell)\("
)
_TOKEN = re.compile(r'"((?:[^"\\]|\\.)*)"|//[^\n]*|\'(?:[^\'\\]|\\.)\'|(std::string\(|.)', re.S)
_LEAST_WORDS = 5
_GAP = "\u2026"


def listed(root, subject):
    found = sorted({text for place, text in sites(root) if subject_of(place) == subject and _tells(text)}, key=str.lower)
    return "".join(f"- {text}\n" for text in found)


def sites(root):
    """Pairs of a source and what one place in it says."""
    for folder in ("Filters", "IO"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".cxx", ".h"):
                text = file.read_text(encoding="utf-8")
                for match in _SITE.finditer(text):
                    yield file.relative_to(root).as_posix(), said(text, match.end())


def subject_of(place):
    return next(subject for subject, starts in SUBJECTS.items() if place.startswith(starts))


def said(text, start):
    """@param start: behind the bracket of a call. @return its text: literals, gaps for other words, and for
    literals that only some condition or function chooses."""
    parts, depth, position, chosen = [], [True], start, False
    while depth:
        match = _TOKEN.match(text, position)
        position = match.end()
        literal, other = match.group(1), match.group(2)
        if literal is not None:
            parts.append(literal if all(depth) and not chosen else _GAP)
        elif other == "std::string(":
            depth.append(True)
        elif other in ("(", "[", "{"):
            parts.append(_GAP)
            depth.append(False)
        elif other in (")", "]", "}"):
            depth.pop()
        elif other == "?" and all(depth):
            chosen = True
        elif other == "+":
            chosen = False
        elif other and not other.isspace() and other not in "<,":
            parts.append(_GAP)
    text = re.sub(f"{_GAP}+", _GAP, "".join(parts)).replace('\\"', '"').replace("\\n", " ").strip()
    return text.replace("<", "&lt;").replace("*", "\\*")


def _tells(text):
    return len(re.findall(r"[A-Za-z]{2,}", text)) >= _LEAST_WORDS
