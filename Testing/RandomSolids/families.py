# SPDX-License-Identifier: BSD-3-Clause
"""Families of random solids that can be swept.

A family is a function of a random.Random that writes a solid into a profiles.Geo and returns a
Solid: where its two caps are, as tests on points, and what it is called. Coordinates are about 1 to
100; make_solids.py scales them.
"""

import math
from dataclasses import dataclass, field
from typing import Callable

import numpy as np

from profiles import gear_points, holes, letter_points, outline, polygon_points


@dataclass
class Solid:
    source: Callable  # points (n x 3) -> whether each lies on the source cap
    target: Callable
    what: str
    size: float  # a typical length
    tags: list = field(default_factory=list)


def on_plane(point, normal):
    point, normal = np.asarray(point, float), np.asarray(normal, float)
    normal = normal / np.linalg.norm(normal)
    return lambda p: np.abs((p - point) @ normal) < 1e-5


def on_cylinder(radius):
    """About the z axis."""
    return lambda p: np.abs(np.hypot(p[:, 0], p[:, 1]) - radius) < 1e-5


def extruded(geo, surface, vector):
    """Name of a list: the extruded volume is its entry 1."""
    name = geo.name("e")
    x, y, z = vector
    geo.add(f"{name}[] = Extrude {{{x!r}, {y!r}, {z!r}}} {{ Surface{{{surface}}}; }};")
    return name


def volume_of(geo, expression):
    name = geo.name("v")
    geo.add(f"{name}() = {expression};")
    return f"{name}()"


def combined(geo, how, first, second):
    """Difference, Union, Intersection or Fragments of two volumes, which are used up."""
    return volume_of(geo, f"Boolean{how}{{ Volume{{{first}}}; Delete; }}{{ Volume{{{second}}}; Delete; }}")


def imprinted(geo, volume, other):
    """A volume with borders on its surface where it enters another one, which is used up."""
    part = geo.name("i")
    geo.add(f"{part}() = BooleanIntersection{{ Volume{{{volume}}}; }}{{ Volume{{{other}}}; Delete; }};")
    return combined(geo, "Fragments", volume, f"{part}()")


def box(geo, x, y, z, dx, dy, dz, turn=0.0, tilt=0.0):
    """A box, turned about the z axis and tilted about the x axis, both through the origin."""
    name = geo.name("b")
    geo.add(f"{name} = newv; Box({name}) = {{{x!r}, {y!r}, {z!r}, {dx!r}, {dy!r}, {dz!r}}};")
    if tilt:
        geo.add(f"Rotate {{{{1, 0, 0}}, {{0, 0, 0}}, {tilt!r}}} {{ Volume{{{name}}}; }}")
    if turn:
        geo.add(f"Rotate {{{{0, 0, 1}}, {{0, 0, 0}}, {turn!r}}} {{ Volume{{{name}}}; }}")
    return name


def profile(geo, r, size, most_holes):
    loop, inner, kind = outline(geo, r, size)
    return geo.plane([loop] + holes(geo, r, inner, most_holes)), inner, kind


def keep(geo, volume):
    """Says which volume is the solid: of several that share faces, the outer surface."""
    geo.add(f"solid() = {volume};")


def extrusion(geo, r):
    size, height = r.uniform(20, 100), r.uniform(10, 120)
    tags = []
    if r.random() < 0.3:
        points = letter_points(r, size)
        surface, tags = geo.plane([geo.polygon(points)]), ["letter"]
    else:
        surface, _, kind = profile(geo, r, size, 6)
        tags = [kind]
    shift = (0.0, 0.0)
    if r.random() < 0.3:
        shift = (r.uniform(-0.5, 0.5) * height, r.uniform(-0.5, 0.5) * height)
        tags.append("oblique")
    e = extruded(geo, surface, (*shift, height))
    keep(geo, volume_of(geo, f"{e}[1]"))
    return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane((0, 0, height), (0, 0, 1)), "extrusion", size, tags)


