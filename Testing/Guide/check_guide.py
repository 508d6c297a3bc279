# SPDX-License-Identifier: BSD-3-Clause
"""Compares the guide with the code, both ways; what Utilities/guide.py writes is compared by its --check.

    python3 check_guide.py SOURCE_DIR

- Each property of a filter in its XML can be set in its class, and each setter of the class is a property.
- Each array of Filters/HexSweepArrays.h is named on the page of some filter, and each report that pages name is one.
- Each message that a page quotes is said somewhere in the sources.
- The program of cpp.md is Examples/Chain.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

_GENERATED = re.compile(r"<!-- from code: .*?<!-- end of code -->", re.S)
_FENCE = re.compile(r"^```.*?^```$", re.M | re.S)
_MACRO = re.compile(r"vtkSet(?:Clamp|Vector\d|FilePath|String|Enum|StdString)?(?:\d)?Macro\((\w+)")
_METHOD = re.compile(r"void (?:Set|Add)(\w+)\(")
_BASE = re.compile(r"class \w+ (\w+) : public (\w+)|class \w+ : public (\w+)")
_SECTION = re.compile(r"^## Messages, and what to do\n(.*?)(?=^## |\Z)", re.M | re.S)
_QUOTE = re.compile(r"(?<![\w*])\*([a-z.][^*]*?)\*(?![\w*])", re.S)
_LITERALS = re.compile(r'"((?:[^"\\\n]|\\.)*)"(?:\s*(?=")|)')
# Setters that are no choices of the user's: inputs, and what stands for another setter.
_NO_CHOICE = re.compile(r"\w+(Connection|Data)|\w+To[A-Z0-9]\w*|InputArrayToProcess")


def headers(root):
    return {file.stem: file.read_text(encoding="utf-8") for folder in ("Filters", "IO") for file in (root / folder).rglob("vtk*.h")}


def setters(known, name):
    """Names that can be set or added to in a class or in what it stands on here."""
    text = known.get(name, "")
    code = re.sub(r"^\s*(\*|//).*$", "", text, flags=re.M)
    found = set(_MACRO.findall(code)) | {word for word in _METHOD.findall(code) if not _NO_CHOICE.fullmatch(word)}
    base = re.search(rf"\b{name}\b[^;{{]*: public (\w+)", code)
    return found | (setters(known, base.group(1)) if base and base.group(1) in known else set())


def property_problems(root):
    known, problems = headers(root), []
    for file in sorted((root / "Plugin").glob("*.xml")):
        proxy = next(ElementTree.parse(file).getroot().iter("ProxyGroup"))[0]
        commands = {one.get("command", "") for one in proxy if one.tag.endswith("VectorProperty")}
        theirs = {re.sub(r"^(Set|Add)", "", command) for command in commands} - {"InputArrayToProcess", ""}
        ours = setters(known, proxy.get("class"))
        problems += [f"{file.name}: {name} cannot be set in {proxy.get('class')}" for name in sorted(theirs - ours)]
        problems += [f"{file.name}: lacks {name} of {proxy.get('class')}" for name in sorted(ours - theirs)]
    return problems


def array_problems(pages, arrays):
    """@param pages: text by name, of filters. @param arrays: all names of the header."""
    named = {name: set(re.findall(r"`(\w+)`", own_text(text))) for name, text in pages.items()}
    everywhere = set().union(*named.values())
    return [f"no page of a filter names the array {name}" for name in sorted(arrays - everywhere)] + [
        f"{page}: there is no report {word}"
        for page, words in named.items()
        for word in sorted(words)
        if word.startswith("SweepReport") and word not in arrays | {"SweepReport"}
    ]


def own_text(text):
    """What somebody wrote, without code blocks and what comes from the code."""
    return _FENCE.sub("", _GENERATED.sub("", text))


def quotes(text):
    """Pieces of messages that a page quotes, without what "..." stands for."""
    for section in _SECTION.findall(own_text(text)):
        for quote in _QUOTE.findall(section):
            for piece in quote.split("..."):
                words = " ".join(piece.split()).strip(" ,:;")
                if len(words.split()) > 1:
                    yield words


def message_problems(pages, said):
    return [
        f"{name}: nothing says \"{quote}\"" for name, text in pages.items() for quote in quotes(text) if quote not in said
    ]


def all_said(root):
    """All literals of the sources, those that follow each other as one."""
    parts = []
    for folder, suffixes in (("Filters", (".h", ".cxx")), ("IO", (".h", ".cxx")), ("Python", (".py",))):
        for file in (root / folder).rglob("*"):
            if file.suffix in suffixes:
                text = re.sub(r'"\s*\n\s*f?"', "", file.read_text(encoding="utf-8"))
                parts += _LITERALS.findall(text)
    return "\n".join(parts)


def example_problems(root):
    """Where Examples/Chain is not the guide's program below its licence line."""
    sys.path.insert(0, str(root / "Testing" / "Guide"))
    from run_page import blocks

    problems = []
    for name, language in (("sweep.cxx", "cpp"), ("CMakeLists.txt", "cmake")):
        licence, program = (root / "Examples" / "Chain" / name).read_text(encoding="utf-8").split("\n", 1)
        if "SPDX" not in licence or [program] != blocks(root / "Documentation" / "guide" / "cpp.md", language):
            problems.append(f"Examples/Chain/{name} is not the program of cpp.md below its licence line")
    return problems


def problems_of(root):
    sys.path.insert(0, str(root / "Utilities" / "guide"))
    import arrays

    guide = root / "Documentation" / "guide"
    pages = {file.name: file.read_text(encoding="utf-8") for file in sorted((guide / "filters").glob("*.md"))}
    problems = property_problems(root) + array_problems(pages, arrays.names(root))
    return problems + message_problems(pages, all_said(root)) + example_problems(root)


if __name__ == "__main__":
    found = problems_of(Path(sys.argv[1]))
    print("\n".join(found), file=sys.stderr)
    sys.exit(1 if found else 0)
