#!/usr/bin/env python3
"""The filter AFM force map on 1, 2 and 4 ranks gives the bits of `asperity map`.
Usage: test_force_map.py ASPERITY"""

import pathlib
import sys
import tempfile

import paraview_setup as paraview

SCAN = paraview.TREE / "data/samples/granular_film.gsf"
SCENE = paraview.TREE / "data/scenes/granular_film.toml"
METERS, NANOMETERS = "1", "1e-9"


def small_scan(path):
    """A scan of few pixels with a hole, and a pitch that nanometers round."""
    import array
    import math
    columns, rows = 31, 23
    heights = array.array("f", (2e-9 * math.sin(0.7 * x) * math.cos(0.4 * y) + 1e-10 * x
                                for y in range(rows) for x in range(columns)))
    heights[5 * columns + 7] = math.nan
    head = (f"Gwyddion Simple Field 1.0\nXRes = {columns}\nYRes = {rows}\nXReal = 1.23456789e-07\n"
            "YReal = 9.1e-08\nXYUnits = m\nZUnits = m\n").encode()
    path.write_bytes(head + b"\0" * (4 - len(head) % 4) + heights.tobytes())


def check(asperity, folder, name, scan, scene, grid, mode, setpoint):
    """One map by the program, by ranks in meters, and in nanometers."""
    expected = folder / f"{name}.gwy"
    options = [] if grid == "0x0" else ["--grid", grid]
    paraview.run([asperity, "map", scene or scan, "--out", expected, "--mode", mode, "--setpoint",
                  setpoint, "--no-pictures", *options])
    made = []
    for ranks, unit in ((1, METERS), (2, METERS), (4, METERS), (2, NANOMETERS)):
        made.append(folder / f"{name}_{ranks}_{unit}.pvti")
        output = paraview.pvbatch("force_map.py", paraview.plugin(), scan, scene or "-", unit, grid,
                                  mode, setpoint, made[-1], ranks=ranks)
        print(name, *(line for line in output.splitlines() if "rank" in line))
    print(paraview.pvbatch("compare_maps.py", expected.with_suffix(".vti"), *made))


def main():
    asperity = sys.argv[1]
    paraview.plugin()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scan = folder / "small.gsf"
        small_scan(scan)
        check(asperity, folder, "film", SCAN, SCENE, "48x41", "approach", "5e-9")
        check(asperity, folder, "raster", SCAN, SCENE, "48x3", "contact", "3e-9")
        check(asperity, folder, "pixels", scan, None, "0x0", "approach", "2e-9")


if __name__ == "__main__":
    main()