def section(geo, r, kind, radius, n, z):
    turn = r.uniform(-0.6, 0.6)
    if kind == "circle":
        return geo.ellipse(radius, radius, 0.0, z)
    if kind == "ellipse":
        return geo.ellipse(radius, radius * r.uniform(0.5, 0.9), turn, z)
    if kind == "rounded":
        return geo.rounded(2 * radius, radius * r.uniform(1.2, 2.0), radius * r.uniform(0.1, 0.3), turn, z)
    return geo.polygon(polygon_points(r, n, radius, 0.15, z, turn))


def loft(geo, r):
    size, height = r.uniform(20, 60), r.uniform(20, 90)
    n = r.randint(4, 8)
    kinds = [r.choice(["circle", "ellipse", "rounded", "poly"]) for _ in range(2)]
    loops = [section(geo, r, kinds[0], size / 2, n, 0.0)]
    if r.random() < 0.5:
        loops.append(section(geo, r, kinds[0], size / 2 * r.uniform(0.7, 1.2), n, height / 2))
    loops.append(section(geo, r, kinds[1], size / 2 * r.uniform(0.6, 1.2), n, height))
    ruled = "Ruled " if r.random() < 0.3 else ""
    v = geo.name("v")
    geo.add(f"{v} = newv; {ruled}ThruSections({v}) = {{{', '.join(str(l) for l in loops)}}};")
    tags = kinds + ([ruled.strip()] if ruled else [])
    if r.random() < 0.4:
        c = geo.name("c")
        radius = size * r.uniform(0.06, 0.13)
        geo.add(f"{c} = newv; Cylinder({c}) = {{0, 0, {-height!r}, 0, 0, {3 * height!r}, {radius!r}}};")
        v = combined(geo, "Difference", v, c)
        tags.append("hole")
    keep(geo, v)
    return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane((0, 0, height), (0, 0, 1)), "loft", size, tags)


def pipe(geo, r):
    size = r.uniform(10, 30)
    surface, _, kind = profile(geo, r, size, 3)
    if r.random() < 0.5:
        bend = math.radians(r.uniform(20, 170))
        reach = size * r.uniform(0.8, 2.5)
        e = geo.name("e")
        geo.add(f"{e}[] = Extrude {{{{0, 1, 0}}, {{{reach!r}, 0, 0}}, {bend!r}}} {{ Surface{{{surface}}}; }};")
        keep(geo, volume_of(geo, f"{e}[1]"))
        centre = (reach - reach * math.cos(bend), 0.0, reach * math.sin(bend))
        normal = (math.sin(bend), 0.0, math.cos(bend))
        return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane(centre, normal), "pipe", size, [kind, "arc"])
    length = size * r.uniform(2, 4)
    a = np.array([0.0, 0.0, length * 0.4])
    b = np.array([r.uniform(-1, 1), r.uniform(-1, 1), 2.0]) * length * 0.4
    c = b + np.array([r.uniform(-0.4, 0.4), r.uniform(-0.4, 0.4), 0.8]) * length * 0.4
    points = [np.zeros(3), a, b, c]
    ids = []
    for p in points:
        geo.points += 1
        ids.append(str(geo.points))
        geo.add(f"Point({geo.points}) = {{{float(p[0])!r}, {float(p[1])!r}, {float(p[2])!r}}};")
    geo.curves += 1
    geo.add(f"Bezier({geo.curves}) = {{{', '.join(ids)}}};")
    geo.add(f"Wire({geo.loops + 1}) = {{{geo.curves}}};")
    geo.loops += 1
    e = geo.name("e")
    geo.add(f"{e}[] = Extrude {{ Surface{{{surface}}}; }} Using Wire {{{geo.loops}}};")
    keep(geo, volume_of(geo, "Volume{:}"))
    return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane(c, c - b), "pipe", size, [kind, "spline"])


