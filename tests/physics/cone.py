#!/usr/bin/env python3
"""A cone with a spherical apex, elastic, with JKR's and with Maugis' adhesion, by quadrature over the
tip's profile (docs/theory.md 4.8) beside `asperity contact`. Usage: cone.py ASPERITY"""

import sys

import mpmath
from mpmath import mp, mpf

from common import Checks, Program, bisected

RADIUS, MODULUS = mpf("30e-9"), mpf("1.333e6")


class Tip:
    """Sphere of RADIUS up to where it touches a cone of this half angle [rad]; 0: the sphere alone."""

    def __init__(self, half_angle):
        self.half_angle = mpf(half_angle)
        self.joint = RADIUS * mpmath.cos(self.half_angle) if half_angle else RADIUS
        self.slope_beyond = mpmath.cot(self.half_angle) if half_angle else None

    def integral(self, contact, weight):
        """int_0^a weight(r) f'(r) / sqrt(a^2 - r^2) dr with r = a sin(t), to rounding."""
        def sphere(t):
            r = contact * mpmath.sin(t)
            return weight(r) * r / mpmath.sqrt(RADIUS**2 - r**2)

        def cone(t):
            return weight(contact * mpmath.sin(t)) * self.slope_beyond
        if contact <= self.joint:
            return mpmath.quad(sphere, [0, mp.pi / 2])
        joint = mpmath.asin(self.joint / contact)
        return mpmath.quad(sphere, [0, joint]) + mpmath.quad(cone, [joint, mp.pi / 2])

    def elastic(self, contact):
        """(indentation, force) without adhesion."""
        return (contact * self.integral(contact, lambda r: mpf(1)),
                2 * MODULUS * self.integral(contact, lambda r: r**2))

    def jkr(self, contact, work):
        depth, force = self.elastic(contact)
        return (depth - mpmath.sqrt(2 * mp.pi * contact * work / MODULUS),
                force - mpmath.sqrt(8 * mp.pi * work * MODULUS * contact**3))


class Maugis:
    """A cohesive zone of constant stress around the contact of a tip: docs/theory.md 4.8 as it stands
    there, by the gap at the zone's edge; in mpmath's numbers, or in floating-point ones."""

    def __init__(self, half_angle, work, stress, context=mp):
        self.context = context
        self.radius, self.modulus, half_angle, self.work, self.stress = (
            context.mpf(number) for number in (RADIUS, MODULUS, half_angle, work, stress))
        self.sine, self.slope_beyond = context.sin(half_angle), context.cot(half_angle)
        self.joint = self.radius * context.cos(half_angle)

    def elastic_depth(self, contact):
        """Closed form of 4.8: the quadrature within the quadrature would take minutes."""
        context = self.context
        if contact <= self.joint:
            return contact / 2 * context.log((self.radius + contact) / (self.radius - contact))
        run = context.sqrt(contact**2 - self.joint**2)
        return contact * (
            context.log((self.radius + contact) / (self.radius * self.sine + run)) +
            self.slope_beyond * context.acos(self.joint / contact))

    def depth(self, contact, zone):
        return (self.elastic_depth(contact) -
                2 * self.stress / self.modulus * self.context.sqrt(zone**2 - contact**2))

    def excess_gap(self, contact, zone):
        """Gap at the zone's edge less the range of the attraction."""
        context = self.context
        height = (self.radius - context.sqrt(self.radius**2 - zone**2) if zone <= self.joint else
                  self.radius * (1 - self.sine) + (zone - self.joint) * self.slope_beyond)
        ends = [0, contact] if contact <= self.joint else [0, self.joint, contact]
        angles = [context.asin(end / zone) for end in ends]
        pressed = context.quad(lambda t: self.elastic_depth(zone * context.sin(t)), angles)
        depth = self.depth(contact, zone)
        return (height - depth + 2 / context.pi * (depth * context.asin(contact / zone) - pressed) -
                4 * self.stress / (context.pi * self.modulus) * (zone - contact) -
                self.work / self.stress)

    def zone(self, contact):
        """Radius of the zone: a bracket, then a root, in the logarithm of what it is wider."""
        context = self.context
        excess = lambda wider: self.excess_gap(contact, contact * (1 + context.exp(wider)))
        low, high = context.mpf(-12), context.mpf(6)
        for _ in range(12):
            middle = (low + high) / 2
            low, high = (middle, high) if excess(middle) < 0 else (low, middle)
        return contact * (1 + context.exp(context.findroot(
            excess, (low, high), solver="anderson", tol=context.eps / 100, verify=False)))

    def depth_at(self, contact):
        return self.depth(contact, self.zone(contact))

    def pull(self, contact, zone):
        """Force of the cohesive zone."""
        width = mpmath.sqrt(zone**2 - contact**2)
        return 2 * self.stress * (zone**2 * mpmath.acos(contact / zone) + contact * width)


