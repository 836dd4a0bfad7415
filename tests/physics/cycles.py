#!/usr/bin/env python3
"""Writes synthetic force cycles that core/identify is tested with, by formulas of its own: JKR of the exact
sphere with one or two works of adhesion, and a sample that relaxes (Ting, standard linear solid) with a wall's
drag, each on a lever. tests/reference/cycles holds what it wrote, without noise.
Usage: cycles.py FOLDER"""

import math
import pathlib
import sys

SAMPLES = 300  # of a branch


def ramp(first, last, count):
    return [first + (last - first) * i / (count - 1) for i in range(count)]


def bisect(function, low, high, steps=200):
    """Root of a function that rises from `low` to `high`."""
    for _ in range(steps):
        middle = 0.5 * (low + high)
        if function(middle) < 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


class Sphere:
    """Rigid sphere of radius R on a half-space of reduced modulus E, with adhesion on a lever of stiffness k."""

    def __init__(self, radius, modulus, stiffness):
        self.R, self.E, self.k = radius, modulus, stiffness

    def punch(self, a):
        u = a / self.R
        depth = self.R * u * math.atanh(u)
        force = self.E * self.R**2 * ((1.0 + u * u) * math.atanh(u) - u)
        return depth, force

    def held(self, a, base):
        """Force and energy release rate with a contact radius at a base position."""
        depth, force = self.punch(a)
        contact = 2.0 * a * self.E
        lift = (depth + force / self.k - base) / (1.0 + contact / self.k)
        return force - contact * lift, math.copysign(lift * lift, lift) * self.E / (2.0 * math.pi * a)

    def closing(self, base, work, a):
        """The contact radius at which a contact that grows from `a` stops."""
        top = a
        while self.held(top, base)[1] < work:
            top = min(1.05 * top, 0.5 * (top + self.R))
        return bisect(lambda x: self.held(x, base)[1] - work, a, top) if top > a else a

    def opening(self, base, work, a):
        """The contact radius at which a contact that shrinks from `a` stops; 0: it breaks."""
        low = a
        while self.held(low, base)[1] > work:
            low *= 0.998
            if low < 1e-4 * self.R:
                return 0.0
        return bisect(lambda x: self.held(x, base)[1] - work, low, low / 0.998) if low < a else a


def adhesive_cycle(sphere, approach_work, retract_work, bases):
    """Force at each base position; contact begins at the first touch of the unbent lever, 0."""
    forces = []
    a = 0.0
    for base in bases:
        if a == 0.0 and base > 0.0:
            a = 1e-6 * sphere.R
        if a > 0.0:
            a = sphere.closing(base, approach_work, a)
            a = sphere.opening(base, retract_work, a)
        forces.append(sphere.held(a, base)[0] if a > 0.0 else 0.0)
    return forces


