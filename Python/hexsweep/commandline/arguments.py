# SPDX-License-Identifier: BSD-3-Clause
"""The words of the command line."""

import argparse
import os

from vtkmodules.vtkCommonCore import vtkVersion

from .. import __version__
from .messages import Refusal
from .reading import READERS
from .writing import WRITTEN

_DESCRIPTION = f"""Meshes a solid with hexahedra by sweeping.

  hexsweep faces FILE                    lists the faces of the solid (so does a call without -o)
  hexsweep FILE -o part.vtu              meshes it, the best way to sweep it
  hexsweep FILE --source 3 -o part.vtu   meshes it from face 3

Reads {", ".join(READERS)}; writes {", ".join(WRITTEN)} (all but .vtu: Exodus II). A file that is
called "faces" is ./faces."""
_EPILOG = """Exit status: 0 certified, 2 meshed but not certified, 1 refused, failed or wrong usage."""

# Option, property of vtkOneToOneSweep, type, help. What is not given is the filter's own default.
_SETTINGS = (
    ("--size", "Size", float, "edge length of the hexahedra (chosen)"),
    ("--layers", "NumberOfLayers", int, "number of layers"),
    ("--layer-size", "LayerSize", float, "or their thickness"),
    ("--growth", "GrowthRatio", float, "thickness of a layer over the last"),
    ("--quad-size", "QuadSize", float, "edge length of quads made"),
    ("--feature-angle", "FeatureAngle", float, "without face ids: degrees between two faces"),
    ("--tolerance", "MatchTolerance", float, "distance over edge length up to which points are one"),
)
# These tell faces apart, so they are for listing too.
_OF_FACES = ("FeatureAngle", "MatchTolerance")


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Refusal(f"{message}. hexsweep --help tells what there is.")


def parse(words):
    """@return the options; `settings` are those of the filter by property.
    @throw Refusal on wrong usage; SystemExit after --help and --version."""
    only_faces = list(words[:1]) == ["faces"]
    parser = _parser(only_faces)
    options = parser.parse_args(words[1:] if only_faces else words)
    options.settings = {
        name: getattr(options, name) for _, name, _, _ in _SETTINGS if getattr(options, name, None) is not None
    }
    options.only_faces = only_faces or not (options.output or options.source)
    if options.only_faces:
        options.settings = {k: v for k, v in options.settings.items() if k in _OF_FACES}
    elif not options.output:
        parser.error("name the file to write: -o part.vtu")
    elif options.threads is not None and options.threads < 1:
        parser.error(f"--threads {options.threads}: give 1 or more, or leave it out")
    elif os.path.splitext(options.output)[1].lower() not in WRITTEN:
        parser.error(f"{options.output}: only {', '.join(WRITTEN)} files are written")
    return options


def _parser(only_faces):
    parser = _Parser(
        prog="hexsweep faces" if only_faces else "hexsweep", description=_DESCRIPTION,
        epilog=_EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False,
    )
    parser.add_argument("solid", help="closed surface of the solid, or a volume mesh")
    parser.add_argument(
        "--faces", metavar="ARRAY",
        help="cell array of face ids (FaceId, then CellEntityIds, then faces by angle)",
    )
    for option, name, kind, text in _SETTINGS:
        if name in _OF_FACES or not only_faces:
            parser.add_argument(option, dest=name, type=kind, metavar=kind.__name__, help=text)
    if not only_faces:
        _add_meshing(parser)
    version = f"hexsweep {__version__} (VTK {vtkVersion.GetVTKVersion()})"
    parser.add_argument("--version", action="version", version=version)
    return parser


def _add_meshing(parser):
    parser.add_argument(
        "--threads", type=int, metavar="N", help="how many to use (VTK's choice); the mesh is the same"
    )
    parser.add_argument("-o", "--output", metavar="FILE", help="what to write")
    parser.add_argument("--source", type=int, nargs="+", metavar="ID", help="the source faces (found)")
    parser.add_argument("--target", type=int, nargs="+", metavar="ID", help="the target faces (found)")
    parser.add_argument("--volume", dest="volumes", type=int, nargs="+", metavar="ID", help="bodies (all)")
    parser.add_argument("--quads", metavar="FILE", help="quads of the source cap (they are made)")
    parser.add_argument("--both-ends", action="store_true", help="layers grow from both caps")
    parser.add_argument(
        "--positions", type=float, nargs="+", metavar="SHARE", help="of the layers, each in (0, 1)"
    )
    parser.add_argument(
        "--no-role-sets", dest="role_sets", action="store_false",
        help="Exodus II: no sets Source, Target and Sides beside those of the faces",
    )
