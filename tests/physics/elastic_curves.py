#!/usr/bin/env python3
"""Elastic cycles on a lever, made here, identified by `asperity fit`: modulus and contact point come back
within 1 %, and scatter over many seeds as the fits state it, also under correlated noise.
Usage: elastic_curves.py ASPERITY"""

import json
import math
import random
import statistics
import sys

from common import Checks, Program

STIFFNESS = 0.05   # of the lever [N/m]
CONTACT = 2.5e-6   # base at contact [m]
POISSON = 0.5
SAMPLES = 1500     # of each branch


def sphere(radius):
    """Force over E* of Sneddon's sphere at an indentation, by its contact radius."""
    def force(depth):
        low, high = 0.0, 1.0 - 1e-12
        for _ in range(80):
            share = (low + high) / 2
            if radius * share * math.atanh(share) < depth:
                low = share
            else:
                high = share
        share = (low + high) / 2
        return radius**2 * ((share**2 + 1) * math.atanh(share) - share) if depth > 0 else 0.0
    return force


def power(factor, exponent):
    return lambda depth: factor * max(depth, 0.0)**exponent


TIPS = {  # option -> force over E*
    "sphere:5um": sphere(5e-6),
    "paraboloid:5um": power(4 / 3 * math.sqrt(5e-6), 1.5),
    "cone:30deg": power(2 / math.pi * math.tan(math.radians(30)), 2),
    "pyramid4:30deg": power(0.7453 * math.tan(math.radians(30)), 2),
    "pyramid3:30deg": power(0.887 * math.tan(math.radians(30)), 2),
}


def balance(law, modulus, way):
    """Force where lever and sample are in balance, the base `way` beyond contact."""
    low, high = 0.0, max(way, 0.0)
    for _ in range(60):
        depth = (low + high) / 2
        if depth + modulus * law(depth) / STIFFNESS < way:
            low = depth
        else:
            high = depth
    return modulus * law((low + high) / 2)


def forces(law, modulus):
    """(base, force) of an approach."""
    bases = [CONTACT - 4e-6 + 6e-6 * i / (SAMPLES - 1) for i in range(SAMPLES)]
    return [(base, balance(law, modulus, base - CONTACT)) for base in bases]


def write(path, cycle, noise, memory, seed):
    """A table as instruments export it, with baseline, tilt and noise."""
    source = random.Random(seed)
    error = source.gauss(0, noise)
    lines = ["segment,base_m,deflection_m,force_N"]
    for name, branch in (("approach", cycle), ("retract", cycle[::-1])):
        for base, force in branch:
            error = memory * error + math.sqrt(1 - memory**2) * source.gauss(0, noise)
            total = force + error - 3e-10 + 2e-5 * (base - CONTACT)
            lines.append(f"{name},{base!r},{total / STIFFNESS!r},{total!r}")
    path.write_text("\n".join(lines) + "\n")


def fits(program, names, tip):
    """What fits.json says of files: the parameters of each."""
    program.run("fit", *names, "--tip", tip, "--nu", POISSON, "--out", "fits", "--force")
    curves = json.loads((program.folder / "fits/fits.json").read_text())["curves"]
    return [(curve["verdict"], curve["parameters"]) for curve in curves]


def check_tips(checks, program):
    for tip, law in TIPS.items():
        modulus = 1e4 if "um" in tip else 1e5  # comparable to the lever
        cycle = forces(law, modulus)
        names = []
        for seed in range(5):
            names.append(f"tip{seed}.csv")
            write(program.folder / names[-1], cycle, 1e-4 * cycle[-1][1], 0.0, seed)
        for verdict, found in fits(program, names, tip):
            checks.holds(f"{tip} verdict", verdict == "matched", verdict)
            checks.near(f"{tip} E*", found["e_star_pa"]["value"], modulus, 0.01)
            checks.near(f"{tip} E", found["youngs_modulus_pa"]["value"],
                        modulus * (1 - POISSON**2), 0.01)
            checks.near(f"{tip} contact", found["contact_point_m"]["value"], CONTACT, 0.01, 1e-6)


def check_scatter(checks, program, memory):
    modulus, tip = 1e4, "paraboloid:5um"
    cycle = forces(TIPS[tip], modulus)
    names = []
    for seed in range(50):
        names.append(f"seed{seed}.csv")
        write(program.folder / names[-1], cycle, 0.01 * cycle[-1][1], memory, 1000 + seed)
    found = [parameters for _, parameters in fits(program, names, tip)]
    for key in ("e_star_pa", "contact_point_m"):
        scatter = statistics.stdev(parameters[key]["value"] for parameters in found)
        stated = math.sqrt(statistics.mean(parameters[key]["std"]**2 for parameters in found))
        checks.near(f"stated over found scatter of {key}, memory {memory}", stated / scatter, 1, 0.25)


def main(path):
    checks = Checks()
    program = Program(path)
    check_tips(checks, program)
    for memory in (0.0, 0.8):
        check_scatter(checks, program, memory)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
