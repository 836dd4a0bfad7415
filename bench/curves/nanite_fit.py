#!/usr/bin/env python3
"""Elastic fit of the approach of a force curve under a cone by nanite.

nanite_fit.py FILE HALF_ANGLE: prints the median time of reading, preparation and fit [ns], and the
modulus [Pa]. Half angle in degrees.
"""
import statistics
import sys
import time

import nanite

REPEATS = 11


def fitted_modulus(path, half_angle):
    curve = nanite.IndentationGroup(path)[0]
    curve.apply_preprocessing(["compute_tip_position", "correct_force_offset", "correct_tip_offset"])
    start = curve.get_initial_fit_parameters(model_key="hertz_cone")
    start["alpha"].set(value=half_angle)
    curve.fit_model(model_key="hertz_cone", params_initial=start, weight_cp=False)
    return curve.fit_properties["params_fitted"]["E"].value


def main(path, half_angle):
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter_ns()
        modulus = fitted_modulus(path, float(half_angle))
        times.append(time.perf_counter_ns() - begin)
    print("%d %.9g" % (statistics.median(times), modulus))


if __name__ == "__main__":
    main(*sys.argv[1:])
