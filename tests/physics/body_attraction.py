#!/usr/bin/env python3
"""Attraction of a blunt tip by the sample beside an asperity, docs/theory.md 3.8: limits by mpmath,
and the shipped film under a tip of 2 um, by a sum over its spline on circles, beside
`asperity explore`. Usage: body_attraction.py ASPERITY [PLACES]    PLACES: of ten on the film; default 4"""

import json
import math
import sys

import mpmath
import numpy
from mpmath import mp, mpf

from common import COHESIVE_RANGE, DATA, Checks, Program, read_scan

D0 = 0.165e-9                          # m
NEAREST = D0 + float(COHESIVE_RANGE)   # m, nearer the law's own cohesion acts
WORK = 0.2                             # J/m^2
HAMAKER = 12 * math.pi * WORK * D0**2  # J
TIP = 2e-6                             # m

# Limits, by elements of surface across a separation g: H/(6 pi) g^3/(g^3 + NEAREST^3)^2 each.


def beside(gap, of_law, end):
    """-force: integral over the cap of the traction across `gap`, less that across `of_law`, functions
    of the distance from the axis."""
    def part(distance):
        near = mpf(NEAREST)**3
        cubes = gap(distance)**3, of_law(distance)**3
        return distance * (cubes[0] / (cubes[0] + near)**2 - cubes[1] / (cubes[1] + near)**2)
    positions = [0] + [end * mpf(2)**-i for i in range(14, -1, -1)]
    return mpf(HAMAKER) / 3 * mpmath.quad(part, positions)


def check_limits(checks):
    tip = mpf(TIP)

    def cap(distance):
        return distance**2 / (tip + mpmath.sqrt(tip**2 - distance**2))
    touch = mpf(D0)
    checks.holds("a plane has nothing beside the contact", beside(
        lambda r: touch + cap(r), lambda r: touch + cap(r), tip) == 0, 0)
    for height in (5e-9, 20e-9, 50e-9):
        sharp = mpf("0.2e-9")  # radius of an asperity: a needle

        def gap(distance, height=mpf(height), sharp=sharp):
            rise = height * mpmath.exp(-distance**2 / (2 * sharp * height))
            return touch + cap(distance) + height - rise
        found = beside(gap, lambda r: touch + cap(r) + r**2 / (2 * sharp), tip)
        separation = mpf(D0) + height
        plane = mpf(HAMAKER) * tip / (6 * separation**2)
        # The flanks are no paraboloid: a part of what the law counts of it.
        own = mpf(HAMAKER) * sharp / (6 * mpf(NEAREST)**2) / 4
        checks.near(f"needle of {height * 1e9:g} nm: sphere and half-space at that distance", found,
                    plane, 1, size=own + plane * (separation / tip) * 2)
    for separation in (1e-9, 10e-9, 100e-9):
        exact = mpf(2) / 3 * mpf(HAMAKER) * tip**3 / (separation**2 * (separation + 2 * tip)**2)
        elements = mpf(HAMAKER) / 3 * mpmath.quad(
            lambda r, d=mpf(separation): r / (d + cap(r))**3,
            [0] + [tip * mpf(2)**-i for i in range(14, -1, -1)])
        checks.near(f"elements of surface against all pairs of atoms, {separation * 1e9:g} nm",
                    elements, exact, 0.3 * (separation / TIP)**2)


# The shipped film under the tip, by elements of its surface along z.


def traction(separation):
    """Over H/(6 pi)."""
    cube = numpy.maximum(separation, 0)**3
    return cube / (cube + NEAREST**3)**2


def of_paraboloid(radius, separation):
    """Integral of the traction over a paraboloid at this distance, over 2 pi and H/(6 pi) 6 pi: in closed
    form, by parts from that of 1/(g^3 + NEAREST^3)."""
    separation = max(separation, 0)
    end = NEAREST
    root = math.sqrt(3)
    arc = math.pi / 2 - math.atan((2 * separation - end) / (root * end))
    logarithm = math.log((separation + end)**2 / (separation**2 - separation * end + end**2))
    whole = arc / (root * end**2) - logarithm / (6 * end**2)
    return radius / 9 * (whole + separation / (separation**3 + end**3))


FINER = 4  # positions a pixel, along each axis
STIFFNESS = 1000.0  # N/m: the tip stays where it is put
SQUARES = 0.003     # of pull-off: some hundred squares of 3e-5


