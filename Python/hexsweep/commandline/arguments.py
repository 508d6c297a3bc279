# SPDX-License-Identifier: BSD-3-Clause
"""The words of the command line."""

import argparse

from vtkmodules.vtkCommonCore import vtkVersion

from .. import __version__
from ..errors import SweepError
from ..files.formats import EXODUS, WRITTEN
from ..files.mesh_reading import READ
from ..files.reading import READERS
from ..sweeps import settings

_DESCRIPTION = f"""Meshes a solid with hexahedra by sweeping.

  hexsweep faces FILE                    lists the faces of the solid (so does a call without -o)
  hexsweep FILE -o part.vtu              meshes it, the best way to sweep it
  hexsweep FILE --source 3 -o part.vtu   meshes it from face 3
  hexsweep assembly.step -o all.vtu      bodies that touch: one conforming mesh
  hexsweep check FILE                    certifies the hexahedra of any mesh

Reads {", ".join(READERS)}; writes {", ".join(WRITTEN)}
({", ".join(EXODUS)}: Exodus II). A file that is called "faces" or "check" is ./faces."""
_CHECKING = f"""Certifies the hexahedra of a mesh, whoever made it.

Reads {", ".join(READ)}."""
_EPILOG = """Exit status: 0 certified, 2 meshed but not certified, 1 refused, failed or wrong usage."""
_EPILOG_CHECKING = """Exit status: 0 all solid cells are certified hexahedra, 2 some are not, 1 refused, failed or
wrong usage."""

# The numbers that a filter takes.
_LARGEST = 2**63 - 1
_MOST_THREADS = 4096


def _whole(text):
    """A whole number that a filter takes; others would be an overflow in the midst of the work."""
    number = int(text)
    if not -_LARGEST - 1 <= number <= _LARGEST:
        raise argparse.ArgumentTypeError(f"{text} is too large a number: give one up to {_LARGEST}")
    return number


_whole.__name__ = "int"  # in argparse's words, and in the help


# These tell faces apart, so they are for listing too.
_OF_FACES = ("feature_angle", "tolerance")


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise SweepError(f"{message}. hexsweep --help tells what there is.")


def parse(words):
    """@return the options: `command`, and of meshing `settings`, those of the filter by property.
    @throw SweepError on wrong usage; SystemExit after --help and --version."""
    first = words[0] if words else ""
    command = first if first in ("faces", "check") else "mesh"
    parser = {"faces": _faces_parser, "check": _check_parser, "mesh": _mesh_parser}[command]()
    options = parser.parse_args(words[1:] if command != "mesh" else words)
    options.command = command
    if command == "mesh" and not (options.output or options.source):
        options.command = "faces"
    if getattr(options, "threads", None) is not None and not 1 <= options.threads <= _MOST_THREADS:
        parser.error(f"--threads {options.threads}: give 1 to {_MOST_THREADS}, or leave it out")
    if command != "check":
        options.settings = _settings(options)
    if options.command == "mesh":
        _check_output(options, parser)
    return options


def _settings(options):
    """Of the filter that meshes, or of those that list, which have fewer."""
    if options.command == "mesh":
        return settings.of_filter(options)
    return {
        name: getattr(options, keyword)
        for keyword, name, _, _ in settings.SETTINGS
        if keyword in _OF_FACES and getattr(options, keyword) is not None
    }


def _check_output(options, parser):
    if not options.output:
        parser.error("name the file to write: -o part.vtu")


def _new_parser(name, description, epilog):
    parser = _Parser(
        prog=name, description=description, epilog=epilog,
        formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False,
    )
    version = f"hexsweep {__version__} (VTK {vtkVersion.GetVTKVersion()})"
    parser.add_argument("--version", action="version", version=version)
    return parser


def _faces_parser():
    parser = _new_parser("hexsweep faces", _DESCRIPTION, _EPILOG)
    _add_solid(parser, _OF_FACES)
    return parser


def _check_parser():
    parser = _new_parser("hexsweep check", _CHECKING, _EPILOG_CHECKING)
    parser.add_argument("mesh", help="a mesh of hexahedra")
    parser.add_argument("--threads", type=_whole, metavar="N", help="how many to use (VTK's choice)")
    _add_reports(parser)
    return parser


def _mesh_parser():
    parser = _new_parser("hexsweep", _DESCRIPTION, _EPILOG)
    _add_solid(parser, [keyword for keyword, *_ in settings.SETTINGS])
    parser.add_argument(
        "--threads", type=_whole, metavar="N", help="how many to use (VTK's choice); the mesh is the same"
    )
    parser.add_argument("-o", "--output", metavar="FILE", help="what to write")
    parser.add_argument("--source", type=_whole, nargs="+", metavar="ID", help="the source faces (found)")
    parser.add_argument("--target", type=_whole, nargs="+", metavar="ID", help="the target faces (found)")
    parser.add_argument("--volume", dest="volumes", type=_whole, nargs="+", metavar="ID", help="bodies (all)")
    parser.add_argument(
        "--separate", action="store_true", help="bodies that touch: each meshed by itself (one conforming mesh)"
    )
    parser.add_argument(
        "--plan", metavar="FILE", help="bodies that touch: the plan of all sweeps, as JSON; it is written, or read and "
        "obeyed where it is there",
    )
    parser.add_argument("--quads", metavar="FILE", help="quads of the source cap (they are made)")
    parser.add_argument(
        "--direction", type=float, nargs=3, metavar=("X", "Y", "Z"),
        help="of a sweep between several caps (found)",
    )
    parser.add_argument("--both-ends", action="store_true", help="layers grow from both caps")
    parser.add_argument(
        "--positions", type=float, nargs="+", metavar="SHARE", help="of the layers, each in (0, 1)"
    )
    parser.add_argument(
        "--method", choices=settings.METHODS, help="how the inside is filled (automatic); for comparison"
    )
    parser.add_argument("--precision", choices=settings.PRECISIONS, help="of coordinates (double)")
    _add_formats(parser)
    _add_reports(parser)
    return parser


def _add_solid(parser, keywords):
    parser.add_argument("solid", help="closed surface of the solid, or a volume mesh")
    parser.add_argument(
        "--faces", metavar="ARRAY",
        help="cell array of face ids (FaceId, then CellEntityIds, then faces by angle)",
    )
    for keyword, _, kind, text in settings.SETTINGS:
        if keyword in keywords:
            own = _whole if kind is int else kind
            parser.add_argument(settings.option(keyword), type=own, metavar=kind.__name__, help=text)


def _add_formats(parser):
    parser.add_argument(
        "--set", dest="set_ids", type=_named_id, action="append", default=[], metavar="NAME=ID",
        help="the id of a set of nodes and sides, in place of its face's",
    )
    parser.add_argument(
        "--no-role-sets", dest="role_sets", action="store_false",
        help="no sets Source, Target and Sides beside those of the faces",
    )
    parser.add_argument(
        "--msh-version", choices=("2.2", "4.1"), default="4.1", help="of gmsh's format (4.1)"
    )
    parser.add_argument("--binary", action="store_true", help=".msh: numbers in binary, not as text")


def _add_reports(parser):
    parser.add_argument("--json", metavar="FILE", help="the whole report, for programs")
    parser.add_argument(
        "--picture", metavar="FILE", help="a .png picture of the hexahedra, cut open and coloured by "
        "scaled Jacobian; needs a display or EGL",
    )


def _named_id(text):
    name, mark, number = text.rpartition("=")
    if not mark or not name or not number.strip().isdigit():
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=ID, with a whole number above 0")
    return name, _whole(number)
