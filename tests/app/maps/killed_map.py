#!/usr/bin/env python3
"""A map that is killed again and again goes on to the same bytes as one that is left alone. It is
killed by the bytes that it has written: no pace of the machine is in it.
Usage: killed_map.py ASPERITY ASPERITY_TRACED SCAN KILLS ROWS"""

import pathlib
import subprocess
import sys
import tempfile

COLUMNS = 24
QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


def command(program, scan, rows, out, *more):
    return [program, "map", scan, "--grid", f"{COLUMNS}x{rows}", "--no-pictures", "--out", str(out),
            *more]


def files_of(out):
    return [out.with_suffix(end) for end in (".gwy", ".vti", ".exr")]


def run_traced(traced, arguments, most="", made=""):
    """Kills it before it writes more bytes or makes what ends so. Returns whether that happened,
    and the bytes that it has written."""
    done = subprocess.run([traced, str(most), made, *arguments], check=True, text=True,
                          stdout=subprocess.PIPE)
    was_killed, exit_code, written = map(int, done.stdout.split())
    assert was_killed or exit_code == 0, exit_code
    return bool(was_killed), written


def size_of(part):
    try:
        return part.stat().st_size
    except FileNotFoundError:  # not begun, or done
        return 0


def check_other_part(program, scan, rows, out):
    """The rows of one map are none of another."""
    other = subprocess.run(command(program, scan, rows, out, "--resume", "--setpoint", "7nN"),
                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    last = other.stderr.strip().splitlines()[-1]
    assert other.returncode == 1 and "rows of another map" in last, (other.returncode, last)


def main():
    program, traced, scan = sys.argv[1:4]
    kills, rows = map(int, sys.argv[4:6])
    with tempfile.TemporaryDirectory() as name:
        whole, killed = pathlib.Path(name) / "whole.gwy", pathlib.Path(name) / "killed.gwy"
        was_killed, _ = run_traced(traced, command(program, scan, rows, whole), made=".vti")
        assert was_killed
        part = whole.with_name("whole.gwy.part")
        of_rows = size_of(part)
        subprocess.run(command(program, scan, rows, whole, "--resume"), check=True, **QUIET)
        again = command(program, scan, rows, killed, "--resume")
        part = killed.with_name("killed.gwy.part")
        sizes = []
        for _ in range(kills):  # each leaves rows to be done
            was_killed, _ = run_traced(traced, again, of_rows // (kills + 1))
            assert was_killed, "it ended before it was killed"
            sizes.append(size_of(part))
        assert sizes == sorted(sizes) and 0 < sizes[-1] < of_rows, (sizes, of_rows)
        check_other_part(program, scan, rows, killed)
        was_killed, _ = run_traced(traced, again, made=".exr")  # among the files of the whole map
        assert was_killed and part.exists() and killed.with_suffix(".vti").exists()
        subprocess.run(again, check=True, **QUIET)
        assert not part.exists()
        for one, other in zip(files_of(whole), files_of(killed)):
            assert one.read_bytes() == other.read_bytes(), other.name
    print(f"killed {kills} times: the same bytes; the part grew to {sizes[-1]} bytes")


if __name__ == "__main__":
    main()
