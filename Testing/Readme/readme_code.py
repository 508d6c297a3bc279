# SPDX-License-Identifier: BSD-3-Clause
"""The fenced code blocks of README.md, as a reader would paste them."""

import os
import re


def code_block(language):
    """The text of the README's only block of that language.

    Raises ValueError when there is none or more than one.
    """
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "README.md")
    with open(path, encoding="utf-8") as file:
        blocks = re.findall(rf"^```{re.escape(language)}\n(.*?)^```$", file.read(), re.M | re.S)
    if len(blocks) != 1:
        raise ValueError(f"README.md has {len(blocks)} blocks of {language}, not one")
    return blocks[0]
