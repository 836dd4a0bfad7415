#!/usr/bin/env python3
"""NeXus scans that h5py writes, in both orders and directions of axes, read by the program, and what
it refuses. Usage: nexus_scans.py ASPERITY"""

import json
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

ROWS, COLUMNS = 5, 8
# From the top, as a picture has it: each value tells its place.
IMAGE = numpy.array([[100.0 * row + column for column in range(COLUMNS)] for row in range(ROWS)])


def write_scan(path, *, definition="NXafm", axes=("y", "x"), falls=("y",), unit="nanometer",
               region=True, dtype=">f4", compression=None, places="micrometer", mode="w",
               name="entry", width=80.0):
    """The image along these axes, the slow one first, each rising or falling."""
    with h5py.File(path, mode) as file:
        file.attrs["NX_class"] = "NXroot"
        entry = file.create_group(name)
        entry.attrs["NX_class"] = "NXentry"
        entry["definition"] = definition
        group = entry.create_group("z_backward")
        group.attrs["NX_class"] = "NXdata"
        group.attrs["signal"] = "z"
        group.attrs["axes"] = list(axes)
        values = IMAGE if "y" in falls else IMAGE[::-1]
        values = values[:, ::-1] if "x" in falls else values
        values = values.T if axes[0] == "x" else values
        signal = group.create_dataset("z", data=values.astype(dtype), compression=compression)
        signal.attrs["units"] = unit
        for axis, count in (("x", COLUMNS), ("y", ROWS)):
            rising = 2e-3 * numpy.arange(count)
            group[axis] = rising[::-1] if axis in falls else rising
            group[axis].attrs["units"] = places
        line = entry.create_group("spectrum")
        line.attrs["NX_class"] = "NXdata"
        line.attrs["signal"] = "current"
        line["current"] = [1.0, 2.0]
        if region:
            scan = entry.create_group("instrument/scan_environment/scan_control/scan_region")
            for key, value in (("scan_range_x", width), ("scan_range_y", 25.0),
                               ("scan_offset_value_x", 100.0), ("scan_offset_value_y", -7.5)):
                scan[key] = value
                scan[key].attrs["units"] = "nanometer"


class Files:
    def __init__(self, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)

    def run(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              timeout=120)

    def heights(self, path):
        """In nm, the top row first."""
        out = self.folder / "out.txt"
        out.unlink(missing_ok=True)
        run = self.run("convert", path, out)
        assert run.returncode == 0, run.stderr
        return 1e9 * numpy.loadtxt(out)

    def info(self, path):
        run = self.run("info", path, "--json")
        assert run.returncode == 0, run.stderr
        return json.loads(run.stdout)

    def refusal(self, path):
        run = self.run("info", path)
        assert run.returncode == 3 and run.stderr.count("\n") == 1, (run.returncode, run.stderr)
        return run.stderr


def check_each_direction(files):
    path = files.folder / "scan.nxs"
    for axes in (("y", "x"), ("x", "y")):
        for falls in ((), ("x",), ("y",), ("x", "y")):
            for more in ({}, {"dtype": "<f8", "compression": "gzip"}, {"dtype": "<i2"}):
                write_scan(path, axes=axes, falls=falls, **more)
                assert numpy.allclose(files.heights(path), IMAGE, rtol=1e-6), (axes, falls, more)


def check_facts(files):
    path = files.folder / "scan.nxs"
    write_scan(path)
    info = json.dumps(files.info(path))
    for fact in ('"z"', '"backward"', "NXafm"):
        assert fact in info, (fact, info)
    width, height = sizes(files.info(path))
    assert abs(width / 80e-9 - 1) < 1e-9 and abs(height / 25e-9 - 1) < 1e-9, (width, height)
    write_scan(path, region=False, definition="NXstm")
    width, height = sizes(files.info(path))
    assert abs(width / 16e-9 - 1) < 1e-9 and abs(height / 10e-9 - 1) < 1e-9, (width, height)
    write_scan(path, region=False, places="volt")
    assert not files.info(path)["channels"][0]["size_known"], "axes in volts say no size"
    write_scan(path)
    write_scan(path, mode="a", name="second", width=40.0)
    widths = sorted(channel["size_x_m"] for channel in files.info(path)["channels"])
    assert numpy.allclose(widths, [40e-9, 80e-9], rtol=1e-9), "each entry has its own range"


def sizes(info):
    channel = info["channels"][0]
    return channel["size_x_m"], channel["size_y_m"]


def check_refusals(files):
    path = files.folder / "other.nxs"
    write_scan(path, definition="NXarpes")
    assert "a NeXus file of no NXafm, NXstm or NXspm" in files.refusal(path)
    write_scan(path)
    whole = path.read_bytes()
    for size in (len(whole) // 8, len(whole) // 2, len(whole) - 100):
        path.write_bytes(whole[:size])
        files.refusal(path)


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        files = Files(program, folder)
        check_each_direction(files)
        check_facts(files)
        check_refusals(files)


if __name__ == "__main__":
    main(sys.argv[1])