class Spline:
    """Cubic B-spline through a scan that a Gaussian of one pixel has smoothed; beyond the scan it goes
    on as at its edge."""

    def __init__(self, heights, pitch):
        side = len(heights)
        taps = numpy.arange(-5, 6)
        weights = numpy.exp(-taps**2 / 2)
        smooth = numpy.zeros((side, side))
        through = numpy.zeros((side, side))  # the spline at the pixels; its ends do not matter here
        for i in range(side):
            for tap, weight in zip(taps, weights / weights.sum()):
                smooth[i, min(max(i + tap, 0), side - 1)] += weight
            for tap, weight in ((-1, 1 / 6), (0, 2 / 3), (1, 1 / 6)):
                through[i, min(max(i + tap, 0), side - 1)] += weight
        fine = numpy.zeros((side * FINER, side))
        for i in range(side * FINER):
            position = (i + 0.5) / FINER - 0.5
            for tap in range(math.floor(position) - 1, math.floor(position) + 3):
                away = abs(position - tap)
                weight = 2 / 3 - away**2 + away**3 / 2 if away < 1 else max(2 - away, 0)**3 / 6
                fine[i, min(max(tap, 0), side - 1)] += weight
        along = fine @ numpy.linalg.solve(through, smooth)
        self.heights = along @ numpy.asarray(heights)[::-1] @ along.T  # rows upwards
        self.pitch = pitch / FINER
        self.positions = (numpy.arange(side * FINER) + 0.5) * self.pitch

    def at(self, x, y):
        """Heights, bilinear between the fine positions."""
        last = len(self.heights) - 1
        column = numpy.clip(x / self.pitch - 0.5, 0, last)
        row = numpy.clip(y / self.pitch - 0.5, 0, last)
        i = numpy.minimum(row.astype(int), last - 1)
        k = numpy.minimum(column.astype(int), last - 1)
        up, right = row - i, column - k
        low = (1 - right) * self.heights[i, k] + right * self.heights[i, k + 1]
        high = (1 - right) * self.heights[i + 1, k] + right * self.heights[i + 1, k + 1]
        return (1 - up) * low + up * high

    def touch(self, x, y):
        """Height of the apex where the tip first touches [m]."""
        square = (self.positions[None, :] - x)**2 + (self.positions[:, None] - y)**2
        return (self.heights - square / (TIP + numpy.sqrt(TIP**2 - square))).max()

    def beside(self, tip, turned=0.0, tip_radius=TIP):
        """(-force along z beside all contacts, the same beside the nearest one alone, its effective radius)
        of a tip with its apex there, by elements on circles around its axis, the first direction turned by
        an angle."""
        x, y, z = tip
        radii = numpy.geomspace(0.2e-9, 0.8 * tip_radius, 900)
        angles = turned + numpy.arange(720) * 2 * math.pi / 720
        cap = radii**2 / (tip_radius + numpy.sqrt(tip_radius**2 - radii**2))
        heights = self.at(x + radii[:, None] * numpy.cos(angles), y + radii[:, None] * numpy.sin(angles))
        ring = traction(D0 + z + cap[:, None] - heights).mean(axis=1) * radii**2
        steps = numpy.diff(numpy.log(radii))
        whole = 2 * math.pi * (0.5 * (ring[1:] + ring[:-1]) * steps).sum()
        counted = [(radius, of_paraboloid(radius, D0 + gap))
                   for gap, radius in self.contacts(tip, tip_radius)]
        whole /= 6 * math.pi
        return (HAMAKER * (whole - sum(part for _, part in counted)), HAMAKER * (whole - counted[0][1]),
                counted[0][0])

    def contacts(self, tip, tip_radius):
        """(gap, effective radius) of the positions that are nearest to the sphere around them, the nearest four
        across which a tip feels a four-hundredth of its strongest pull; the nearest first."""
        x, y, z = tip
        square = (self.positions[None, :] - x)**2 + (self.positions[:, None] - y)**2
        near = numpy.where(square < (0.9 * tip_radius)**2, square, 0.81 * tip_radius**2)
        gap = numpy.sqrt(near + (self.heights - z - tip_radius)**2) - tip_radius
        inner = gap[1:-1, 1:-1]
        least = numpy.ones(inner.shape, bool)
        for up in (-1, 0, 1):
            for right in (-1, 0, 1):
                if up or right:
                    least &= inner <= gap[1 + up:gap.shape[0] - 1 + up, 1 + right:gap.shape[1] - 1 + right]
        found = sorted((inner[i, k], i + 1, k + 1) for i, k in zip(*numpy.nonzero(least)))
        reach = (math.sqrt(400) - 1) * D0
        return [(distance, self.effective_radius(i, k, tip_radius))
                for n, (distance, i, k) in enumerate(found[:4]) if n == 0 or distance < reach]

    def effective_radius(self, row, column, tip_radius):
        """docs/theory.md 1, by differences."""
        part = self.heights[row - 1:row + 2, column - 1:column + 2]
        zx, zy = (part[1, 2] - part[1, 0]) / (2 * self.pitch), (part[2, 1] - part[0, 1]) / (2 * self.pitch)
        zxx = (part[1, 2] + part[1, 0] - 2 * part[1, 1]) / self.pitch**2
        zyy = (part[2, 1] + part[0, 1] - 2 * part[1, 1]) / self.pitch**2
        zxy = (part[2, 2] + part[0, 0] - part[2, 0] - part[0, 2]) / (4 * self.pitch**2)
        square = 1 + zx * zx + zy * zy
        mean = -((1 + zy * zy) * zxx - 2 * zx * zy * zxy + (1 + zx * zx) * zyy) / (2 * square**1.5)
        gauss = (zxx * zyy - zxy**2) / square**2
        return 1 / math.sqrt(max(1 / tip_radius**2 + 2 * mean / tip_radius + gauss, 1e-2 / tip_radius**2))


