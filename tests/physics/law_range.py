#!/usr/bin/env python3
"""Forces of the contact laws at an indentation, and what each leaves out, by the formulas of
docs/theory.md 2 beside `asperity contact`. Usage: law_range.py ASPERITY"""

import sys

import mpmath
from mpmath import mp, mpf

from common import COHESIVE_RANGE, Checks, Maugis, Program, bisected

JKR_FROM = mpf("4.8")     # lambda, theory 2.9: a(P = 0) within 1 %
ADHESION_MATTERS = 280    # P / (pi w R), theory 2.9: adhesion changes a by less than 5 % above
LARGE = mpf("0.3")        # a / R, theory 2.10


def expected(case):
    """(force, contact radius, reach of the attraction) of a case."""
    radius, modulus, work, depth = (mpf(case[key]) for key in (
        "radius_m", "e_star_pa", "work_of_adhesion_j_m2", "indentation_m"))
    hertz = 4 * modulus / 3 * mpmath.sqrt(radius * depth**3)
    contact = mpmath.sqrt(radius * depth)
    if case["model"] == "hertz":
        return hertz, contact, contact
    if case["model"] == "sneddon":  # 4.4
        contact = bisected(lambda a: a * mpmath.atanh(a / radius) - depth, 0,
                           radius * (1 - mpf(10)**-20))
        force = modulus * ((radius**2 + contact**2) * mpmath.atanh(contact / radius) -
                           contact * radius)
        return force, contact, contact
    if case["model"] == "dmt":
        return hertz - 2 * mp.pi * work * radius, contact, contact
    if case["model"] == "jkr":  # 2.1, the root with the larger contact
        contact = bisected(lambda a: a**2 / radius - mpmath.sqrt(2 * mp.pi * a * work / modulus) -
                           depth, contact, 10 * radius)
        force = (4 * modulus * contact**3 / (3 * radius) -
                 mpmath.sqrt(8 * mp.pi * work * modulus * contact**3))
        return force, contact, contact
    maugis = Maugis(radius, modulus, work, case["sigma0_pa"])
    a, c, force, _ = maugis.at(maugis.phi_at(depth / maugis.unit_length))
    return force * maugis.unit_force, a * maugis.unit_radius, c * maugis.unit_radius


def remarks(case, force, contact, reach):
    """What the result does not hold for, by the criteria of theory 2.9, 2.10 and 4.4."""
    radius, modulus, work = (mpf(case[key]) for key in ("radius_m", "e_star_pa",
                                                        "work_of_adhesion_j_m2"))
    found = set()
    if work > 0 and force <= ADHESION_MATTERS * mp.pi * work * radius:
        stress = mpf(case["sigma0_pa"]) or work / COHESIVE_RANGE
        transition = Maugis(radius, modulus, work, stress).transition
        leaves_out = {
            "hertz": True,
            "sneddon": True,
            # (2.5), (2.7): the ring lifts the sample by 1.5 sqrt(lambda) units
            "dmt": transition > mpf("2.5e-4"),
            "jkr": transition < JKR_FROM or reach > LARGE * radius,
            "md": reach > LARGE * radius}
        found |= {"law_out_of_range"} if leaves_out[case["model"]] else set()
    found |= {"large_contact"} if contact > LARGE * radius else set()
    return found or {"ok"}


def cases():
    # A stiff pair: attraction reaches as far as the sample gives way.
    oxide = {"radius_m": 15e-9, "e_star_pa": 53e9, "work_of_adhesion_j_m2": 0.2,
             "sigma0_pa": 0, "indentation_m": 1e-10}
    soft = dict(oxide, radius_m=1e-6, e_star_pa=10e6, work_of_adhesion_j_m2=1e-3,
                indentation_m=1e-8)
    # So hard and so weakly adhesive that the ring of attraction lifts nothing.
    hard = dict(oxide, radius_m=50e-9, e_star_pa=1e12, work_of_adhesion_j_m2=1e-5,
                indentation_m=2e-13)
    pressed = dict(oxide, indentation_m=20e-9, radius_m=1e-6)
    deep = dict(oxide, indentation_m=3e-9)
    dry = dict(oxide, work_of_adhesion_j_m2=0, indentation_m=3e-9)
    for pair in (oxide, soft, hard, pressed, deep):
        for model in ("hertz", "sneddon", "dmt", "jkr", "md"):
            stress = pair["work_of_adhesion_j_m2"] / COHESIVE_RANGE if model == "md" else 0
            yield dict(pair, model=model, sigma0_pa=float(stress), branch="retract")
    for model in ("hertz", "sneddon"):
        yield dict(dry, model=model, branch="retract")


def main(path):
    checks = Checks()
    asked = list(cases())
    found = Program(path).contact(asked)
    for case, row in zip(asked, found):
        name = (f"{case['model']}, R {case['radius_m']:g}, E* {case['e_star_pa']:g}, "
                f"w {case['work_of_adhesion_j_m2']:g}, {case['indentation_m']:g} m")
        force, contact, reach = expected(case)
        checks.near(f"{name}: force", row["force_n"], force, 1e-9,
                    max(abs(force), mp.pi * mpf(case["work_of_adhesion_j_m2"]) *
                        mpf(case["radius_m"])))
        checks.near(f"{name}: contact radius", row["contact_radius_m"], contact, 1e-9)
        wanted = remarks(case, force, contact, reach)
        checks.holds(f"{name}: status", set(row["status"].split("|")) == wanted,
                     f"{row['status']}, expected {'|'.join(sorted(wanted))}")
    # One pair by four laws, which differ by as much as the adhesion: only md includes its range.
    for row, force in zip(found, ("8.65e-9", None, "-10.2e-9", "-2.33e-9", "-4.64e-9")):
        if force:
            checks.near(f"oxide by {row['model']}", row["force_n"], force, 2e-3)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
