# SPDX-License-Identifier: BSD-3-Clause
"""check_names.py finds names that lead nowhere, and lets pass those that do not."""
import tempfile
import unittest
from pathlib import Path

from check_names import cite_problems, header_problems, names_in, room_problems


class CheckNames(unittest.TestCase):
    def problems(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            unit = root / "Filters" / "Core" / "Common" / "Mesh.h"
            unit.parent.mkdir(parents=True)
            unit.write_text("", encoding="utf-8")
            page = root / "PAGE.md"
            page.write_text("# One heading\n" + text, encoding="utf-8")
            return names_in(page, text, root, {"makeMesh", "Mesh"})

    def test_what_exists(self):
        for text in (
            "`Common/Mesh` `Filters/Core/Common/Mesh.h` `Filters/Core/*/Mesh.h` `Mesh.h`",
            "`makeMesh()` `hexsweep::makeMesh` `<prefix>/lib` `build/release/x`",
            "[page](PAGE.md) [heading](#one-heading) [out](https://example.org/x)",
            "```\n`nothing` in a fence\n```\n",
        ):
            self.assertEqual(self.problems(text), [], text)

    def test_what_does_not(self):
        for text in ("`Common/Grid`", "`Filters/Core/Common/Grid.h`", "`Grid.h`", "`makeGrid()`",
                     "`hexsweep::makeGrid`", "[page](NONE.md)", "[heading](PAGE.md#another)"):
            self.assertEqual(len(self.problems(text)), 1, text)

    def test_rooms(self):
        text = "| `A` | is low | nothing |\n| `B` | is high | A |\n"
        self.assertEqual(room_problems(text, {"A": [], "B": ["A"]}), [])
        self.assertEqual(len(room_problems(text, {"A": [], "B": []})), 1)
        self.assertEqual(len(room_problems(text, {"A": [], "B": ["A"], "C": []})), 1)

    def test_headers(self):
        page = "| header | what |\n|---|---|\n| `A/B.h`, `A/C.h` | both |\n| `D/E.h` | one, see `F/G.h` |\n"
        self.assertEqual(header_problems(page, "# comment\nA/B.h\nA/C.h\nD/E.h\n"), [])
        self.assertEqual(len(header_problems(page, "A/B.h\nD/E.h\nX/Y.h\n")), 2)

    def test_citations(self):
        bibliography = "% comment\n@article{A1999,\n  year = {1999}\n}\n\n@book{B2001,\n  year = {2001}\n}\n"
        both = {"A.h": r"/** After \cite A1999, (\cite B2001). */", "B.h": r"/// See \cite B2001."}
        self.assertEqual(cite_problems(both, bibliography), [])
        self.assertEqual(cite_problems({"A.h": "/**\n * After \\cite\n * A1999, @cite B2001\n */"}, bibliography), [])
        unknown = {**both, "C.h": r"/// \cite A1998"}
        self.assertEqual(cite_problems(unknown, bibliography), ["C.h cites A1998, which references.bib lacks"])
        unused = {"A.h": r"/// \cite A1999, and B2001 without"}
        self.assertEqual(cite_problems(unused, bibliography), ["references.bib: nothing cites B2001"])


if __name__ == "__main__":
    unittest.main()
