#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the code blocks of a page as a reader would who stands at the top of a clone, one after the other.

    run_page.py PAGE FOLDER          # FOLDER: where it runs, with Data and build/release in it
    run_page.py PAGE FOLDER --write  # puts into the page what the blocks print

Blocks are sh, python (all of a page in one interpreter), text, and what a comment before them says:
`<!-- run: pvpython -->` a script for pvpython; `<!-- run: window -->` a program with a window, which must
come up and stay; `<!-- run: ci -->` what continuous integration runs, .ci/run; `<!-- file: NAME -->` the content of a file; `<!-- output -->` what the block before
prints, "..." for anything; `<!-- needs: PROGRAM -->` a block that is left out, with its output, where there is no
such program (not every release of Debian has CalculiX). Other blocks are a fault, so that none is left out.
"""

import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

BLOCK = re.compile(r"^(?:<!-- ([^\n]*?) -->\n)?```(\w+)\n(.*?)^```$", re.M | re.S)
SOURCE = Path(__file__).resolve().parent.parent.parent
_END = "--- end of block ---"
_SECONDS_OF_A_WINDOW = 12


class Reader:
    """The reader's shell, whose exported variables last, and the reader's Python."""

    def __init__(self, folder):
        self._folder = folder
        self._environment = dict(os.environ, HOME=str(folder), COLUMNS="110", PYTHONDONTWRITEBYTECODE="1")
        self._python = None

    def shell(self, text):
        keep = self._folder / ".environment"
        script = f"set -e\n{text}\nenv -0 > {keep}\n"
        done = self._run(["bash", "-c", script])
        pairs = keep.read_bytes().decode().split("\0")
        self._environment.update(pair.split("=", 1) for pair in pairs if "=" in pair)
        keep.unlink()
        return done

    def pvpython(self, text):
        script = self._folder / ".script.py"
        script.write_text(text, encoding="utf-8")
        told = self._run(["pvpython", "--force-offscreen-rendering", str(script)])
        script.unlink()
        if "ERR|" in told or "WARN|" in told:
            raise AssertionError(f"a filter complains:\n{told}")
        return told

    def window(self, text):
        """@return nothing: the program must still be there after some seconds, and have said nothing of errors."""
        with subprocess.Popen(
            ["bash", "-c", f"exec {text.strip()}"], cwd=self._folder, env=self._environment, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True,
        ) as program:
            time.sleep(_SECONDS_OF_A_WINDOW)
            alive = program.poll() is None
            program.terminate()
            try:
                told = program.communicate(timeout=30)[0]
            except subprocess.TimeoutExpired:
                # What writes a stack in its handler of signals can lock itself out, on a busy machine.
                program.kill()
                told = program.communicate()[0]
        if not alive or re.search(r"ERR\||[Ee]rror|cannot|not found", told):
            raise AssertionError(f"the program has ended or complains:\n{told}")
        return ""

    def python(self, text):
        if not self._python:
            self._python = subprocess.Popen(
                [sys.executable, "-c", _LOOP], cwd=self._folder, env=self._environment,
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            )
        self._python.stdin.write(text + _END + "\n")
        self._python.stdin.flush()
        told = []
        for line in self._python.stdout:
            if line.rstrip("\n").endswith(_END):
                return "".join(told) + line.rstrip("\n")[: -len(_END)]
            told.append(line)
        raise AssertionError("the script fails:\n" + "".join(told))

    def end(self):
        if self._python:
            self._python.stdin.close()
            self._python.wait(timeout=60)

    def _run(self, words):
        done = subprocess.run(
            words, cwd=self._folder, env=self._environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True, timeout=250, check=False,
        )
        if done.returncode != 0:
            raise AssertionError(f"exit status {done.returncode}:\n{done.stdout}")
        return done.stdout


# Blocks on stdin, each up to a line that ends it; one namespace for all.
_LOOP = f"""
import sys
names, lines = {{"__name__": "__main__"}}, []
for line in sys.stdin:
    if line.rstrip("\\n") != "{_END}":
        lines.append(line)
        continue
    exec(compile("".join(lines), "block", "exec"), names)
    lines = []
    print("{_END}", flush=True)
"""


def blocks(page, language):
    """The code blocks of a page in one language."""
    text = Path(page).read_text(encoding="utf-8")
    return [match.group(3) for match in BLOCK.finditer(text) if match.group(2) == language]


def run_by_ci(text):
    """@throw AssertionError where one of the commands is not in .ci/run."""
    known = (SOURCE / ".ci" / "run").read_text(encoding="utf-8").splitlines()
    for command in text.split("\n"):
        if not any(line.startswith(command) for line in known):
            raise AssertionError(f".ci/run does not run {command}")
    return ""


def fits(told, expected):
    """Whether text is as expected, whatever stands for its "..."."""
    pattern = ".*?".join(map(re.escape, expected.rstrip().split("...")))
    return re.fullmatch(pattern, told.rstrip(), re.S) is not None


def cleaned(text):
    return "".join(line.rstrip() + "\n" for line in text.rstrip().splitlines())


def run_page(page, folder, write):
    """@return the page, with new outputs where `write`. @throw AssertionError."""
    text = page.read_text(encoding="utf-8")
    reader, told, parts, last = Reader(folder), "", [], 0
    for match in BLOCK.finditer(text):
        mark, language, code = match.group(1) or "", match.group(2), match.group(3)
        line = text[: match.start()].count("\n") + 1
        print(f"== {page.name}:{line}: {language} {mark}", flush=True)
        try:
            if mark.startswith("needs: ") and shutil.which(mark[len("needs: ") :]) is None:
                told = None
                print("left out: the program is not there", flush=True)
            elif mark == "output" and language == "text" and told is None:
                continue
            elif mark == "output" and language == "text":
                if write and not fits(told, code):
                    parts += [text[last : match.start(3)], cleaned(told)]
                    last = match.end(3)
                elif not fits(told, code):
                    raise AssertionError(f"it prints:\n{told}\nand the page has:\n{code}")
            elif mark.startswith("file: "):
                (folder / mark[len("file: ") :]).write_text(code, encoding="utf-8")
            else:
                told = _runner(reader, "" if mark.startswith("needs: ") else mark, language)(code)
                print(told, flush=True)
        except AssertionError as error:
            raise AssertionError(f"{page.name}, line {line}: {error}") from None
    reader.end()
    return "".join(parts) + text[last:]


def _runner(reader, mark, language):
    runners = {
        ("", "sh"): reader.shell, ("", "python"): reader.python, ("run: pvpython", "python"): reader.pvpython,
        ("run: window", "sh"): reader.window, ("run: ci", "sh"): run_by_ci,
    }
    if (mark, language) not in runners:
        raise AssertionError(f"nobody knows how to run a block of {language} after '{mark}'")
    return runners[mark, language]


def prepared(folder):
    """As a clone in which demo.sh has built in build/release."""
    subprocess.run(["rm", "-rf", str(folder)], check=True)
    (folder / "build").mkdir(parents=True)
    (folder / "build" / "release").symlink_to(os.environ["HEXSWEEP_BINARY_DIR"])
    for name in ("Data", "Utilities"):
        (folder / name).symlink_to(SOURCE / name)
    return folder


def main():
    page, folder = Path(sys.argv[1]), prepared(Path(sys.argv[2]))
    try:
        new = run_page(page, folder, "--write" in sys.argv[3:])
    except AssertionError as error:
        sys.exit(str(error))
    if "--write" in sys.argv[3:]:
        page.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