def cut_caps(geo, r):
    size, height = r.uniform(20, 80), r.uniform(30, 120)
    surface, _, kind = profile(geo, r, size, 4)
    e = extruded(geo, surface, (0.0, 0.0, height))
    v = volume_of(geo, f"{e}[1]")
    tags = [kind]
    source, target = on_plane((0, 0, 0), (0, 0, 1)), on_plane((0, 0, height), (0, 0, 1))
    how = r.choice(["plane", "sphere", "cylinder", "planes"])
    tags.append(how)
    if how in ("plane", "planes"):
        tilt = math.radians(r.uniform(5, 40))
        big = 10 * size + 10 * height
        drop = height - 0.5 * size * math.tan(tilt) * 1.05
        if drop < 0.2 * height:
            tilt, drop = math.radians(8), height - 0.55 * size * math.tan(math.radians(8))
        name = box(geo, -big / 2, -big / 2, 0.0, big, big, big, 0.0, tilt)
        turn = r.uniform(0, 6)
        geo.add(f"Rotate {{{{0, 0, 1}}, {{0, 0, 0}}, {turn!r}}} {{ Volume{{{name}}}; }}")
        geo.add(f"Translate {{0, 0, {drop!r}}} {{ Volume{{{name}}}; }}")
        normal = (math.sin(turn) * math.sin(tilt), -math.cos(turn) * math.sin(tilt), math.cos(tilt))
        target = on_plane((0, 0, drop), normal)
        v = combined(geo, "Difference", v, name)
        if how == "planes":
            tilt = -min(tilt, math.atan(0.5 * drop / size))
            name = box(geo, -big / 2, -big / 2, -big, big, big, big, turn + 1.0, tilt)
            rise = 0.55 * size * math.tan(-tilt)
            geo.add(f"Translate {{0, 0, {rise!r}}} {{ Volume{{{name}}}; }}")
            turn += 1.0
            normal = (math.sin(turn) * math.sin(tilt), -math.cos(turn) * math.sin(tilt), math.cos(tilt))
            source = on_plane((0, 0, rise), normal)
            v = combined(geo, "Difference", v, name)
    elif how == "sphere":
        radius = size * r.uniform(0.8, 2.0)
        centre = height * r.uniform(0.95, 1.05) - (0.0 if r.random() < 0.5 else radius)
        hollow = centre > 0.5 * height
        centre = height + radius * 0.75 if hollow else height - radius
        name = geo.name("s")
        geo.add(f"{name} = newv; Sphere({name}) = {{0, 0, {centre!r}, {radius!r}}};")
        if hollow:
            v = combined(geo, "Difference", v, name)
            # The bowl must reach the sides, or the cap is no cap.
            if radius * radius - (0.75 * radius) ** 2 < (0.55 * size) ** 2:
                return None
        else:
            if radius < 0.75 * size:
                return None
            cut = geo.name("s")
            geo.add(f"{cut} = newv; Cylinder({cut}) = {{0, 0, {-height!r}, 0, 0, {height + centre!r}, {2 * size!r}}};")
            joined = combined(geo, "Union", name, cut)
            v = combined(geo, "Intersection", v, joined)
        target = lambda p: np.abs(np.linalg.norm(p - np.array([0, 0, centre]), axis=1) - radius) < 1e-5
    else:
        radius = size * r.uniform(0.8, 2.0)
        turn = r.uniform(0, 6)
        name = geo.name("c")
        axis = np.array([math.cos(turn), math.sin(turn), 0.0])
        start = -5 * size * axis + np.array([0, 0, height + 0.75 * radius])
        if radius * radius - (0.75 * radius) ** 2 < (0.55 * size) ** 2:
            return None
        geo.add(f"{name} = newv; Cylinder({name}) = {{{float(start[0])!r}, {float(start[1])!r}, {float(start[2])!r}, "
                f"{float(10 * size * axis[0])!r}, {float(10 * size * axis[1])!r}, 0, {radius!r}}};")
        v = combined(geo, "Difference", v, name)

        def target(p):
            d = p - start
            d = d - np.outer(d @ axis, axis)
            return np.abs(np.linalg.norm(d, axis=1) - radius) < 1e-5
    keep(geo, v)
    return Solid(source, target, "cut caps", size, tags)


