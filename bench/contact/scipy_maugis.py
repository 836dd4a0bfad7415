#!/usr/bin/python3
"""The textbook solution of Maugis-Dugdale contact: two nested searches (docs/theory.md 2.1, 2.2).

scipy_maugis.py numpy|math  LAMBDA LOW INDENTATION  [LAMBDA LOW INDENTATION ...]

All dimensionless; LOW is a contact radius below that of the stable state. Writes for each case
"NANOSECONDS FORCE", the median time of one solution. "numpy" takes the functions of NumPy and
searches the ratio of the radii between 1 and 1e12, as published code does; "math" is as fast as the
same search gets: scalar functions and a tight bracket.
"""
import math
import statistics
import sys
import time

import numpy
from scipy.optimize import brentq

REPEATS = 7


class Textbook:
    def __init__(self, style):
        self.tight = style == "math"
        self.sqrt = math.sqrt if self.tight else numpy.sqrt
        self.atan = math.atan if self.tight else numpy.arctan

    def zone_excess(self, m, a, lam):
        """Left side of (2.1) less its right side; m is cohesive over contact radius."""
        q = self.sqrt(m * m - 1.0)
        t = self.atan(q)
        bending = lam * a * a / 2.0 * (q + (m * m - 2.0) * t)
        return bending + 4.0 * lam * lam * a / 3.0 * (q * t - m + 1.0) - 1.0

    def ratio(self, a, lam):
        high = 1e12
        if self.tight:
            high = 2.0
            while self.zone_excess(high, a, lam) < 0.0:
                high *= 2.0
        return brentq(self.zone_excess, 1.0, high, args=(a, lam))

    def indentation(self, a, lam):
        m = self.ratio(a, lam)
        return a * a - 4.0 / 3.0 * lam * a * self.sqrt(m * m - 1.0)

    def force(self, a, lam):
        m = self.ratio(a, lam)
        q = self.sqrt(m * m - 1.0)
        return a * a * a - lam * a * a * (q + m * m * self.atan(q))

    def solve(self, lam, low, delta):
        high = low + 2.0 + 2.0 * math.sqrt(abs(delta))
        a = brentq(lambda radius: self.indentation(radius, lam) - delta, low, high)
        return self.force(a, lam)


def timed(textbook, case):
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter_ns()
        force = textbook.solve(*case)
        times.append(time.perf_counter_ns() - start)
    return statistics.median(times), force


def main(style, *numbers):
    values = [float(number) for number in numbers]
    textbook = Textbook(style)
    for i in range(0, len(values), 3):
        print("%d %.17g" % timed(textbook, values[i : i + 3]))


if __name__ == "__main__":
    main(*sys.argv[1:])
