#!/usr/bin/env python3
"""A map that is killed again and again, at random, and goes on to the same bytes as one that is
left alone. Usage: killed_map.py ASPERITY SCAN KILLS ROWS"""

import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

COLUMNS = 24
QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


def command(program, scan, rows, out, *more):
    return [program, "map", scan, "--grid", f"{COLUMNS}x{rows}", "--no-pictures", "--out", str(out),
            *more]


def files_of(out):
    return [out.with_suffix(end) for end in (".gwy", ".vti", ".exr")]


def kill_after(arguments, is_time):
    """Whether it was killed before it ended by itself."""
    process = subprocess.Popen(arguments, **QUIET)
    while process.poll() is None and not is_time():
        time.sleep(0.001)
    process.send_signal(signal.SIGKILL)
    return process.wait() == -signal.SIGKILL


def size_of(part):
    try:
        return part.stat().st_size
    except FileNotFoundError:  # not begun, or done
        return 0


def kill_at_random(arguments, part, size, row_time):
    """As kill_after(), somewhere in the row after that in which the part reaches this size."""
    def is_time():
        if size_of(part) < size:
            return False
        time.sleep(random.uniform(0.0, row_time))
        return True
    return kill_after(arguments, is_time)


def largest_part(arguments, part):
    """Makes a map. Returns the size of its part before the end."""
    largest = 0
    process = subprocess.Popen(arguments, **QUIET)
    while process.poll() is None:
        largest = max(largest, size_of(part))
        time.sleep(0.001)
    assert process.returncode == 0 and largest > 0, (process.returncode, largest)
    return largest


def check_other_part(program, scan, rows, out):
    """The rows of one map are none of another."""
    other = subprocess.run(command(program, scan, rows, out, "--resume", "--setpoint", "7nN"),
                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    last = other.stderr.strip().splitlines()[-1]
    assert other.returncode == 1 and "rows of another map" in last, (other.returncode, last)


def main():
    program, scan = sys.argv[1:3]
    kills, rows = map(int, sys.argv[3:5])
    seed = time.time_ns()
    print("seed", seed)
    random.seed(seed)
    with tempfile.TemporaryDirectory() as name:
        whole, killed = pathlib.Path(name) / "whole.gwy", pathlib.Path(name) / "killed.gwy"
        begin = time.monotonic()
        largest = largest_part(command(program, scan, rows, whole), whole.with_name("whole.gwy.part"))
        row_time = (time.monotonic() - begin) / rows
        again = command(program, scan, rows, killed, "--resume")
        part = killed.with_name("killed.gwy.part")
        sizes = []
        for kill in range(kills):
            size = largest * (kill + random.random()) / (kills + 1)  # leaves rows to be done
            assert kill_at_random(again, part, size, row_time), "it ended before it was killed"
            sizes.append(size_of(part))
        assert sizes == sorted(sizes), sizes
        if sizes[-1] > 0:
            check_other_part(program, scan, rows, killed)
        kill_after(again, killed.with_suffix(".vti").exists)  # among the files of the whole map
        if part.exists():
            subprocess.run(again, check=True, **QUIET)
        assert not part.exists()
        for one, other in zip(files_of(whole), files_of(killed)):
            assert one.read_bytes() == other.read_bytes(), other.name
    print(f"killed {kills} times: the same bytes; the part grew to {sizes[-1]} bytes")


if __name__ == "__main__":
    main()
