#!/usr/bin/python3
"""Gaussian and cubic B-spline coefficients by scipy.ndimage, in single precision.

scipy_fit.py FILE COLUMNS ROWS SIGMA: reads the heights from FILE, writes the coefficients back and
prints the time that both filters took [ns].
"""
import sys
import time

import numpy
from scipy import ndimage


def main(path, columns, rows, sigma):
    heights = numpy.fromfile(path, dtype=numpy.float32).reshape(int(rows), int(columns))
    begin = time.perf_counter_ns()
    smooth = ndimage.gaussian_filter(heights, float(sigma), truncate=5.0)
    coefficients = ndimage.spline_filter(smooth, order=3, output=numpy.float32)
    taken = time.perf_counter_ns() - begin
    coefficients.tofile(path)
    print(taken)


if __name__ == "__main__":
    main(*sys.argv[1:])