class Solid:
    """Sample with E(t) = E_inf + E_1 exp(-t / tau) under a sphere, wall drag C v / (gap + h)."""

    def __init__(self, radius, poisson, slow, fast, tau, drag, offset):
        self.R, self.plane = radius, 1.0 - poisson**2
        self.slow, self.fast, self.tau = slow, fast, tau
        self.drag, self.offset = drag, offset

    def load(self, depth):
        if depth <= 0.0:
            return 0.0
        u = bisect(lambda x: x * math.atanh(x) - depth / self.R, 0.0, 0.999999, 60)
        return self.R**2 * ((1.0 + u * u) * math.atanh(u) - u) / self.plane

    def cycle(self, stiffness, times, bases):
        depths, loads, way, memory, forces = [bases[0]], [0.0], [0.0], [0.0], [0.0]
        turn = bases.index(max(bases))
        edge = turn
        for i in range(1, len(times)):
            step = times[i] - times[i - 1]
            fade = math.exp(-step / self.tau)
            mean = (1.0 - fade) * self.tau / step

            def force(depth):
                moved = way[-1] * fade + (depth - depths[-1]) * mean
                flow = self.drag * (depth - depths[-1]) / step / (max(-depth, 0.0) + self.offset)
                load = self.load(depth)
                whole = self.slow * load + self.fast * (memory[-1] * fade + (load - loads[-1]) * mean)
                if i <= turn:
                    return whole + flow, edge

                def left(j):
                    old = math.exp((times[j] - times[i]) / self.tau)
                    return self.slow * (depth - depths[j]) + self.fast * (moved - old * way[j])

                j = edge
                if left(j) >= 0.0:
                    if edge == turn:
                        return whole + flow, edge
                    old = math.exp((times[j] - times[i]) / self.tau)  # never wider than it was before
                    return self.slow * loads[j] + self.fast * old * memory[j] + flow, edge
                while j > 0 and left(j) < 0.0:
                    j -= 1
                if left(j) < 0.0:
                    return flow, 0
                share = left(j) / (left(j) - left(j + 1))
                old = math.exp((times[j] + share * (times[j + 1] - times[j]) - times[i]) / self.tau)
                load = loads[j] + share * (loads[j + 1] - loads[j])
                kept = memory[j] + share * (memory[j + 1] - memory[j])
                return self.slow * load + self.fast * old * kept + flow, j + 1

            reach = 2.0 * abs(bases[i] - bases[i - 1]) + 1e-3 * (max(bases) - min(bases))
            depth = bisect(lambda x: force(x)[0] - stiffness * (bases[i] - x),
                           depths[-1] - reach, depths[-1] + reach, 50)
            edge = i if i < turn else min(force(depth)[1], turn)
            load = self.load(depth)
            way.append(way[-1] * fade + (depth - depths[-1]) * mean)
            memory.append(memory[-1] * fade + (load - loads[-1]) * mean)
            depths.append(depth)
            loads.append(load)
            forces.append(stiffness * (bases[i] - depth))
        return forces


def write(path, times, bases, forces, stiffness, turn):
    with open(path, "w", encoding="ascii") as out:
        out.write(f"# by tests/physics/cycles.py; lever {stiffness} N/m\n")
        out.write("segment,time_s,base_m,force_N\n")
        for i, (time, base, force) in enumerate(zip(times, bases, forces)):
            kind = "0:approach" if i < turn else "1:retract"
            out.write(f"{kind},{time:.9g},{base:.9g},{force:.9g}\n")


def write_adhesive(folder, name, approach_work, retract_work):
    sphere = Sphere(7.5e-6, 2e6, 5.0)
    bases = ramp(-0.8e-6, 1.2e-6, SAMPLES) + ramp(1.2e-6, -0.8e-6, SAMPLES)
    forces = adhesive_cycle(sphere, approach_work, retract_work, bases)
    times = [0.002 * i for i in range(len(bases))]
    write(folder / name, times, bases, forces, sphere.k, SAMPLES)


def write_relaxing(folder, name, duration, drag):
    fine = 8
    solid = Solid(7.5e-6, 0.5, 1000.0, 1500.0, 0.1, drag, 0.5e-6)
    count = (SAMPLES - 1) * fine + 1
    bases = ramp(-4e-6, 2e-6, count) + ramp(2e-6, -4e-6, count)[1:]
    times = ramp(0.0, 2.0 * duration, len(bases))
    forces = solid.cycle(0.02, times, bases)
    write(folder / name, times[::fine], bases[::fine], forces[::fine], 0.02, SAMPLES)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write_adhesive(folder, "jkr_one.csv", 0.04, 0.04)
    write_adhesive(folder, "jkr_two.csv", 0.04, 0.048)
    write_relaxing(folder, "relaxing_slow.csv", 1.0, 0.0)
    write_relaxing(folder, "relaxing_fast.csv", 0.2, 0.0)
    write_relaxing(folder, "relaxing_drag.csv", 0.2, 1e-11)


if __name__ == "__main__":
    main()