def revolution(geo, r):
    size = r.uniform(10, 40)
    surface, _, kind = profile(geo, r, size, 2)
    angle = math.radians(r.uniform(40, 320))
    reach = size * r.uniform(0.6, 3.0)
    e = geo.name("e")
    turn = r.uniform(0, 3)
    axis = (math.cos(turn), math.sin(turn), 0.0)
    at = np.array([-math.sin(turn), math.cos(turn), 0.0]) * reach
    geo.add(f"{e}[] = Extrude {{{{{axis[0]!r}, {axis[1]!r}, 0}}, {{{float(at[0])!r}, {float(at[1])!r}, 0}}, {angle!r}}} "
            f"{{ Surface{{{surface}}}; }};")
    keep(geo, volume_of(geo, f"{e}[1]"))
    axis = np.array(axis)
    # Rodrigues: where the profile's centre and normal go.
    turned = lambda v: v * math.cos(angle) + np.cross(axis, v) * math.sin(angle) + axis * (axis @ v) * (1 - math.cos(angle))
    return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane(at + turned(-at), turned(np.array([0, 0, 1.0]))),
                 "revolution", size, [kind])


def side_features(geo, r):
    size, height = r.uniform(30, 80), r.uniform(20, 100)
    surface, inner, kind = profile(geo, r, size, 3)
    e = extruded(geo, surface, (0.0, 0.0, height))
    v = volume_of(geo, f"{e}[1]")
    tags = [kind]
    features = r.sample(["groove", "rib", "tilted", "hplanes", "vplane", "capbox"], r.randint(1, 3))
    if "rib" in features and "groove" in features:
        features.remove("rib")
    big = 3 * (size + height)
    turn = r.uniform(0, 6)
    for feature in sorted(features):
        if feature == "groove":
            deep, wide = inner * r.uniform(0.04, 0.1), height * r.uniform(0.1, 0.2)
            name = box(geo, inner - deep + (0 if kind in ("circle", "rounded", "rectangle") else deep), -big, height * 0.4, big, 2 * big, wide, turn)
            v = combined(geo, "Difference", v, name)
        elif feature == "rib":
            deep, wide = inner * r.uniform(0.04, 0.1), height * r.uniform(0.1, 0.2)
            long = inner * r.uniform(0.3, 0.6)
            name = box(geo, 0.3 * inner, -long / 2, height * 0.4, 0.0 + size / 2 - 0.3 * inner + deep, long, wide, turn)
            v = combined(geo, "Union", v, name)
    for feature in sorted(features):
        pieces = []
        if feature == "tilted":
            tilt = math.radians(r.uniform(15, 50))
            pieces.append(("plane", tilt, r.uniform(0, 6), height * r.uniform(0.4, 0.6)))
        elif feature == "hplanes":
            for k in range(r.randint(1, 2)):
                pieces.append(("plane", 0.0, 0.0, height * (0.3 + 0.37 * k)))
        elif feature == "vplane":
            pieces.append(("plane", math.pi / 2, r.uniform(0, 6), 0.0))
        elif feature == "capbox":
            w = inner * r.uniform(0.5, 1.0)
            name = box(geo, 0.25 * inner, -w / 2, height * 0.7, size, w, height, r.uniform(0, 6))
            v = imprinted(geo, v, name)
        for _, tilt, spin, z in pieces:
            name = box(geo, -big, -big, 0.0, 2 * big, 2 * big, 2 * big, spin, tilt)
            geo.add(f"Translate {{0, 0, {z!r}}} {{ Volume{{{name}}}; }}")
            v = imprinted(geo, v, name)
    keep(geo, v)
    return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane((0, 0, height), (0, 0, 1)), "side features", size,
                 tags + sorted(features))


