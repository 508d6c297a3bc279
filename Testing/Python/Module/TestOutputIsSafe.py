# SPDX-License-Identifier: BSD-3-Clause
"""Whatever happens to python3 -m hexsweep, the user's old file stays until a new one is complete.

Truth: the bytes of the old file, and what else is in its folder.
"""

import os
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time

from command_line import (
    COARSE,
    OLD,
    SOLID,
    SOURCE,
    command,
    expect_only,
    old_file,
    refused,
    run,
    temporary_folder,
)

EXTENSIONS = (".vtu", ".ex2")
# Takes some seconds.
LONG = ["--source", *SOURCE, "--layers", "2000", "--quad-size", "10"]


def test_output_is_checked_before_the_work(folder):
    """The solid named here has no cells, so that work begun would end with another message."""
    old = old_file(folder, "old.vtu")
    solid = os.path.join(folder, "solid.vtu")
    shutil.copy(SOLID, solid)
    hard = os.path.join(folder, "hard.vtu")
    soft = os.path.join(folder, "soft.vtu")
    loop = os.path.join(folder, "loop.vtu")
    os.link(solid, hard)
    os.symlink("hard.vtu", soft)
    os.symlink("loop.vtu", loop)
    os.mkdir(os.path.join(folder, "folder.vtu"))
    os.mkfifo(os.path.join(folder, "pipe.vtu"))
    before = sorted(os.listdir(folder))
    for name, part in (
        (solid, "is the same file as the input"),
        (hard, "is the same file as the input"),
        (soft, "is the same file as the input"),
        (loop, "cannot be written"),
        (os.path.join(folder, "folder.vtu"), "is a folder"),
        (os.path.join(folder, "pipe.vtu"), "is no regular file"),
        (os.path.join(folder, "none", "new.vtu"), "does not exist"),
        (os.path.join(old, "new.vtu"), "Not a directory"),
        ("/proc/new.vtu", "cannot be written: /proc"),
    ):
        refused(solid, "--source", "99", "-o", name, part=part)
    refused(SOLID, *COARSE, "--quads", solid, "-o", hard, part="is the same file as the input")
    assert sorted(os.listdir(folder)) == before, os.listdir(folder)
    with open(SOLID, "rb") as one, open(solid, "rb") as other:
        assert one.read() == other.read()
    with open(old, "rb") as file:
        assert file.read() == OLD


def test_read_only(folder):
    """For root nothing is read-only but a read-only file system, which --mounted looks at."""
    if os.geteuid() == 0:
        return
    old = old_file(folder, "old.vtu")
    os.chmod(old, 0o444)
    refused(SOLID, *COARSE, "-o", old, part="is read-only")
    os.chmod(old, 0o644)
    os.chmod(folder, 0o555)
    refused(SOLID, *COARSE, "-o", old, part="cannot be written")
    os.chmod(folder, 0o755)
    expect_only(folder, "old.vtu")


