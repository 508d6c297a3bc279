# SPDX-License-Identifier: BSD-3-Clause
"""Judges the Debian packages by dpkg-deb: files, control fields, and what the loader finds.

Usage: TestDebianPackages.py <folder> <version> <multiarch> <plugin folder below lib> <ParaView's version>
                             <source folder>
"""

import gzip
import os
import re
import subprocess
import sys
import tempfile

folder, version, multiarch, plugins, paraview, source = sys.argv[1:]
lib = f"usr/lib/{multiarch}"
python = "usr/lib/python3/dist-packages/hexsweep"
RUNTIME = [
    "usr/bin/hexsweep",
    "usr/share/man/man1/hexsweep.1.gz",
    f"{lib}/libvtkFiltersHexSweep.so.1",
    f"{lib}/libvtkFiltersHexSweep.so.1.0",
    f"{lib}/{plugins}/HexSweep/HexSweep.so",
    f"{python}/__init__.py",
    f"{python}/commandline/__init__.py",
    f"{python}/vtkFiltersHexSweep.so",
]
DEVELOPMENT = [
    "usr/include/hexsweep/vtkOneToOneSweep.h",
    "usr/include/hexsweep/Core/Common/Mesh.h",
    f"{lib}/libvtkFiltersHexSweep.so",
    f"{lib}/libHexSweepCore.a",
    f"{lib}/cmake/HexSweep/HexSweepConfig.cmake",
    f"{lib}/cmake/HexSweep/HexSweep-targets.cmake",
]
# Where a package may put files, each with what the other one has alone.
PLACES = {
    "hexsweep": [r"usr/bin/hexsweep", rf"{lib}/lib\w+\.so\.[\d.]+", rf"{lib}/{plugins}/.*", rf"{python}/.*",
                 r"usr/share/man/man1/.*", r"usr/share/hexsweep/macros/\w+\.py",
                 rf"(usr/bin|{lib}/{os.path.dirname(plugins)})/paraview\.conf"],
    "hexsweep-dev": [r"usr/include/hexsweep/.*", rf"{lib}/lib\w+\.(so|a)", rf"{lib}/cmake/HexSweep/.*",
                     rf"{lib}/vtk/hierarchy/HexSweep/.*"],
}


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def field(file, name):
    return run("dpkg-deb", "--field", file, name).strip()


def unpack(file, target):
    """All files of a package, by their names below the root."""
    run("dpkg-deb", "--extract", file, target)
    return [
        os.path.relpath(os.path.join(place, name), target)
        for place, _, names in os.walk(target) for name in names
    ]


def check_control(package, file):
    assert field(file, "Package") == package
    assert field(file, "Version") == version
    assert re.fullmatch(r".+ <[^@ ]+@[^@ ]+>", field(file, "Maintainer")), field(file, "Maintainer")
    depends = field(file, "Depends")
    if package == "hexsweep":
        assert f"python3-paraview (>= {paraview})" in depends, depends
        assert "svg" in field(file, "Recommends"), "ParaView's buttons and ours would have no icons"
        assert re.search(r"python3 \(>= 3\.(\d+)~\), python3 \(<< 3\.\d+~\)", depends), depends
        assert "python3-vtk9" in field(file, "Description")
        control = run("dpkg-deb", "--info", file, "shlibs")
        assert f"libvtkFiltersHexSweep 1 hexsweep (= {version})" in control, control
    else:
        assert f"hexsweep (= {version})" in depends and "paraview-dev" in depends, depends


def check_places(package, files):
    documents = [f"usr/share/doc/{package}/{name}" for name in ("copyright", "changelog.gz", "changelog.Debian.gz")]
    wanted = (RUNTIME if package == "hexsweep" else DEVELOPMENT) + documents
    missing = [name for name in wanted if name not in files]
    assert not missing, f"{package} lacks {missing}"
    strange = [
        name for name in files
        if name not in documents and not any(re.fullmatch(place, name) for place in PLACES[package])
    ]
    assert not strange, f"{package} has {strange}"
    assert not [name for name in files if "__pycache__" in name]


def check_paraview(root, deb):
    """What ParaView reads when it starts leads to the plugin: a file beside the programs, or its own in place of theirs."""
    conf = os.path.join(lib, os.path.dirname(plugins), "paraview.conf")
    if os.path.exists(f"/{conf}"):
        with open(os.path.join(root, conf), encoding="utf-8") as file:
            *theirs, line = file.read().splitlines()
        own = f"/{conf}.distrib" if os.path.exists(f"/{conf}.distrib") else f"/{conf}"
        with open(own, encoding="utf-8") as file:
            assert theirs == file.read().splitlines(), theirs
        for script, action in ("preinst", "--add"), ("postrm", "--remove"):
            text = run("dpkg-deb", "--info", deb, script)
            assert f"dpkg-divert --package hexsweep {action} --rename" in text and f"/{conf}" in text, text
    else:
        conf = "usr/bin/paraview.conf"
        with open(os.path.join(root, conf), encoding="utf-8") as file:
            (line,) = file.read().splitlines()
    with open(os.path.join(root, os.path.dirname(conf), line), encoding="utf-8") as file:
        assert re.search(r'<Plugin name="HexSweep" auto_load="1"', file.read())


def check_binaries(root, files):
    for name in files:
        path = os.path.join(root, name)
        if re.search(r"\.so(\.|$)", name) and not os.path.islink(path):
            dynamic = run("readelf", "--dynamic", path)
            assert "RPATH" not in dynamic and "RUNPATH" not in dynamic, f"{name} has a path"
            assert ".symtab" not in run("readelf", "--sections", "--wide", path), f"{name} is not stripped"


def check_text(root, files):
    """Nothing tells of the folder that it was built in, and CMake's files name what is there."""
    for name in files:
        path = os.path.join(root, name)
        if os.path.islink(path) or not re.search(r"\.(cmake|py|xml|txt|h)$|bin/", name):
            continue
        with open(path, encoding="utf-8") as file:
            text = file.read()
        assert source not in text, f"{name} names {source}"
        if "HexSweep" in name and "-targets" in name:
            for found in re.findall(r'\$\{_IMPORT_PREFIX\}/([^";\\]+)', text):
                yield "usr/" + found


with tempfile.TemporaryDirectory() as scratch:
    named, present = [], set()
    for package in PLACES:
        deb = os.path.join(folder, f"{package}_{version}_{run('dpkg', '--print-architecture').strip()}.deb")
        check_control(package, deb)
        root = os.path.join(scratch, package)
        files = unpack(deb, root)
        check_places(package, files)
        check_binaries(root, files)
        if package == "hexsweep":
            check_paraview(root, deb)
        named += check_text(root, files)
        present.update(files)
        with gzip.open(os.path.join(root, f"usr/share/doc/{package}/changelog.Debian.gz"), "rt") as file:
            assert file.readline().startswith(f"hexsweep ({version}) ")
    assert len(named) > 3, named
    for name in named:
        assert name in present or any(file.startswith(name + "/") for file in present), f"CMake names {name}"
