#!/usr/bin/env python3
"""A blunt tip on a sharp sphere: effective radius and pull-off by docs/theory.md 1 and 2, beside
`asperity map`. Usage: blunt_tip.py ASPERITY"""

import sys

from mpmath import mpf

from common import COHESIVE_RANGE, Checks, Maugis, Program, reduced_modulus


def main(path):
    checks = Checks()
    program = Program(path)
    modulus, work = reduced_modulus((2e9, 0.4)), mpf("0.066")
    for tip, sphere in ((5e-6, 50e-9), (15e-9, 50e-9), (1e-6, 20e-9)):
        scene = program.write_scene("sphere.toml", {
            "sample": {"shape": "sphere", "shape_radius_m": sphere, "youngs_modulus_pa": 2e9,
                       "poisson_ratio": 0.4, "work_of_adhesion_j_m2": work,
                       "friction_coefficient": 0},
            "tip": {"radius_m": tip},
            "probe": {"length_m": 150e-6, "width_m": 30e-6, "stiffness_n_m": 14},
            "physics": {"law": "md"}})
        effective = 1 / (1 / mpf(tip) + 1 / mpf(sphere))
        law = Maugis(effective, modulus, work, work / COHESIVE_RANGE)
        middle = sphere / 2  # of the window on the shape
        found = program.map(scene, (middle - 1e-12, middle - 1e-12, middle + 1e-12, middle + 1e-12))
        name = f"tip {tip * 1e9:g} nm on a sphere of {sphere * 1e9:g} nm, R_eff {float(effective) * 1e9:.1f} nm: "
        checks.near(name + "strongest pull", found["adhesion_force"][0],
                    law.strongest_pull() * law.unit_force, 1e-3)
        checks.holds(name + "contact within the sphere", found["contact_radius"][0] < sphere / 2,
                     found["contact_radius"][0])
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
