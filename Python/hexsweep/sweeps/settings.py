# SPDX-License-Identifier: BSD-3-Clause
"""What can be chosen of a sweep: the same words for the command line and for Python.

A keyword `layer_size` of hexsweep.sweep() is the option --layer-size.
"""

import re

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from .. import vtkCageHexInterior
from ..errors import SweepError

# Keyword, property of the filter, type, help. What is not given is the filter's own default.
SETTINGS = (
    ("size", "Size", float, "edge length of the hexahedra (chosen)"),
    ("layers", "NumberOfLayers", int, "number of layers"),
    ("layer_size", "LayerSize", float, "or their thickness"),
    ("growth", "GrowthRatio", float, "thickness of a layer over the last"),
    ("quad_size", "QuadSize", float, "edge length of quads made"),
    ("feature_angle", "FeatureAngle", float, "without face ids: degrees between two faces"),
    ("draft", "DraftAngle", float, "several caps: degrees that sides may lean"),
    ("imprint_tolerance", "ImprintTolerance", float,
     "several caps: distance over size up to which their curves are one"),
    ("tolerance", "MatchTolerance", float, "distance over edge length up to which points are one"),
)


def _enumeration(cls, kind):
    """@return the values of an enumeration of a wrapped class by their names as words, in their order."""
    values = {name: value for name, value in vars(cls).items() if isinstance(value, kind)}
    return {name.lower().replace("_", "-"): values[name] for name in sorted(values, key=values.get)}


METHODS = _enumeration(vtkCageHexInterior, vtkCageHexInterior.MethodType)
PRECISIONS = {"single": vtkAlgorithm.SINGLE_PRECISION, "double": vtkAlgorithm.DOUBLE_PRECISION}
# Only sweeps between several caps have these.
_OF_SEVERAL_CAPS = ("DraftAngle", "ImprintTolerance")
_OPTION = re.compile(r"--([a-z]+(?:-[a-z]+)*)")


def name_of(solid):
    """@param solid: the name of a file, or a data set."""
    return solid if isinstance(solid, str) else "the solid"


def option(keyword):
    return "--" + keyword.replace("_", "-")


def as_keywords(text):
    """A message of the command line with Python's words for its options."""
    return _OPTION.sub(lambda match: match.group(1).replace("-", "_"), text)


def of_filter(options):
    """@return the settings of the filter by property, of those that are given."""
    settings = {
        name: getattr(options, keyword)
        for keyword, name, _, _ in SETTINGS if getattr(options, keyword, None) is not None
    }
    if options.method:
        settings["Method"] = METHODS[options.method]
    if options.precision:
        settings["OutputPointsPrecision"] = PRECISIONS[options.precision]
    return settings


def is_between_two(options):
    """Whether words are given that only a sweep between two caps has; without them each body is swept
    between two caps where it has two, else between all of its caps."""
    given = (options.source, options.target, options.quads, options.positions, options.both_ends)
    properties = ("Method", "QuadSize", "GrowthRatio")
    return any(given) or any(name in options.settings for name in properties)


def check(options):
    """@throw SweepError where words contradict each other."""
    several = options.direction or any(name in options.settings for name in _OF_SEVERAL_CAPS)
    if several and is_between_two(options):
        raise SweepError(
            "--direction, --draft and --imprint-tolerance are for sweeps between several caps; --source, "
            "--target, --quads, --quad-size, --positions, --growth, --both-ends and --method are for those "
            "between two: give some of the ones or of the others."
        )
