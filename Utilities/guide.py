#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the guide has from the code: properties of filters, arrays, messages.

    Utilities/guide.py           # writes it into the pages of Documentation/guide
    Utilities/guide.py --check   # only says where a page differs, or a filter has no page

In the pages it stands between `<!-- from code: WHAT -->` and `<!-- end of code -->`. Tables of
measurements come from Utilities/results.py, what commands print from Testing/Guide/run_page.py --write.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "Utilities" / "guide"))
import arrays  # noqa: E402
import messages  # noqa: E402
import properties  # noqa: E402

GUIDE = ROOT / "Documentation" / "guide"
BLOCK = re.compile(r"(<!-- from code: ([\w ]+) -->\n).*?(<!-- end of code -->\n)", re.S)


def blocks():
    """What there is to be put into pages, by name: functions without arguments."""
    found = {"arrays": lambda: arrays.table(ROOT), "reports": lambda: arrays.reports(ROOT)}
    for file in sorted((ROOT / "Plugin").glob("*.xml")):
        found[f"filter {file.stem}"] = lambda file=file: properties.tables(file)
    for subject in messages.SUBJECTS:
        found[f"messages {subject}"] = lambda subject=subject: messages.listed(ROOT, subject)
    return found


def main():
    check = "--check" in sys.argv[1:]
    known, used, stale = blocks(), [], []
    for page in sorted(GUIDE.rglob("*.md")):
        text = page.read_text(encoding="utf-8")

        def block(match, page=page):
            name = match.group(2)
            if name not in known:
                sys.exit(f"guide.py: {page.name}: nothing is called '{name}'; there are: {', '.join(known)}")
            used.append(name)
            return match.group(1) + "\n" + known[name]() + "\n" + match.group(3)

        new = BLOCK.sub(block, text)
        if new != text:
            stale.append(page.name)
            if not check:
                page.write_text(new, encoding="utf-8")
    if sorted(used) != sorted(known):
        odd = sorted(set(known) ^ set(used)) or sorted(name for name in used if used.count(name) > 1)
        sys.exit(f"guide.py: these are not in the guide, or more than once: {', '.join(odd)}")
    if check and stale:
        sys.exit(f"guide.py: {', '.join(stale)} differ from the code; run Utilities/guide.py")
    print("changed:" if stale else "nothing to change", *stale)


if __name__ == "__main__":
    main()
