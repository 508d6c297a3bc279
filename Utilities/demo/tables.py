# SPDX-License-Identifier: BSD-3-Clause
"""Plain text tables."""


def text_table(columns, rows):
    """Rows of texts below headings that stand above their columns, one word a line.

    `columns` are pairs of a heading and its alignment, "<" or ">".
    """
    headings = [name.split() for name, _ in columns]
    widths = [
        max(len(word) for word in [*heading, *(row[i] for row in rows)])
        for i, heading in enumerate(headings)
    ]
    height = max(len(heading) for heading in headings)
    lines = [[""] * (height - len(heading)) + heading for heading in headings]
    texts = [[line[level] for line in lines] for level in range(height)]
    texts.append(["-" * width for width in widths])
    texts.extend(rows)

    def line(text):
        cells = (f"{cell:{align}{width}}" for cell, (_, align), width in zip(text, columns, widths))
        return "  ".join(cells).rstrip() + "\n"

    return "".join(line(text) for text in texts)
