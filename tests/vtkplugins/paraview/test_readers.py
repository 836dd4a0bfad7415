#!/usr/bin/env python3
"""ParaView reads every height map as `asperity convert` does, to the bit: one of each format that
is written, and those of a folder of instruments' files where there is one.
Usage: test_readers.py ASPERITY [FOLDER]"""

import json
import pathlib
import subprocess
import sys
import tempfile

import paraview_setup as paraview

SCAN = paraview.TREE / "data/samples/granular_film.gsf"
WRITTEN = ("gwy", "gsf", "exr", "tiff", "png", "vti", "txt")
NO_SCANS = {".csv", ".md", ".rst"}
GIVEN = {"size": 1e-6, "height": 1e-9}  # of files that do not say it


def converted(asperity, file, out):
    """Options that were needed, or None where the file is refused."""
    for options in ([], ["--size", f"{GIVEN['size']}mx{GIVEN['size']}m"],
                    ["--size", f"{GIVEN['size']}mx{GIVEN['size']}m", "--z-scale",
                     str(GIVEN["height"])],
                    ["--z-scale", str(GIVEN["height"])]):
        done = subprocess.run([asperity, "convert", file, out, "--force", *options],
                              capture_output=True, text=True)
        if done.returncode == 0:
            return options
    return None


def main():
    asperity, *folders = sys.argv[1:]
    paraview.plugin()
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)
        files = []
        for extension in WRITTEN:
            files.append(out / f"film.{extension}")
            paraview.run([asperity, "convert", SCAN, files[-1]])
        for folder in map(pathlib.Path, folders):
            files += sorted(file for file in folder.rglob("*") if file.is_file()
                            and file.suffix not in NO_SCANS and file.parent.name != "LICENSES")
        tasks = []
        for number, file in enumerate(files):
            expected = out / f"expected_{number}.vti"
            options = converted(asperity, file, expected)
            tasks.append({"file": str(file), "expected": str(expected),
                          "refused": options is None,
                          "size": GIVEN["size"] if "--size" in (options or []) else 0.0,
                          "height": GIVEN["height"] if "--z-scale" in (options or []) else 0.0})
        (out / "tasks.json").write_text(json.dumps(tasks))
        output = paraview.pvbatch("read_scans.py", paraview.plugin(), out / "tasks.json")
        print("\n".join(line for line in output.splitlines() if line.endswith(" ok")))


if __name__ == "__main__":
    main()
