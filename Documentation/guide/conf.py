# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx: the pages of Documentation as HTML, from what is in the repository alone."""

project = "HexSweep"
copyright = "the HexSweep authors, BSD-3-Clause"  # noqa: A001
extensions = ["myst_parser"]
root_doc = "guide/index"
source_suffix = {".md": "markdown"}
exclude_patterns = ["html", "guide/html"]
myst_heading_anchors = 3
html_theme = "alabaster"
html_theme_options = {"page_width": "1100px", "sidebar_width": "250px", "description": "all-hex meshes by sweeping"}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}
html_title = "HexSweep"
html_copy_source = False
html_show_sphinx = False
# Links to files of the repository that are no pages; Testing/Documentation/check_names.py follows all links.
suppress_warnings = ["myst.xref_missing", "ref.myst"]
