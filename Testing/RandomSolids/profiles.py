# SPDX-License-Identifier: BSD-3-Clause
"""Plane profiles of random solids, as text for gmsh's OpenCASCADE kernel."""

import math


class Geo:
    """Collects the lines of a .geo script and hands out numbers of entities."""

    def __init__(self):
        self.lines = ['SetFactory("OpenCASCADE");']
        self.names = 0
        self.points = 1000
        self.curves = 1000
        self.loops = 1000
        self.surfaces = 1000

    def add(self, line):
        self.lines.append(line)

    def name(self, stem):
        self.names += 1
        return f"{stem}{self.names}"

    def polygon(self, points):
        """Curve loop through points (x, y, z)."""
        first = self.points + 1
        for point in points:
            self.points += 1
            x, y, z = (repr(float(c)) for c in point)
            self.add(f"Point({self.points}) = {{{x}, {y}, {z}}};")
        n = len(points)
        edges = []
        for i in range(n):
            self.curves += 1
            edges.append(str(self.curves))
            self.add(f"Line({self.curves}) = {{{first + i}, {first + (i + 1) % n}}};")
        self.loops += 1
        self.add(f"Curve Loop({self.loops}) = {{{', '.join(edges)}}};")
        return self.loops

    def ellipse(self, a, b, rotation, z):
        """Curve loop of an ellipse about the z axis."""
        self.curves += 1
        a, b = max(a, b), min(a, b)
        kind = f"Ellipse({self.curves}) = {{0, 0, {z!r}, {a!r}, {b!r}}};"
        self.add(kind if a > b else f"Circle({self.curves}) = {{0, 0, {z!r}, {a!r}}};")
        if rotation:
            self.add(f"Rotate {{{{0, 0, 1}}, {{0, 0, 0}}, {rotation!r}}} {{ Curve{{{self.curves}}}; }}")
        self.loops += 1
        self.add(f"Curve Loop({self.loops}) = {{{self.curves}}};")
        return self.loops

    def rounded(self, w, h, radius, rotation, z):
        """Curve loop of a rectangle w x h with round corners."""
        corners = [(1, -1), (1, 1), (-1, 1), (-1, -1)]
        turn = lambda x, y: (x * math.cos(rotation) - y * math.sin(rotation),
                             x * math.sin(rotation) + y * math.cos(rotation), z)
        ids, edges = [], []
        for k, (sx, sy) in enumerate(corners):
            cx, cy = sx * (w / 2 - radius), sy * (h / 2 - radius)
            start = [(0, -1), (1, 0), (0, 1), (-1, 0)][k]
            end = [(1, 0), (0, 1), (-1, 0), (0, -1)][k]
            for dx, dy in (start, (0, 0), end):
                self.points += 1
                p = turn(cx + dx * radius, cy + dy * radius)
                self.add(f"Point({self.points}) = {{{p[0]!r}, {p[1]!r}, {p[2]!r}}};")
                ids.append(self.points)
        for k in range(4):
            self.curves += 1
            a, c, b = ids[3 * k:3 * k + 3]
            self.add(f"Circle({self.curves}) = {{{a}, {c}, {b}}};")
            edges.append(str(self.curves))
            self.curves += 1
            self.add(f"Line({self.curves}) = {{{b}, {ids[(3 * k + 3) % 12]}}};")
            edges.append(str(self.curves))
        self.loops += 1
        self.add(f"Curve Loop({self.loops}) = {{{', '.join(edges)}}};")
        return self.loops

    def plane(self, loops):
        self.surfaces += 1
        self.add(f"Plane Surface({self.surfaces}) = {{{', '.join(str(l) for l in loops)}}};")
        return self.surfaces


