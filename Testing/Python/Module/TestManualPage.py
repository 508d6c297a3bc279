# SPDX-License-Identifier: BSD-3-Clause
"""The manual page names the options that the command line has, and no other."""

import os
import re

from hexsweep.commandline import arguments
from hexsweep.files import formats

with open(os.path.join(os.environ["HEXSWEEP_SOURCE_DIR"], "Python", "hexsweep.1.in"), encoding="utf-8") as file:
    page = file.read().replace("\\-", "-")

parsers = (arguments._mesh_parser(), arguments._faces_parser(), arguments._check_parser())
options = {word for parser in parsers for action in parser._actions for word in action.option_strings}
assert len(options) > 20, options

# What stands behind .TP is an option and its value.
told = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", "\n".join(re.findall(r"^\.TP\n(.*)$", page, re.M))))
assert told == options, f"only in the page: {told - options}; only in the program: {options - told}"

shown = set(re.findall(r"(?<![\w/])\.[a-z][a-z0-9]*\b", page[page.index("The extension of"):page.index(".SH OPTIONS")]))
assert shown == set(formats.WRITTEN), shown ^ set(formats.WRITTEN)
