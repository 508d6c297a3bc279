# SPDX-License-Identifier: BSD-3-Clause
"""Says which names in the pages are not, or no longer, in the tree.

    python3 check_names.py SOURCE_DIR

Looked at are links to files and headings, and what stands in `code`: paths (from the top, or from
Filters/Core: `Room/Unit`), and identifiers, which must occur in some source. In the Architecture page the
column "may include" of the rooms must be what Testing/Rooms/check_rooms.py allows, in the Core page the
headers those of Filters/Core/PublicHeaders.txt. What the docstrings cite must be in
Documentation/references.bib, and all that is there must be cited.
"""
import re
import sys
from pathlib import Path

PAGES = ["README.md", "CONTRIBUTING.md", "Documentation/Architecture.md", "Documentation/Core.md", "Documentation/Promises.md",
         "Examples/README.md"]
SOURCES = ["Filters", "IO", "Plugin", "Python", "Testing", "Utilities", "CMake", "Examples", "Documentation", "CMakeLists.txt",
           "CMakePresets.json", "vtk.module"]
SUFFIXES = {".h", ".cxx", ".py", ".in", ".xml", ".txt", ".cmake", ".json", ".sh", ".module", ".geo"}
FENCE = re.compile(r"^```.*?^```$", re.M | re.S)
CODE = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(r"[\w.+-]+(/[\w.+*-]+)+/?")
FILE = re.compile(r"[\w.-]+\.(h|cxx|py|sh|md|xml|txt|cff|json|bib|cmake|geo|vtu)")
IDENTIFIER = re.compile(r"(?:[A-Za-z_]\w*::)*([A-Za-z_]\w+)(\(\))?")
CITATION = re.compile(r"[\\@]cite[\s*/]+(\w+)")
ENTRY = re.compile(r"^@\w+\{([^,\s]+),", re.M)
# What the tree makes or takes but does not hold.
MADE = ("build/", "paraview-")
# VTK's, and names that stand for others.
FOREIGN = {"doxygen", "VTK_SMP_BACKEND_IN_USE", "Unit.h", "Unit.cxx"}


def names_in(page, text, root, words):
    """The names in one page that lead nowhere, a line each."""
    problems = []
    prose = FENCE.sub("", text)
    for target in LINK.findall(text):
        if "://" not in target:
            problems += link_problem(page, target)
    for code in CODE.findall(prose):
        for name in re.split(r"[\s,=;]+", code):
            if not is_known(name, page, root, words):
                problems.append(f"{page.name}: `{name}` is nowhere")
    return problems


def link_problem(page, target):
    path, _, anchor = target.partition("#")
    file = page.parent / path if path else page
    if not file.exists():
        return [f"{page.name}: the link {target} leads nowhere"]
    if anchor and anchor not in anchors_of(file.read_text(encoding="utf-8")):
        return [f"{page.name}: no heading of {path} is #{anchor}"]
    return []


def anchors_of(text):
    """GitHub's anchors of a page's headings."""
    headings = re.findall(r"^#+ (.*)$", FENCE.sub("", text), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def is_known(name, page, root, words):
    if "<" in name or name.startswith(MADE) or name in FOREIGN:
        return True
    if PATH.fullmatch(name):
        places = [root, root / "Filters" / "Core", root / "Filters", page.parent]
        return any(
            (place / name).exists() or (place / f"{name}.h").exists() or any(place.glob(name.rstrip("/")))
            for place in places
        )
    if FILE.fullmatch(name):
        folders = ("Filters", "IO", "Plugin", "Testing", "Data", "Examples")
        return (root / name).exists() or any(any((root / folder).rglob(name)) for folder in folders)
    match = IDENTIFIER.fullmatch(name)
    return not match or match.group(1) in words


def words_of(root):
    """Every word of the sources, and the names of files and folders."""
    words = set()
    for source in SOURCES:
        top = root / source
        for file in [top] if top.is_file() else top.rglob("*"):
            if "Testing/Documentation" in file.as_posix():
                continue
            words.update((file.name, file.stem))
            if file.is_file() and file.suffix in SUFFIXES:
                words.update(re.findall(r"\w+", file.read_text(encoding="utf-8")))
    words.update(file.name for folder in ("Data", "") for file in (root / folder).glob("*"))
    words.update(file.name for file in (root / "Data").glob("*/*"))
    return words


def room_problems(text, allowed):
    """Where the Architecture page's table of rooms is not the rule that the test enforces."""
    rows = re.findall(r"^\| `(\w+)` \|.*\| ([\w, ]+) \|$", text, re.M)
    written = {room: [] if rooms == "nothing" else rooms.split(", ") for room, rooms in rows}
    return [
        f"Architecture.md: room {room} may include {allowed.get(room)}, the page says {written.get(room)}"
        for room in sorted(set(allowed) | set(written))
        if allowed.get(room) != written.get(room)
    ]


def header_problems(page, headers):
    """Where the Core page's table of headers is not the list of those that are installed.

    @param headers: text of PublicHeaders.txt."""
    listed = {line for line in headers.splitlines() if line and not line.startswith("#")}
    cells = re.findall(r"^\| (`\w+/\w+\.h`[^|]*) \|", page, re.M)
    written = {name for cell in cells for name in re.findall(r"\w+/\w+\.h", cell)}
    return [f"Core.md does not list the public header {name}" for name in sorted(listed - written)] + [
        f"Core.md lists {name}, which PublicHeaders.txt lacks" for name in sorted(written - listed)
    ]


def cite_problems(sources, bibliography):
    """The citations that have no entry, and the entries that nothing cites.

    @param sources:      text of each source by its name.
    @param bibliography: text of references.bib."""
    entries = set(ENTRY.findall(bibliography))
    cited = {(name, key) for name, text in sources.items() for key in CITATION.findall(text)}
    unknown = sorted((name, key) for name, key in cited if key not in entries)
    unused = sorted(entries - {key for _, key in cited})
    return [f"{name} cites {key}, which references.bib lacks" for name, key in unknown] + [
        f"references.bib: nothing cites {key}" for key in unused
    ]


def problems_of(root):
    sys.path.insert(0, str(root / "Testing" / "Rooms"))
    from check_rooms import ALLOWED

    words = words_of(root)
    problems = []
    guide = sorted((root / "Documentation" / "guide").rglob("*.md"))
    for page in [root / name for name in PAGES] + guide:
        problems += names_in(page, page.read_text(encoding="utf-8"), root, words)
    architecture = (root / "Documentation" / "Architecture.md").read_text(encoding="utf-8")
    core = (root / "Documentation" / "Core.md").read_text(encoding="utf-8")
    headers = (root / "Filters" / "Core" / "PublicHeaders.txt").read_text(encoding="utf-8")
    problems += room_problems(architecture, ALLOWED) + header_problems(core, headers)
    sources = {
        file.relative_to(root).as_posix(): file.read_text(encoding="utf-8")
        for file in (root / "Filters").rglob("*")
        if file.suffix in (".h", ".cxx")
    }
    bibliography = (root / "Documentation" / "references.bib").read_text(encoding="utf-8")
    return problems + cite_problems(sources, bibliography)


if __name__ == "__main__":
    found = problems_of(Path(sys.argv[1]))
    print("\n".join(found), file=sys.stderr)
    sys.exit(1 if found else 0)
