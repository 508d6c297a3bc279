# SPDX-License-Identifier: BSD-3-Clause
"""check_guide.py and run_page.py find what is wrong."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_guide  # noqa: E402
import run_page  # noqa: E402

PAGE = """# A Filter

## Arrays

`FaceId`, `SweepReportHexes` and `SweepReportNothing`.

<!-- from code: filter A -->
`SweepReportMadeUp`
<!-- end of code -->

## Messages, and what to do

- *the solid is open ... at the rim*: close it.
- *nobody says this*: never.
"""


def test_arrays():
    problems = check_guide.array_problems({"A.md": PAGE}, {"FaceId", "SweepReportHexes", "Validity"})
    assert problems == [
        "no page of a filter names the array Validity", "A.md: there is no report SweepReportNothing",
    ], problems


def test_messages():
    said = "the solid is open\nand much at the rim of it"
    problems = check_guide.message_problems({"A.md": PAGE}, said)
    assert problems == ['A.md: nothing says "nobody says this"'], problems


def test_setters():
    known = {
        "vtkBase": "class EXPORT vtkBase : public vtkObject\n  vtkSetMacro(Layers, int);\n",
        "vtkA": "class EXPORT vtkA : public vtkBase\n  vtkSetClampMacro(Size, double, 0, 1);\n  vtkSetVector3Macro(Axis, double);\n"
        "  void AddFace(int i);\n  void SetMethodToBlend() {}\n  void SetSolidData(vtkDataObject*);\n  /// void SetOld(int);\n",
    }
    assert check_guide.setters(known, "vtkA") == {"Layers", "Size", "Axis", "Face"}


def test_outputs_with_gaps():
    assert run_page.fits("12 hexes in 0.31 s\nend\n", "12 hexes in ... s\nend")
    assert not run_page.fits("13 hexes in 0.31 s\nend\n", "12 hexes in ... s\nend")
    assert not run_page.fits("12 hexes\nmore\n", "12 hexes")


def test_blocks_that_nobody_runs_are_faults():
    for mark, language in (("", "text"), ("", "cpp"), ("run: pvpython", "sh"), ("note", "sh")):
        try:
            run_page._runner(run_page.Reader(Path()), mark, language)
        except AssertionError as error:
            assert language in str(error)
        else:
            raise AssertionError((mark, language))


def test_blocks_for_programs_that_are_not_there_are_left_out():
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.md"
        page.write_text(
            "<!-- needs: no-such-program -->\n```sh\nno-such-program\n```\n\n<!-- output -->\n```text\nnever\n```\n\n"
            "<!-- needs: bash -->\n```sh\necho so\n```\n\n<!-- output -->\n```text\nOUTPUT\n```\n"
        )
        text = page.read_text()
        page.write_text(text.replace("OUTPUT", "so"))
        run_page.run_page(page, Path(folder), False)
        page.write_text(text.replace("OUTPUT", "otherwise"))
        try:
            run_page.run_page(page, Path(folder), False)
        except AssertionError as error:
            assert "otherwise" in str(error)
        else:
            raise AssertionError("an output that differs went unseen")


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
