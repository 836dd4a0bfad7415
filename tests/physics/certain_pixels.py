#!/usr/bin/env python3
"""Which pixels a tip has certainly touched, by Villarrubia's rule from its definition (docs/surface.md,
What the scan already contains), beside `asperity convert --erode`. On random surfaces, imaged here by
a sphere, no pixel that is called certain may be off. Usage: certain_pixels.py ASPERITY"""

import math
import random
import sys

import numpy

from common import Checks, Program, read_scan

SURFACES = 12
SIDE = 40
PITCH = 1e-9
RADIUS = 6.3e-9
SINGLE = 2.0**-23  # of the largest height: what single precision cannot tell from it


def rise():
    """(row, column, height) of the sphere's surface above its apex at each pixel below it."""
    reach = int(RADIUS / PITCH)
    return [(i, k, RADIUS - math.sqrt(RADIUS**2 - (i * i + k * k) * PITCH**2))
            for i in range(-reach, reach + 1) for k in range(-reach, reach + 1)
            if (i * i + k * k) * PITCH**2 <= RADIUS**2]


def shifted(heights, row, column, beyond):
    """Each pixel's neighbor at this offset, `beyond` outside the scan."""
    result = numpy.full_like(heights, beyond)
    rows, columns = heights.shape
    result[max(0, -row):rows - max(0, row), max(0, -column):columns - max(0, column)] = \
        heights[max(0, row):rows + min(0, row), max(0, column):columns + min(0, column)]
    return result


def dilated(surface):
    return numpy.max([shifted(surface, i, k, -numpy.inf) - up for i, k, up in rise()], axis=0)


def eroded(image):
    return numpy.min([shifted(image, i, k, numpy.inf) + up for i, k, up in rise()], axis=0)


def proven(image, surface, near, far):
    """Pixels that are the only one to reach the tip at some of its positions, all of it within the
    scan: at most `near` below the tip's surface, and the next one more than `far` [m]."""
    offsets = rise()
    below = numpy.array([image + up - shifted(surface, i, k, -numpy.inf) for i, k, up in offsets])
    first, second = numpy.sort(below, axis=0)[:2]
    which = below.argmin(axis=0)
    margin = int(RADIUS / PITCH)
    certain = numpy.zeros(image.shape, bool)
    for row in range(margin, SIDE - margin):
        for column in range(margin, SIDE - margin):
            if first[row, column] <= near and second[row, column] > far:
                i, k, _ = offsets[which[row, column]]
                certain[row + i, column + k] = True
    return certain


def random_surface(draw):
    """Hills, a step and noise, in single precision."""
    row, column = numpy.mgrid[0:SIDE, 0:SIDE] * PITCH
    surface = numpy.zeros((SIDE, SIDE))
    for _ in range(6):
        wave = draw.uniform(6, 30) * PITCH
        angle, phase = draw.uniform(0, math.pi), draw.uniform(0, 2 * math.pi)
        surface += draw.uniform(0, 1e-9) * numpy.sin(
            2 * math.pi / wave * (row * math.cos(angle) + column * math.sin(angle)) + phase)
    surface += draw.choice((0, 3e-9, 8e-9)) * (column > draw.uniform(0.3, 0.7) * SIDE * PITCH)
    noise = draw.choice((0, 1e-11, 2e-10))
    surface += noise * numpy.array([[draw.gauss(0, 1) for _ in range(SIDE)] for _ in range(SIDE)])
    return surface.astype(numpy.float32).astype(float)


def main(path):
    checks = Checks()
    program = Program(path)
    draw = random.Random(4)
    count = 0
    for index in range(SURFACES):
        surface = random_surface(draw)
        image = dilated(surface).astype(numpy.float32).astype(float)
        program.write_scan("image.gsf", image, PITCH)
        program.run("convert", "image.gsf", "surface.gsf", "--erode", repr(RADIUS), "--certainty",
                    "certain.gsf", "--force")
        found = numpy.array(read_scan(program.folder / "surface.gsf")[0])
        certain = numpy.array(read_scan(program.folder / "certain.gsf")[0]) > 0.5
        rounding = SINGLE * max(numpy.abs(image).max(), numpy.abs(surface).max())
        name = f"surface {index + 1}: "
        off = numpy.abs(found - eroded(image)).max()
        # Read, as distances from a reference height, and written in single precision.
        checks.holds(name + "erosion", off <= 2 * rounding, f"off by {off:.2g} m")
        off = numpy.abs(found - surface)[certain].max() if certain.any() else 0.0
        checks.holds(name + "certain pixels", off <= 2 * rounding, f"off by at most {off:.2g} m")
        # Heights within rounding of a touching one may count or not: a bound on either side.
        strict = proven(image, eroded(image), 0.9 * rounding, 4 * rounding)
        loose = proven(image, eroded(image), 4 * rounding, 0.9 * rounding)
        checks.holds(name + "all that are proven are marked", not (strict & ~certain).any(),
                     f"{strict.sum()} of {certain.sum()}")
        checks.holds(name + "none else is marked", not (certain & ~loose).any(),
                     f"{certain.sum()} of {loose.sum()}")
        count += certain.sum()
    checks.holds("certain pixels at all", count > 1000, count)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