def write_scene(program, name, scan, tip_radius=TIP):
    return program.write_scene(name, {
        "sample": {"file": scan, "level": "none", "smoothing_px": 1, "youngs_modulus_pa": 70e9,
                   "poisson_ratio": 0.27, "work_of_adhesion_j_m2": WORK, "friction_coefficient": 0},
        "tip": {"radius_m": tip_radius},
        "probe": {"length_m": 150e-6, "width_m": 30e-6, "stiffness_n_m": STIFFNESS},
        "physics": {"law": "split"},
        "fidelity": {"body_attraction": "on"}})


def strongest(program, scene, x, y, top):
    """Summary of a touch at a position: the state that pulls most, and what is beside its contact."""
    program.explore(scene, [(0, x, y, top + 20e-9), (0.1, x, y, top - 0.1e-9),
                            (0.2, x, y, top - 0.1e-9), (0.4, x, y, top + 20e-9)])
    summary = json.loads((program.folder / "run/summary.json").read_text())
    return summary["strongest_attraction"], summary["strongest_attraction_body"]


def check_shipped_film(checks, program, positions):
    heights, pitch = read_scan(DATA / "samples/granular_film.gsf")
    spline = Spline(heights, pitch)
    size = len(heights) * pitch
    scene = write_scene(program, "film.toml", str(DATA / "samples/granular_film.gsf"))
    program.write_scan("turned.gsf", numpy.rot90(numpy.asarray(heights)), pitch)
    turned_scene = write_scene(program, "turned.toml", "turned.gsf")
    for i in range(positions):
        x, y = (0.28 + 0.05 * i) * size, (0.3 + 0.4 * (i * 0.618 % 1)) * size
        top = spline.touch(x, y)
        state, beside = strongest(program, scene, x, y, top)
        expected, of_nearest, radius = spline.beside(state["tip_m"])
        pull = 1.5 * math.pi * WORK * radius
        name = f"position {i}, R_eff {radius * 1e9:.1f} nm"
        checks.near(f"{name}: the term, share of the pull-off force", -beside["in_model_n"] / pull,
                    expected / pull, 1, size=0.05 * abs(expected) / pull + SQUARES)
        checks.near(f"{name}: the sum of the summary", -beside["force_n"] / pull, of_nearest / pull, 1,
                    size=0.05 * abs(of_nearest) / pull + SQUARES)
        checks.near(f"{name}: the sum here from another direction", spline.beside(state["tip_m"], 0.2)[1],
                    of_nearest, 1, size=0.002 * abs(of_nearest))
        if i % 5 == 1:
            turned, other = strongest(program, turned_scene, size - y, x, top)
            checks.near(f"{name}: the term on the scan turned by 90 degrees",
                        other["in_model_n"] / pull, beside["in_model_n"] / pull, 1,
                        size=0.01 * abs(beside["in_model_n"]) / pull + 0.001)


def check_particle(checks, program):
    """A tip of 5 um on a sphere of 50 nm on a plane, whose steep part is a cone."""
    radius, tip_radius, pitch, side = 50e-9, 5e-6, 2e-9, 161

    def height(x, y):
        away = math.hypot(x, y)
        return (math.sqrt(radius**2 - away**2) if away < radius / math.sqrt(2)
                else max(math.sqrt(2) * radius - away, 0)) + 0.0
    rows = [[height((k - side // 2) * pitch, (i - side // 2) * pitch) for k in range(side)]
            for i in range(side)]
    program.write_scan("particle.gsf", rows, pitch)
    scene = write_scene(program, "particle.toml", "particle.gsf", tip_radius)
    spline = Spline(rows, pitch)
    middle = side * pitch / 2
    state, beside = strongest(program, scene, middle, middle, spline.heights.max())
    expected, _, effective = spline.beside(state["tip_m"], tip_radius=tip_radius)
    pull = 1.5 * math.pi * WORK * effective
    checks.near("tip of 5 um on a sphere of 50 nm: effective radius [nm]", effective * 1e9, 49.5, 0.03)
    checks.near("the term, share of the pull-off force", -beside["in_model_n"] / pull, expected / pull,
                1, size=0.05 * abs(expected) / pull + SQUARES)
    plane = 2 * math.pi * WORK * tip_radius * (D0 / (D0 + radius))**2
    checks.holds("of which sphere and half-space, share", plane / pull < 0.01, plane / pull)


def main(path, positions=4):
    checks = Checks()
    check_limits(checks)
    program = Program(path)
    check_shipped_film(checks, program, positions)
    check_particle(checks, program)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
