#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the guide's page of the method and of Documentation/Results.md, from one file: Documentation/results.json.

    Utilities/demo.sh --compare && Utilities/demo.sh solids   # measures
    Utilities/results.py --measured build/demo                # takes the figures into results.json
    Utilities/results.py                                      # writes them into both pages
    Utilities/results.py --check                              # only says where a page differs

In the pages a table stands between `<!-- results: NAME -->` and `<!-- end of results -->`.
"""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "Utilities" / "demo"))
from result_tables import CASES, SOLIDS, record_table  # noqa: E402

RESULTS = ROOT / "Documentation" / "results.json"
PAGES = [ROOT / "Documentation" / "guide" / "method.md", ROOT / "Documentation" / "Results.md"]
BLOCK = re.compile(r"(<!-- results: ([\w ]+) -->\n).*?(<!-- end of results -->\n)", re.S)

# The guide's words for what it shows.
SOLID_NOTES = {
    "flange": "a disk with a bore and six bolt holes",
    "elbow": "a pipe through 90 degrees",
    "loft": "a square with a hole that becomes a ring",
    "bracket": "an L with fillets, two holes, draft above a straight flange",
    "wing": "a tapered and twisted section with a sharp trailing edge",
}
CASE_NOTES = {
    "c_open": ": a C section that opens",
    "gear_round": ": a gear that becomes a ring",
    "hole_twist120": ": a square hole that turns by 120 degrees",
    "twist270_L": ": an L that turns by 270 degrees",
    "ubend": ": a square through a U-bend",
    "taper10": ": a section that shrinks to a tenth",
    "fig7_growing_hole": " of the paper",
    "fig8_concave_twisted_hole": " of the paper",
    "fig9_spongecake": " of the paper, 37 holes",
}
PAPER = [name for name in CASE_NOTES if name.startswith("fig")]


def named(records):
    return {record["name"]: record for record in records}


def spaced(count):
    """12345 as 12 345, and what must be nothing in bold where it is."""
    return f"{count:,}".replace(",", " ")


def good(count):
    return "**0**" if count == 0 else spaced(count)


def guide_solids(results):
    given = named(r for r in results["solids"] if r["source_quads"] == "given")
    lines = [
        "| CAD solid (`Data/solids`), quads given | hexes | inverted | not certified | SJ min / mean |",
        "|---|---:|---:|---:|---:|",
    ]
    for name, note in SOLID_NOTES.items():
        r = given[name]
        lines.append(
            f"| `{name}`: {note} | {spaced(r['hexes'])} | {good(r['inverted'])} "
            f"| {good(r['not_certified'])} | {r['min_sj']:.3f} / {r['mean_sj']:.3f} |"
        )
    return "\n".join(lines) + "\n"


def guide_cases(results):
    cases = named(results["cases"])
    lines = [
        "| model (`Data/cases`) | hexes | inverted quads, affine / HexSweep "
        "| inverted hexes, affine / HexSweep | SJ min / mean |",
        "|---|---:|---:|---:|---:|",
    ]
    for name, note in CASE_NOTES.items():
        r = cases[name]
        lines.append(
            f"| `{name}`{note} | {spaced(r['hexes'])} "
            f"| {r['inverted_quads_affine']} / {good(r['inverted_quads'])} "
            f"| {r['inverted_affine']} / {good(r['inverted'])} "
            f"| {r['min_sj']:.3f} / {r['mean_sj']:.3f} |"
        )
    return "\n".join(lines) + "\n"


def raw_sentence(results):
    cases = named(results["cases"])

    def listed(key):
        *first, last = (spaced(cases[name][key]) for name in PAPER)
        return ", ".join(first) + " and " + last

    return (
        f"Without that the projection leaves {listed('inverted_quads_raw')} folded quads in the\n"
        f"models of the paper, and with them {listed('inverted_raw')} inverted hexes.\n"
    )


def caption(name):
    def text(results):
        r = results["pictures"][name]
        ours = "none" if r["inverted"] == 0 else str(r["inverted"])
        return (
            f"![Affine: {r['inverted_affine']} of {r['hexes']} hexes inverted; HexSweep: {ours}]"
            f"(pictures/{name}.png)\n"
        )

    return text


def fenced(columns, key):
    return lambda results: "```\n" + record_table(columns, results[key]) + "```\n"


BLOCKS = {
    "guide solids": guide_solids,
    "guide cases": guide_cases,
    "cases": fenced(CASES, "cases"),
    "solids": fenced(SOLIDS, "solids"),
    "raw": raw_sentence,
    "non_parallel_caps": caption("non_parallel_caps"),
    "curved_trajectory": caption("curved_trajectory"),
    "growing_hole": caption("growing_hole"),
}


def rendered(text, results, used):
    """A page with its tables as the results have them; the names of the tables go to `used`."""

    def block(match):
        name = match.group(2)
        if name not in BLOCKS:
            sys.exit(f"results.py: no table is called '{name}'; there are: {', '.join(BLOCKS)}")
        used.append(name)
        return match.group(1) + BLOCKS[name](results) + match.group(3)

    return BLOCK.sub(block, text)


def take(folder):
    """Reads what the demo measured; `filters_tree` is the code that it ran (git rev-parse)."""
    results = {"filters_tree": git("rev-parse", "HEAD:Filters")}
    for name in ("compare.json", "solids.json"):
        with open(folder / name, encoding="utf-8") as file:
            results.update(json.load(file))
    missing = set(CASE_NOTES) - set(named(results["cases"]))
    missing |= set(SOLID_NOTES) - set(named(results["solids"]))
    if missing:
        sys.exit(
            f"results.py: {folder} lacks {', '.join(sorted(missing))};"
            " run `Utilities/demo.sh --compare` and `Utilities/demo.sh solids`"
        )
    return results


def git(*arguments):
    return subprocess.run(
        ["git", "-C", ROOT, *arguments], check=True, stdout=subprocess.PIPE, text=True
    ).stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--measured", type=Path, help="the demo's folder: take its figures first")
    parser.add_argument("--check", action="store_true", help="change nothing; fail on a difference")
    arguments = parser.parse_args()
    if arguments.measured:
        text = json.dumps(take(arguments.measured), indent=1) + "\n"
        RESULTS.write_text(text, encoding="utf-8")
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    used, stale = [], []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        new = rendered(text, results, used)
        if new != text:
            stale.append(page.name)
            if not arguments.check:
                page.write_text(new, encoding="utf-8")
    if sorted(used) != sorted(BLOCKS):
        sys.exit(f"results.py: the pages hold the tables {sorted(used)}, not {sorted(BLOCKS)}")
    if arguments.check and stale:
        sys.exit(f"results.py: {', '.join(stale)} differ from results.json; run Utilities/results.py")
    print("changed:" if stale else "nothing to change", *stale)


if __name__ == "__main__":
    main()