def test_file_size_limit(folder):
    """From no room at all to a byte too little, where only what is held back to the end is lost."""
    for extension in (*EXTENSIONS, ".vtk", ".inp", ".msh"):
        whole = os.path.join(folder, "whole" + extension)
        assert run(SOLID, *COARSE, "-o", whole).returncode == 0
        size = os.path.getsize(whole)
        os.remove(whole)
        old = old_file(folder, "old" + extension)
        limits = (0, size // 2, size - 3000, size - 1)
        for limit in limits if extension in EXTENSIONS else limits[1::2]:
            refused(
                SOLID, *COARSE, "-o", old,
                # VTK's writer of .vtk files does not say why.
                part="File too large" if limit and extension != ".vtk" else "cannot be written: ",
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
            )
            expect_only(folder, "old" + extension)
        os.remove(old)


def test_damage_is_seen(folder):
    """What a full disk can leave of a .vtu file: a part of it, or blocks of zeros."""
    from hexsweep.files.checking import xml_damage

    path = os.path.join(folder, "whole.vtu")
    assert run(SOLID, *COARSE, "-o", path).returncode == 0
    assert xml_damage(path) == ""
    with open(path, "rb") as file:
        whole = file.read()
    for damaged in (whole[:-12], whole[: len(whole) // 2], whole[:4096] + bytes(4096) + whole[8192:]):
        with open(path, "wb") as file:
            file.write(damaged)
        assert xml_damage(path) != "", len(damaged)


def begun(folder, old):
    """A run that takes long, once it has begun."""
    process = subprocess.Popen(
        command(SOLID, *LONG, "-o", old), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    while len(os.listdir(folder)) < 2:
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.01)
    return process


def test_signals(folder):
    old = old_file(folder, "old.ex2")
    waited = []
    for number, delay in ((signal.SIGINT, 0), (signal.SIGINT, 0.5), (signal.SIGTERM, 0.1)):
        process = begun(folder, old)
        time.sleep(delay)
        process.send_signal(number)
        begin = time.monotonic()
        out, err = process.communicate(timeout=100)  # until the last process has closed them
        waited.append(time.monotonic() - begin)
        assert process.returncode == 128 + number and out == "", (process.returncode, out)
        assert err.startswith("hexsweep: error: interrupted") and err.count("\n") == 1, err
        expect_only(folder, "old.ex2")
    assert min(waited) < 1.0, waited  # a busy machine may delay one, not all


def test_signal_before_waiting(_folder):
    """One that comes after Python has looked for signals, but before it waits for the child, does not
    end the waiting; nor does one that another thread takes, which can be had at will."""
    from hexsweep.process import Interrupted, heard_signals, in_child

    def signal_here():
        time.sleep(0.3)
        signal.pthread_kill(threading.get_ident(), signal.SIGINT)

    begin = time.monotonic()
    try:
        with heard_signals():
            threading.Thread(target=signal_here).start()
            in_child(lambda: time.sleep(60))
        raise AssertionError("nothing was heard")
    except Interrupted as interrupted:
        assert interrupted.number == signal.SIGINT
    assert time.monotonic() - begin < 20, time.monotonic() - begin


def test_many_open_files(_folder):
    """Some ways of waiting know only 1024 descriptors."""
    from hexsweep.process import in_child

    limits = resource.getrlimit(resource.RLIMIT_NOFILE)
    if limits[1] < 1200:
        return
    resource.setrlimit(resource.RLIMIT_NOFILE, (1200, limits[1]))
    files = [os.open(os.devnull, os.O_RDONLY) for _ in range(1100)]
    assert in_child(lambda: 42) == 42
    for file in files:
        os.close(file)
    resource.setrlimit(resource.RLIMIT_NOFILE, limits)


def test_death(folder):
    """The working process is ended from outside, here for its time."""
    old = old_file(folder, "old.vtu")
    refused(
        SOLID, *LONG, "-o", old, part="was ended by SIGXCPU; nothing was written",
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (1, 100)),
    )
    expect_only(folder, "old.vtu")


def test_folder_vanishes(folder):
    """It is moved away while the mesh is made, and a file takes its place."""
    for number, replace in enumerate((False, True)):
        inner = os.path.join(folder, f"inner{number}")
        moved = os.path.join(folder, f"moved{number}")
        os.mkdir(inner)
        process = begun(inner, old_file(inner, "old.vtu"))
        os.rename(inner, moved)
        if replace:
            old_file(folder, f"inner{number}")
        out, err = process.communicate(timeout=100)
        assert process.returncode == 1 and out == "", (process.returncode, out)
        assert err.startswith("hexsweep: error: ") and err.count("\n") == 1, err
        assert "old.vtu: cannot be written" in err, err
        expect_only(moved, "old.vtu")


def test_full_disk():
    """On a small file system of its own, for as long as this process has it."""
    script = (
        'mount -t tmpfs -o size=600k tmpfs "$0" && "$1" "$2" --mounted "$0" && '
        'mount -o remount,ro "$0" && "$1" "$2" --read-only "$0"'
    )
    with temporary_folder() as folder:
        words = ["sh", "-c", "mount -t tmpfs -o size=4k tmpfs " + folder]
        if shutil.which("unshare") is None or subprocess.run(
            ["unshare", "-m", *words], check=False, stderr=subprocess.DEVNULL
        ).returncode:
            print("no file system can be mounted here: the limit of the file size stands in for it")
            return
        words = ["sh", "-c", script, folder, sys.executable, __file__]
        subprocess.run(["unshare", "-m", *words], check=True)


def on_full_disk(folder):
    for extension in EXTENSIONS:
        old = old_file(folder, "old" + extension)
        refused(SOLID, *COARSE, "--layers", "40", "-o", old, part="No space left on device")
        expect_only(folder, "old" + extension)
        os.remove(old)
    old_file(folder, "old.vtu")


def on_read_only(folder):
    refused(SOLID, *COARSE, "-o", os.path.join(folder, "old.vtu"), part="cannot be written")
    refused(SOLID, *COARSE, "-o", os.path.join(folder, "new.vtu"), part="Read-only file system")
    expect_only(folder, "old.vtu")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--mounted"]:
        on_full_disk(sys.argv[2])
    elif sys.argv[1:2] == ["--read-only"]:
        on_read_only(sys.argv[2])
    else:
        test_full_disk()
        for test in (
            test_output_is_checked_before_the_work, test_read_only, test_file_size_limit,
            test_damage_is_seen, test_signals, test_signal_before_waiting,
            test_many_open_files, test_death, test_folder_vanishes,
        ):
            with temporary_folder() as output:
                test(output)
