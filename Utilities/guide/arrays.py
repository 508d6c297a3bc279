# SPDX-License-Identifier: BSD-3-Clause
"""Names and meanings of all arrays from Filters/HexSweepArrays.h, as tables in Markdown."""

import re

_ENTRY = re.compile(r"((?: *///[^\n]*\n)*)((?: *constexpr const char\* \w+ = \"\w+\";\n)+)")
_NAME = re.compile(r'"(\w+)"')


def table(root):
    return _table(_part(root, "namespace arrays", "namespace reports"))


def reports(root):
    return _table(_part(root, "namespace reports", None))


def names(root):
    """Of all arrays, and of all reports."""
    text = _part(root, "namespace arrays", None)
    return set(re.findall(r'constexpr const char\* \w+ = "(\w+)"', text)) - {"SweepReport"}


def _part(root, start, end):
    text = (root / "Filters" / "HexSweepArrays.h").read_text(encoding="utf-8")
    text = text[text.index(start) :]
    return text[: text.index(end)] if end else text


def _table(text):
    """A comment is about all lines below it, up to the next."""
    rows = ["| array | meaning |", "|---|---|"]
    meaning = ""
    for comment, entries in _ENTRY.findall(text):
        if comment:
            meaning = " ".join(line.strip().lstrip("/").strip() for line in comment.strip().splitlines())
        for name in _NAME.findall(entries):
            if name != "SweepReport":
                rows.append(f"| `{name}` | {meaning} |")
    return "\n".join(rows) + "\n"
