#!/usr/bin/env python3
"""The compact recording of `asperity explore --format h5` as h5py reads it, beside the text tables
of the same run. Usage: compact_run.py ASPERITY SCENE"""

import csv
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

SINGLE = 2.0 ** -24  # relative


def text_table(path):
    """Columns of a CSV table by name: lists of text."""
    with path.open(newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def compare(name, dataset, cells):
    stored = dataset[:]
    if dataset.dtype.kind == "S":
        assert [cell.decode("utf-8") for cell in stored] == cells, f"{name} differs"
        return
    numbers = numpy.array([float(cell) for cell in cells])
    if dataset.dtype == numpy.float32:
        error = numpy.abs(stored.astype(float) - numbers)
        assert (error <= SINGLE * numpy.abs(numbers)).all(), f"{name} is not the nearest float"
    else:
        assert dataset.dtype == numpy.float64
        assert (stored == numbers).all(), f"{name} has lost digits"
    unit = {"m": "m", "n": "N", "rad": "rad", "s": "s", "hz": "Hz"}.get(name.rsplit("_", 1)[-1])
    if unit and "_n_" not in name and "_m_s" not in name:
        assert dataset.attrs["unit"] == unit, f"{name}: unit {dataset.attrs.get('unit')}"


def main(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for form in ("csv", "h5"):
            subprocess.run([program, "explore", scene, "--duration", "1", "--format", form, "--out",
                            folder / form], check=True, capture_output=True)
        with h5py.File(folder / "h5/recording.h5", "r") as file:
            assert file.attrs["format"] == b"asperity recording"
            for table in ("tick_input", "force_log"):
                text = text_table(folder / "csv" / f"{table}.csv")
                assert list(file[table]) == list(text), "columns differ"
                assert all(column.shape == (1001,) for column in file[table].values())
                for name, cells in text.items():
                    compare(f"{table}/{name}", file[table][name], cells)
            assert file["force_log/alpha_rad"] == file["tick_input/alpha_rad"], "not shared"
    print("values and units are equal")


if __name__ == "__main__":
    main(*sys.argv[1:])