def polygon_points(r, n, radius, jitter, z=0.0, rotation=0.0):
    """A star-shaped polygon about the z axis."""
    turn = r.uniform(0.0, 2.0 * math.pi) + rotation
    points = []
    for i in range(n):
        angle = turn + 2.0 * math.pi * (i + r.uniform(-0.2, 0.2)) / n
        rho = radius * r.uniform(1.0 - jitter, 1.0)
        points.append((rho * math.cos(angle), rho * math.sin(angle), z))
    return points


def moved(points, x, y):
    return [(p[0] + x, p[1] + y, p[2]) for p in points]


def letter_points(r, size):
    """An L, T or U of a given size, about the origin."""
    t = r.uniform(0.3, 0.42)
    shape = r.choice("LTU")
    if shape == "L":
        p = [(0, 0), (1, 0), (1, t), (t, t), (t, 1), (0, 1)]
    elif shape == "T":
        a, b = 0.5 - t / 2, 0.5 + t / 2
        p = [(0, 1 - t), (a, 1 - t), (a, 0), (b, 0), (b, 1 - t), (1, 1 - t), (1, 1), (0, 1)]
    else:
        t *= 0.8
        p = [(0, 0), (1, 0), (1, 1), (1 - t, 1), (1 - t, t), (t, t), (t, 1), (0, 1)]
    return [(size * (x - 0.5), size * (y - 0.5), 0.0) for x, y in p]


def gear_points(n, root, tip):
    """Straight-flanked teeth."""
    points = []
    for i in range(n):
        for part, rho in ((0.0, root), (0.3, root), (0.42, tip), (0.88, tip)):
            angle = 2.0 * math.pi * (i + part) / n
            points.append((rho * math.cos(angle), rho * math.sin(angle), 0.0))
    return points


def outline(geo, r, size):
    """Outer loop of a random profile at z = 0, within a square of the given size; and the radius of
    a disk about the origin inside it."""
    kind = r.choice(["circle", "ellipse", "rounded", "poly", "rectangle"])
    half = size / 2
    if kind == "circle":
        return geo.ellipse(half, half, 0.0, 0.0), half, kind
    if kind == "ellipse":
        b = half * r.uniform(0.45, 0.9)
        return geo.ellipse(half, b, r.uniform(0.0, 3.0), 0.0), b, kind
    if kind == "rounded":
        h = size * r.uniform(0.5, 1.0)
        return geo.rounded(size, h, h * r.uniform(0.08, 0.35), r.uniform(0.0, 3.0), 0.0), h / 2, kind
    if kind == "rectangle":
        h = size * r.uniform(0.4, 1.0)
        points = [(-half, -h / 2, 0), (half, -h / 2, 0), (half, h / 2, 0), (-half, h / 2, 0)]
        return geo.polygon(points), h / 2, kind
    n = r.randint(5, 9)
    points = polygon_points(r, n, half, 0.25)
    return geo.polygon(points), 0.72 * half * math.cos(math.pi * 1.4 / n), kind


def holes(geo, r, radius, most):
    """Loops of holes within a disk about the origin, none touching another."""
    count = r.randint(0, most)
    loops = []
    if count == 0:
        return loops
    if count == 1:
        centres, room = [(0.0, 0.0)], 0.62 * radius
    else:
        ring = 0.58 * radius
        turn = r.uniform(0.0, 6.0)
        centres = [(ring * math.cos(turn + 2 * math.pi * k / count),
                    ring * math.sin(turn + 2 * math.pi * k / count)) for k in range(count)]
        room = min(0.32 * radius, 0.8 * ring * math.sin(math.pi / count))
    for x, y in centres:
        size = room * r.uniform(0.4, 1.0)
        if r.random() < 0.6:
            geo.curves += 1
            geo.add(f"Circle({geo.curves}) = {{{x!r}, {y!r}, 0, {size!r}}};")
            geo.loops += 1
            geo.add(f"Curve Loop({geo.loops}) = {{{geo.curves}}};")
            loops.append(geo.loops)
        else:
            loops.append(geo.polygon(moved(polygon_points(r, r.choice([3, 4, 6]), size, 0.1), x, y)))
    return loops
