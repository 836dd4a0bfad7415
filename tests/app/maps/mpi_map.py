#!/usr/bin/env python3
"""A map by several processes under mpirun has the bytes of one by a single process, whatever their
number, their threads and the way between them; where one of them dies the job ends with a sentence
and goes on later to the same bytes. Usage: mpi_map.py ASPERITY SCENE"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

COLUMNS = 64
ROWS = 64
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def map_command(program, scene, out, *more, rows=ROWS):
    grid = f"{COLUMNS}x{rows}"
    return [program, "map", scene, "--grid", grid, "--no-pictures", "--out", str(out), *more]


def ranks(count, *more):
    return ["mpirun", "--oversubscribe", *more, "-np", str(count)]


def run(command):
    return subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=300)


def bytes_of(out):
    return [out.with_suffix(end).read_bytes() for end in (".gwy", ".vti", ".exr")]


def check_same(program, scene, folder, whole):
    ways = [(1, [], []), (2, [], []), (3, [], ["--threads", "2"]), (8, [], ["--threads", "1"]),
            (2, ["--mca", "btl", "tcp,self"], ["--threads", "1"])]
    for number, (count, how, options) in enumerate(ways):
        out = folder / f"ranks{number}.gwy"
        done = run(ranks(count, *how) + map_command(program, scene, out, *options))
        assert done.returncode == 0, done.stderr
        assert bytes_of(out) == whole, (count, how, options)
        assert not out.with_name(out.name + ".part").exists()


def workers_of(job):
    """The processes that the launcher has started, in the order of their ranks."""
    listed = subprocess.run(["pgrep", "-P", str(job.pid)], capture_output=True, text=True)
    return sorted(int(pid) for pid in listed.stdout.split())


def kill_last_rank(job):
    for worker in workers_of(job)[-1:]:  # none where the job is done
        os.kill(worker, signal.SIGKILL)


def interrupt(job):
    job.send_signal(signal.SIGINT)


def end_early(command, part, count, end):
    """Ends a job of so many ranks when its first rows are kept. @return its exit code and message"""
    job = subprocess.Popen(ranks(count) + command, env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, text=True)
    while job.poll() is None and not (part.exists() and part.stat().st_size > 4000):
        time.sleep(0.005)
    end(job)
    said = job.communicate(timeout=300)[1]
    return job.returncode, said


def check_ended(program, scene, folder, count, end):
    """A job that is ended early: rank 0 has a second to say what is kept. On a fast machine, or one
    that left this script waiting, a small map may be done before; one of these is not."""
    for rows in (ROWS, 4 * ROWS, 16 * ROWS):
        out = folder / f"ended{count}_{rows}.gwy"
        part = out.with_name(out.name + ".part")
        command = map_command(program, scene, out, "--threads", "1", rows=rows)
        code, said = end_early(command, part, count, end)
        if part.exists():
            break
        assert out.exists(), said
    assert code != 0
    assert "--resume continues the map" in said, said
    assert part.exists() and not out.exists()
    done = run(ranks(count) + command + ["--resume"])
    assert done.returncode == 0, done.stderr
    alone = folder / f"alone{count}_{rows}.gwy"
    assert run(map_command(program, scene, alone, rows=rows)).returncode == 0
    assert bytes_of(out) == bytes_of(alone)


def check_refused(program, scene, folder):
    """What goes wrong on every rank is said once."""
    done = run(ranks(2) + map_command(program, str(folder / "none.toml"), folder / "x.gwy"))
    assert done.returncode == 3, done
    assert done.stderr.count("no such file") == 1, done.stderr


def main():
    program, scene = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        alone = folder / "alone.gwy"
        done = run(map_command(program, scene, alone))
        assert done.returncode == 0, done.stderr
        whole = bytes_of(alone)
        check_same(program, scene, folder, whole)
        check_ended(program, scene, folder, 2, kill_last_rank)
        check_ended(program, scene, folder, 1, interrupt)
        check_refused(program, scene, folder)
    print("1, 2, 3 and 8 ranks, in shared memory and over TCP: the same bytes")


if __name__ == "__main__":
    main()