def thin_wall(geo, r):
    size = r.uniform(20, 80)
    if r.random() < 0.5:
        # A frame: an outline and the same one shrunk.
        ratio = r.uniform(10, 45)
        height = size * r.uniform(0.3, 2.0)
        kind = r.choice(["circle", "rounded", "poly"])
        wall = size / ratio
        if kind == "circle":
            loops = [geo.ellipse(size / 2, size / 2, 0, 0.0), geo.ellipse(size / 2 - wall, size / 2 - wall, 0, 0.0)]
        elif kind == "rounded":
            h, radius = size * r.uniform(0.5, 1.0), size * 0.12
            loops = [geo.rounded(size, h, radius, 0.0, 0.0),
                     geo.rounded(size - 2 * wall, h - 2 * wall, radius - wall, 0.0, 0.0)]
        else:
            points = polygon_points(r, r.randint(3, 7), size / 2, 0.2)
            factor = 1 - 2.5 * wall / size * 2
            loops = [geo.polygon(points), geo.polygon([(factor * x, factor * y, z) for x, y, z in points])]
        e = extruded(geo, geo.plane(loops), (0.0, 0.0, height))
        keep(geo, volume_of(geo, f"{e}[1]"))
        return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane((0, 0, height), (0, 0, 1)), "thin wall", size,
                     ["frame", kind, f"{ratio:.0f}"])
    # A part of a cylinder's shell, swept through its thickness.
    radius, ratio = size / 2, r.uniform(10, 50)
    wall = radius / ratio
    height = size * r.uniform(0.4, 1.5)
    angle = r.choice([2 * math.pi, math.radians(r.uniform(40, 300))])
    shell = []
    for rho in (radius, radius - wall):
        name = geo.name("c")
        sweep = "" if angle > 6.28 else f", {angle!r}"
        geo.add(f"{name} = newv; Cylinder({name}) = {{0, 0, 0, 0, 0, {height!r}, {rho!r}{sweep}}};")
        shell.append(name)
    v = combined(geo, "Difference", shell[0], shell[1])
    count = r.randint(0, 3)
    for k in range(count):
        name = geo.name("c")
        around = 0.5 * angle if angle < 6.28 else 2 * math.pi * k / count
        if angle < 6.28 and k > 0:
            break
        hole = min(height, radius * min(angle, 2.0)) * r.uniform(0.1, 0.25)
        geo.add(f"{name} = newv; Cylinder({name}) = {{0, 0, {height / 2!r}, {2 * size * math.cos(around)!r}, "
                f"{2 * size * math.sin(around)!r}, 0, {hole!r}}};")
        v = combined(geo, "Difference", v, name)
    keep(geo, v)
    return Solid(on_cylinder(radius), on_cylinder(radius - wall), "thin wall", size,
                 ["cylinder", f"{ratio:.0f}", f"{count} holes", f"{math.degrees(angle):.0f} degrees"])


def gear(geo, r):
    n = r.randint(8, 28)
    size = r.uniform(20, 80)
    tip = size / 2
    root = tip * (1 - r.uniform(2.0, 4.0) / n)
    outer = geo.polygon(gear_points(n, root, tip))
    loops = [outer]
    if r.random() < 0.8:
        bore = root * r.uniform(0.15, 0.6)
        loops.append(geo.ellipse(bore, bore, 0.0, 0.0))
    surface = geo.plane(loops)
    height = size * r.uniform(0.1, 0.8)
    twist = r.choice([0.0, math.radians(r.uniform(5, 40))])
    e = geo.name("e")
    if twist:
        geo.add(f"{e}[] = Extrude {{{{0, 0, {height!r}}}, {{0, 0, 1}}, {{0, 0, 0}}, {twist!r}}} {{ Surface{{{surface}}}; }};")
    else:
        geo.add(f"{e}[] = Extrude {{0, 0, {height!r}}} {{ Surface{{{surface}}}; }};")
    keep(geo, volume_of(geo, f"{e}[1]"))
    return Solid(on_plane((0, 0, 0), (0, 0, 1)), on_plane((0, 0, height), (0, 0, 1)), "gear", size,
                 [f"{n} teeth"] + (["helical"] if twist else []))


FAMILIES = {
    "a": extrusion,
    "b": loft,
    "c": pipe,
    "d": cut_caps,
    "e": revolution,
    "f": side_features,
    "g": thin_wall,
    "h": gear,
}
