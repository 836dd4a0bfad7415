#!/usr/bin/env python3
"""A bead in a groove of gel (docs/theory.md 7.4) and the sum of its two contacts, by Hertz on two
planes and the lever's compliance (5.1), beside `asperity map`. Usage: groove.py ASPERITY"""

import sys

import mpmath
from mpmath import mpf

from common import Checks, Program, bisected, reduced_modulus

FLANK = mpmath.radians(20)
BEAD = mpf("2.5e-6")
MODULUS = reduced_modulus((10e3, 0.5))
STIFFNESS = mpf("0.1")
LENGTH, TIP_HEIGHT = mpf("150e-6"), mpf("12e-6")
PITCH, COLUMNS, ROWS = 50e-9, 128, 32
LOAD = mpf("2e-9")


def compliance():
    """C_xx, C_xz of the lever, docs/theory.md 5.1 and its equalities: 1/kx, 1/kxz."""
    return (3 * TIP_HEIGHT**2 / (LENGTH**2 * STIFFNESS),
            3 * TIP_HEIGHT / (2 * LENGTH * STIFFNESS))


class Bead:
    """The bead with its center at (x, z) from the groove's bottom line."""

    def __init__(self, x, z):
        self.z = z
        # Overlap with each plane, whose outward normal is (-+sin, cos).
        self.right = BEAD - (z * mpmath.cos(FLANK) - x * mpmath.sin(FLANK))
        self.left = BEAD - (z * mpmath.cos(FLANK) + x * mpmath.sin(FLANK))
        pushes = [4 * MODULUS / 3 * mpmath.sqrt(BEAD) * max(mpf(0), overlap)**mpf(1.5)
                  for overlap in (self.right, self.left)]
        self.lateral = (pushes[1] - pushes[0]) * mpmath.sin(FLANK)
        self.vertical = (pushes[0] + pushes[1]) * mpmath.cos(FLANK)
        # Of the points on the planes below the center.
        across = [BEAD - overlap for overlap in (self.right, self.left)]
        apart = mpmath.hypot((across[0] + across[1]) * mpmath.sin(FLANK),
                             (across[0] - across[1]) * mpmath.cos(FLANK))
        # (7.1): the share of its indentation by which each is lowered by the other.
        self.interaction = max((push / (mpmath.pi * MODULUS * apart) / overlap for push, overlap in
                                zip(pushes, (self.left, self.right)) if overlap > 0), default=0)


def bead_under_load(aside):
    """The bead at the load along z, its lever's base beside the middle."""
    along, coupling = compliance()
    x, step = mpf(aside), mpf(1)
    while abs(step) > 1e-16:
        z = bisected(lambda height: LOAD - Bead(x, height).vertical, BEAD / 2, 2 * BEAD)
        bead = Bead(x, z)
        step = (aside + along * bead.lateral + coupling * LOAD - x) / 2
        x += step
    return bead


def main(path):
    checks = Checks()
    program = Program(path)
    slope = mpmath.tan(FLANK)
    program.write_scan("groove.gsf", [[abs(column + 0.5 - COLUMNS / 2) * PITCH * slope
                                       for column in range(COLUMNS)]] * ROWS, PITCH)
    scene = program.write_scene("groove.toml", {
        "sample": {"file": "groove.gsf", "level": "none", "smoothing_px": 0,
                   "youngs_modulus_pa": 10e3, "poisson_ratio": 0.5, "work_of_adhesion_j_m2": 0,
                   "friction_coefficient": 0},
        "tip": {"radius_m": BEAD},
        "probe": {"length_m": LENGTH, "width_m": 30e-6, "tip_height_m": TIP_HEIGHT,
                  "stiffness_n_m": STIFFNESS},
        "physics": {"law": "hertz"}})
    # Two positions where both flanks bear, one where a single one does.
    for aside, flanks in ((17e-9, 2), (6e-7, 1), (5e-9, 2)):
        bead = bead_under_load(mpf(aside))
        name = f"{aside * 1e9:g} nm beside the middle, "
        x, y = COLUMNS / 2 * PITCH + aside, ROWS / 2 * PITCH
        found = program.map(scene, (x - 1e-12, y - 1e-12, x + 1e-12, y + 1e-12), setpoint=LOAD)
        recorded = bead.z - BEAD - compliance()[1] * bead.lateral
        checks.holds(name + "flanks that bear", (bead.left > 0) + (bead.right > 0) == flanks,
                     flanks)
        # Where it bears the spline through the pixels is the flank to 1e-5 of the indentation.
        depth = max(bead.right, bead.left)
        checks.near(name + "indentation", found["indentation"][0], depth, 1e-4)
        checks.near(name + "recorded height", found["height"][0], recorded, 1e-4, depth)
        checks.near(name + "lateral force", found["lateral_force"][0], abs(bead.lateral), 1e-4,
                    LOAD)
        interacts = bead.left > 0 and bead.interaction > 0.05
        checks.holds(name + f"interaction {float(bead.interaction):.3f}, flag",
                     bool(int(found["validity"][0]) >> 23 & 1) == interacts, interacts)
    checks.near("theory 7.4: indentation", bead_under_load(mpf("17e-9")).right, 119.28e-9, 1e-4)
    checks.near("theory 7.4: lateral force", -bead_under_load(mpf("17e-9")).lateral, 0.0642e-9,
                1e-3)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