def check_maugis(checks, program):
    mp.dps = 20
    kept, cases = [], []
    for degrees in (10, 18, 35, 60):
        half_angle = mpmath.radians(degrees)
        tip = Tip(half_angle)
        # Ranges from a hundredth to a third of the radius.
        for work, stress in (("2e-4", "6e5"), ("2e-3", "4e5"), ("2e-2", "2e6")):
            maugis = Maugis(half_angle, work, stress)
            rounded = Maugis(half_angle, work, stress, mpmath.fp)
            for share in ("0.9", "1.01", "1.5", "4", "20"):
                contact = mpf(share) * tip.joint
                depth, *wider = [rounded.depth_at(float(contact) * factor)
                                 for factor in (1, 1.0001, 1.05, 1.2, 1.5, 2.5, 6)]
                if all(other > depth for other in wider):
                    zone = maugis.zone(contact)
                    state = (maugis.depth(contact, zone),
                             tip.elastic(contact)[1] - maugis.pull(contact, zone), zone)
                    kept.append((degrees, work, contact, state))
                    cases.append({"model": "md_sphere", "radius_m": RADIUS, "e_star_pa": MODULUS,
                                  "work_of_adhesion_j_m2": work, "sigma0_pa": stress,
                                  "indentation_m": mpmath.nstr(state[0], 20), "branch": "retract",
                                  "cone_half_angle_rad": mpmath.nstr(half_angle, 20)})
    checks.holds("Maugis' states that are stable", len(kept) >= 30, len(kept))
    for (degrees, work, contact, state), row in zip(kept, program.contact(cases)):
        depth, force, zone = state
        name = f"Maugis, {degrees} degrees, w {work}, a {float(contact):.4g} m"
        size = max(abs(force), 2 * contact * MODULUS * abs(depth))
        checks.near(name + ": force", row["force_n"], force, 1e-9, size)
        checks.near(name + ": contact radius", row["contact_radius_m"], contact, 1e-9)
        checks.near(name + ": cohesive radius", row["cohesive_radius_m"], zone, 1e-9)


def case(model, half_angle, work, depth):
    return {"model": model, "radius_m": RADIUS, "e_star_pa": MODULUS,
            "work_of_adhesion_j_m2": work, "sigma0_pa": 0, "indentation_m": depth,
            "branch": "retract", "cone_half_angle_rad": half_angle}


def states():
    """(model, half angle, w, contact radius): the widest contact at its indentation of each."""
    for half_angle in (10, 18, 35, 60):
        joint = mpmath.cos(mpmath.radians(half_angle))
        for share in ("0.3", "0.9", "0.9999", "1.0001", "1.1", "2", "10", "100"):
            yield "sneddon", half_angle, 0, mpf(share) * joint * RADIUS
        for work in ("1e-5", "1e-3"):
            # Beyond the joint from where d(delta)/da has passed its dip (4.8).
            for share in ("0.6", "3", "10", "100"):
                yield "jkr_sphere", half_angle, mpf(work), mpf(share) * joint * RADIUS


def is_widest(tip, contact, work):
    """Whether no wider contact has the same indentation, so that this one is stable at it."""
    # Beyond ten joints elastic indentation grows with a, and adhesion's part with its root only.
    depths = [tip.jkr(contact, work)[0]]
    while contact < 10 * tip.joint:
        contact *= mpf("1.1")
        depths.append(tip.jkr(contact, work)[0])
    return all(after > depths[0] for after in depths[1:])


def check_states(checks, program):
    kept, cases = [], []
    for model, degrees, work, contact in states():
        half_angle = mpmath.radians(degrees)
        tip = Tip(half_angle)
        depth, force = tip.jkr(contact, mpf(work))
        if work == 0 or is_widest(tip, contact, mpf(work)):
            kept.append((model, degrees, work, contact, depth, force))
            cases.append(case(model, float(half_angle), work, depth))
    checks.holds("states that are stable", len(kept) >= 48, len(kept))
    cases = [{key: value if isinstance(value, str) else mpmath.nstr(mpf(value), 20)
              for key, value in one.items()} for one in cases]
    for (model, degrees, work, contact, depth, force), row in zip(kept, program.contact(cases)):
        name = f"{model}, {degrees} degrees, w {float(work):g}, a {float(contact):.4g} m"
        # The depth is written to 20 digits and read in double: its rounding, 1e-16 of it, changes
        # the force by 2 a E* of it.
        size = max(abs(force), 2 * contact * MODULUS * abs(depth))
        checks.near(name + ": force", row["force_n"], force, 1e-9, size)
        checks.near(name + ": contact radius", row["contact_radius_m"], contact, 1e-9)
        wide = contact > mpf("0.3") * RADIUS
        checks.holds(name + ": strain", ("large_contact" in row["status"]) == wide, row["status"])


def check_limits(checks, program):
    """The same program against closed forms: slope, Sneddon's cone, sphere alone."""
    half_angle = float(mpmath.radians(18))
    tip = Tip(half_angle)
    depth = tip.elastic(mpf("2.5") * RADIUS)[0]
    step = depth * mpf("1e-4")
    low, high = program.contact([case("sneddon", half_angle, 0, float(depth + sign * step))
                                 for sign in (-1, 1)])
    slope = (mpf(high["force_n"]) - mpf(low["force_n"])) / (2 * step)
    checks.near("dP/ddelta against 2 a E*", slope, 5 * RADIUS * MODULUS, 1e-6)

    far = mpf(3000) * RADIUS
    row, = program.contact([case("sneddon", half_angle, 0, float(far))])
    # delta = (pi/2) a cot(alpha) and P = (2/pi) E* delta^2 tan(alpha). The sphere's apex lies
    # R (1 / sin(alpha) - 1) above that of the sharp cone, 0.75e-3 of this depth.
    checks.near("Sneddon's cone", row["force_n"], 2 / mp.pi * MODULUS * far**2 * mpmath.tan(half_angle),
                2e-3)

    depth = RADIUS / 2
    contact = bisected(lambda a: a * mpmath.atanh(a / RADIUS) - depth, 0, RADIUS * (1 - mpf(10)**-20))
    force = MODULUS * ((RADIUS**2 + contact**2) * mpmath.atanh(contact / RADIUS) - contact * RADIUS)
    row, = program.contact([case("sneddon", 0, 0, float(depth))])
    checks.near("sphere alone", row["force_n"], force, 1e-9)


def main(path):
    checks = Checks()
    program = Program(path)
    check_states(checks, program)
    check_limits(checks, program)
    check_maugis(checks, program)
    checks.finish()


if __name__ == "__main__":
    main(sys.argv[1])
