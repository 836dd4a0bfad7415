#!/usr/bin/env python3
"""A part of a shipped scan with all lengths, the range of cohesion, work of adhesion and the lever's
stiffness s times as large: forces are s^2 times as large, whatever s (docs/theory.md 7.4), in
`asperity explore`, `curve` and `map`. Usage: scales.py ASPERITY"""

import math
import sys

from common import DATA, Checks, Program, read_scan

SCALES = (1 / 8, 1 / 2, 2, 8, 64)  # powers of two: the scaled heights are exact in single precision
FORCE = 1e-6
QUANTITY = 1e-3
SIDE = 48
MAPPED = 8  # pixels along a side of the map
SETPOINT = 5e-9
POWERS = {"pull_off_force": 2, "adhesion_force": 2, "snap_in_distance": 1, "separation_work": 3,
          "dissipated_energy": 3, "height": 1, "indentation": 1, "contact_radius": 1, "stiffness": 1,
          "apparent_modulus": 0, "lateral_force": 2, "normal_angle": 0}


class Sample:
    """A part of a scan, and the scene, at a scale."""

    def __init__(self, program, scale, scan="particles", first=60, tip_radius=15e-9):
        rows, pitch = read_scan(DATA / f"samples/{scan}.gsf")
        self.program, self.scale = program, scale
        self.pitch = pitch * scale
        part = [row[first:first + SIDE] for row in rows[first:first + SIDE]]
        self.top = max(map(max, part)) * scale
        program.write_scan("part.gsf", [[height * scale for height in row] for row in part],
                           self.pitch)
        self.scene = program.write_scene("scene.toml", {
            "sample": {"file": "part.gsf", "level": "none", "smoothing_px": 1,
                       "youngs_modulus_pa": 2e9, "poisson_ratio": 0.4, "friction_coefficient": 0,
                       "work_of_adhesion_j_m2": 0.066 * scale},
            "tip": {"radius_m": tip_radius * scale},
            "probe": {"length_m": 150e-6 * scale, "width_m": 30e-6 * scale,
                      "tip_height_m": 12e-6 * scale, "stiffness_n_m": 14 * scale},
            "physics": {"law": "md", "cohesive_range_m": 0.35678e-9 * scale},
            "fidelity": {"closest_point_search": "certified", "curvature": "on", "torsion": "on"}})

    def forces(self):
        """Of the model in a run that goes down onto the sample, over it and up, over s^2."""
        ticks = 900
        path = []
        for i in range(ticks + 1):
            part = 3 * i / ticks
            down = min(1, part, 3 - part)
            along = min(1, max(0, part - 1))
            path.append((i * 1e-3, (0.3 + 0.3 * along) * SIDE * self.pitch,
                         (0.4 + 0.1 * along) * SIDE * self.pitch,
                         self.top + (2 - 14 * down) * 1e-9 * self.scale))
        log = self.program.explore(self.scene, path)
        return [tuple(float(row[f"model_f{axis}_n"]) / self.scale**2 for axis in "xyz")
                for row in log]

    def curve(self):
        """Forces of the law on its lever over s^2, with their positions over s."""
        _, rows = self.program.curve(self.scene, "--points", "200")
        return [(float(row["base_position_m"]) / self.scale, float(row["force_n"]) / self.scale**2)
                for row in rows]

    def map(self):
        """Quantities of the middle of the part, each over its power of s."""
        low, high = (0.3 * SIDE * self.pitch, 0.7 * SIDE * self.pitch)
        found = self.program.map(self.scene, (low, low, high, high), f"{MAPPED}x{MAPPED}",
                                 SETPOINT * self.scale**2)
        return {key: [value / self.scale**power for value in found[key]]
                for key, power in POWERS.items()}


def check_map(checks, name, pixels, expected):
    for key, values in pixels.items():
        size = max(abs(value) for value in expected[key] if not math.isnan(value))
        same = [math.isnan(a) == math.isnan(b) for a, b in zip(values, expected[key])]
        off = max(abs(a - b) / max(abs(b), 0.01 * size) for a, b in zip(values, expected[key])
                  if not math.isnan(a) and not math.isnan(b))
        checks.holds(f"{name}, worst {key}", all(same) and off < QUANTITY, f"{off:.2g}")


def check_several_contacts(checks, program):
    """A film's hollows, where several positions hold the tip, also at scales that round the heights."""
    def map_at(scale):
        return Sample(program, scale, "granular_film", 200, 30e-9).map()
    expected = map_at(1)
    for scale in (1 / 8, 3.3, 16, 64):
        check_map(checks, f"several contacts, scale {scale:g}: map", map_at(scale), expected)


def worst(values, expected):
    return max(math.dist(value, other) for value, other in zip(values, expected))


def main(path):
    checks = Checks()
    program = Program(path)
    usual = Sample(program, 1)
    forces, curve, pixels = usual.forces(), usual.curve(), usual.map()
    largest = max(math.hypot(*force) for force in forces)
    deepest = max(abs(position) for position, _ in curve)
    strongest = max(abs(force) for _, force in curve)
    checks.holds("the run touches and comes off", largest > 5e-9 and forces[-1] == (0, 0, 0),
                 f"{largest:.3g} N, then {forces[-1]}")
    for scale in SCALES:
        sample = Sample(program, scale)
        name = f"scale {scale:g}: "
        off = worst(sample.forces(), forces) / largest
        checks.holds(name + "explore, worst force", off < FORCE, f"{off:.2g} of the largest")
        other = sample.curve()
        checks.holds(name + "curve, points", len(other) == len(curve), len(other))
        off = max(max(abs(a - c) / deepest, abs(b - d) / strongest)
                  for (a, b), (c, d) in zip(other, curve))
        checks.holds(name + "curve, worst position or force", off < FORCE, f"{off:.2g} of the largest")
        check_map(checks, f"{name}map", sample.map(), pixels)
    check_several_contacts(checks, program)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
