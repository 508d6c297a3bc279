# SPDX-License-Identifier: BSD-3-Clause
"""The tables of results: which figure stands in which column.

A record is a dictionary as compare.py and sweep_solids.py write them to compare.json and
solids.json. A column is (heading, alignment, text of a record).
"""

from tables import text_table


def _count(name):
    return lambda record: str(record[name])


def _ratio(name):
    return lambda record: f"{record[name]:.3f}"


def _seconds(name):
    return lambda record: f"{record[name]:.2f}"


CASES = [
    ("case", "<", _count("name")),
    ("hexes", ">", _count("hexes")),
    ("inverted affine", ">", _count("inverted_affine")),
    ("inverted Blend", ">", _count("inverted_blend")),
    ("inverted ours", ">", _count("inverted")),
    ("not certified ours", ">", _count("not_certified")),
    ("min SJ", ">", _ratio("min_sj")),
    ("floor SJ", ">", _ratio("floor_sj")),
    ("mean SJ", ">", _ratio("mean_sj")),
    ("CPU seconds", ">", _seconds("seconds")),
    ("what ran", "<", _count("method")),
]

SOLIDS = [
    ("solid", "<", _count("name")),
    ("source quads", "<", _count("source_quads")),
    ("quads", ">", _count("quads")),
    ("layers", ">", _count("layers")),
    ("hexes", ">", _count("hexes")),
    ("inverted", ">", _count("inverted")),
    ("not certified", ">", _count("not_certified")),
    ("min SJ", ">", _ratio("min_sj")),
    ("floor SJ", ">", _ratio("floor_sj")),
    ("mean SJ", ">", _ratio("mean_sj")),
    ("CAD edges", ">", _count("kept_edges")),
    ("CPU seconds", ">", _seconds("seconds")),
]


def record_table(columns, records):
    """The records as plain text, one a line."""
    return text_table(
        [(heading, alignment) for heading, alignment, _ in columns],
        [[text(record) for _, _, text in columns] for record in records],
    )
