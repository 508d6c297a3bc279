# SPDX-License-Identifier: BSD-3-Clause
"""check_rooms.py finds what is planted, and nothing in a house that is in order."""
import tempfile
import unittest
from pathlib import Path

from check_rooms import problems_of


class CheckRooms(unittest.TestCase):
    def problems(self, files):
        with tempfile.TemporaryDirectory() as folder:
            core = Path(folder)
            for name, text in files.items():
                (core / name).parent.mkdir(exist_ok=True)
                (core / name).write_text(text, encoding="utf-8")
            return problems_of(core)

    def test_downward_is_allowed(self):
        self.assertEqual(self.problems({
            "Common/Mesh.h": "#include <vector>\n",
            "Solvers/A.h": '#include "Core/Common/Mesh.h"\n',
            "Solvers/A.cxx": '#include "Core/Solvers/A.h"\n'}), [])

    def test_upward_is_named(self):
        problems = self.problems({
            "Common/Mesh.h": '#include "Core/Solvers/A.h"\n', "Solvers/A.h": ""})
        self.assertEqual(len(problems), 1)
        self.assertIn("Common/Mesh.h:1: Common must not include Solvers", problems[0])

    def test_rooms_that_may_not_know_each_other(self):
        self.assertEqual(len(self.problems({
            "DiskMaps/A.cxx": '#  include "Core/Hexahedra/B.h"\n', "Hexahedra/B.h": ""})), 1)

    def test_circle_through_sources(self):
        problems = self.problems({
            "Linking/A.h": "", "Linking/A.cxx": '#include "Core/Linking/B.h"\n',
            "Linking/B.h": '#include "Core/Linking/A.h"\n'})
        self.assertEqual(len(problems), 1)
        self.assertIn("circle: ", problems[0])

    def test_vtk_other_style_and_homeless_files(self):
        problems = self.problems({
            "Common/A.h": '#include <vtkNew.h>\n#include "Mesh.h"\n', "B.h": "", "Attic/C.h": ""})
        self.assertEqual(len(problems), 4)


if __name__ == "__main__":
    unittest.main()
