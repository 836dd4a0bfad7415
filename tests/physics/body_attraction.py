#!/usr/bin/env python3
"""Attraction of a blunt tip by the sample beside an asperity, docs/theory.md 3.8: limits by mpmath,
and the shipped film under a tip of 2 um beside `asperity explore`. Usage: body_attraction.py ASPERITY"""

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

# Limits, by elements of surface across a separation g: H/(6 pi (g^3 + NEAREST^3)) each.


def beside(gap, of_law, end):
    """-force: integral over the cap of the traction across `gap`, less that across `of_law`, functions
    of the distance from the axis."""
    def part(distance):
        near = mpf(NEAREST)**3
        return distance * (1 / (gap(distance)**3 + near) - 1 / (of_law(distance)**3 + near))
    places = [0] + [end * mpf(2)**-i for i in range(14, -1, -1)]
    return mpf(HAMAKER) / 3 * mpmath.quad(part, places)


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
    return 1 / (numpy.maximum(separation, 0)**3 + NEAREST**3)


def of_paraboloid(radius, separation):
    """Integral of the traction over H, of a paraboloid at this distance: in closed form."""
    end = NEAREST
    root = math.sqrt(3)
    arc = math.pi / 2 - math.atan((2 * separation - end) / (root * end))
    logarithm = math.log((separation + end)**2 / (separation**2 - separation * end + end**2))
    return radius / 3 * (arc / (root * end**2) - logarithm / (6 * end**2))


FINER = 4  # places a pixel, along each axis


class Spline:
    """Cubic B-spline through a scan that a Gaussian of one pixel has smoothed."""

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
            place = (i + 0.5) / FINER - 0.5
            for tap in range(math.floor(place) - 1, math.floor(place) + 3):
                away = abs(place - tap)
                weight = 2 / 3 - away**2 + away**3 / 2 if away < 1 else max(2 - away, 0)**3 / 6
                fine[i, min(max(tap, 0), side - 1)] += weight
        along = fine @ numpy.linalg.solve(through, smooth)
        self.heights = along @ numpy.asarray(heights)[::-1] @ along.T  # rows upwards
        self.pitch = pitch / FINER
        self.places = (numpy.arange(side * FINER) + 0.5) * self.pitch

    def touch(self, x, y):
        """Height of the apex where the tip first touches [m]."""
        square = (self.places[None, :] - x)**2 + (self.places[:, None] - y)**2
        return (self.heights - square / (TIP + numpy.sqrt(TIP**2 - square))).max()

    def beside(self, x, y, indentation):
        """(-force beside the contact, effective radius) of a tip whose nearest point overlaps so."""
        square = (self.places[None, :] - x)**2 + (self.places[:, None] - y)**2
        cap = square / (TIP + numpy.sqrt(TIP**2 - square))
        center = (self.heights - cap).max() + TIP
        for _ in range(4):  # the center goes along z until the overlap is the one asked for
            away = numpy.sqrt(square + (self.heights - center)**2)
            center += TIP - indentation - away.min()
        row, column = numpy.unravel_index(away.argmin(), away.shape)
        gap = D0 + center - TIP + cap - self.heights
        tractions = traction(gap).sum() * self.pitch**2
        radius = self.effective_radius(row, column)
        counted = of_paraboloid(radius, D0 - indentation)
        return HAMAKER * (tractions / (6 * math.pi) - counted), radius

    def effective_radius(self, row, column):
        """docs/theory.md 1, by differences."""
        part = self.heights[row - 1:row + 2, column - 1:column + 2]
        zx, zy = (part[1, 2] - part[1, 0]) / (2 * self.pitch), (part[2, 1] - part[0, 1]) / (2 * self.pitch)
        zxx = (part[1, 2] + part[1, 0] - 2 * part[1, 1]) / self.pitch**2
        zyy = (part[2, 1] + part[0, 1] - 2 * part[1, 1]) / self.pitch**2
        zxy = (part[2, 2] + part[0, 0] - part[2, 0] - part[0, 2]) / (4 * self.pitch**2)
        square = 1 + zx * zx + zy * zy
        mean = -((1 + zy * zy) * zxx - 2 * zx * zy * zxy + (1 + zx * zx) * zyy) / (2 * square**1.5)
        gauss = (zxx * zyy - zxy**2) / square**2
        return 1 / math.sqrt(max(1 / TIP**2 + 2 * mean / TIP + gauss, 1e-2 / TIP**2))


def check_shipped_film(checks, program):
    heights, pitch = read_scan(DATA / "samples/granular_film.gsf")
    spline = Spline(heights, pitch)
    size = len(heights) * pitch
    scene = program.write_scene("film.toml", {
        "sample": {"file": str(DATA / "samples/granular_film.gsf"), "level": "none",
                   "youngs_modulus_pa": 70e9, "poisson_ratio": 0.27,
                   "work_of_adhesion_j_m2": WORK, "friction_coefficient": 0},
        "tip": {"radius_m": TIP},
        "probe": {"length_m": 150e-6, "width_m": 30e-6, "stiffness_n_m": 1000},
        "physics": {"law": "split"}})
    for i in range(6):
        x, y = (0.3 + 0.08 * i) * size, (0.62 - 0.05 * i) * size
        top = spline.touch(x, y)
        program.explore(scene, [(0, x, y, top + 20e-9), (0.1, x, y, top - 0.1e-9),
                                (0.2, x, y, top - 0.1e-9), (0.4, x, y, top + 20e-9)])
        summary = json.loads((program.folder / "run/summary.json").read_text())
        state = summary["strongest_attraction"]
        beside = summary["strongest_attraction_body"]
        expected, radius = spline.beside(*state["tip_m"][:2], state["indentation_m"])
        pull = 1.5 * math.pi * WORK * radius
        checks.near(f"place {i}, R_eff {radius * 1e9:.1f} nm: force beside the contact",
                    beside["force_n"], -expected, 0.02, size=pull)
        checks.near(f"place {i}: its share of the pull-off force", beside["share_of_pull_off"],
                    -expected / pull, 0.02, size=1)


def main(path):
    checks = Checks()
    check_limits(checks)
    check_shipped_film(checks, Program(path))
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
