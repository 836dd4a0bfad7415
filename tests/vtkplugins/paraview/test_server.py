#!/usr/bin/env python3
"""A server of 2 ranks computes a force map for a client. pvserver listens on every interface: both
run in a network namespace, where there is none but the loopback one."""

import pathlib
import subprocess
import sys
import tempfile
import time

import paraview_setup as paraview

PORT = 11111


def isolated():
    """Whether this process can have a network of its own."""
    return subprocess.run(["unshare", "-n", "bash", "-c", "ip link set lo up"],
                          stderr=subprocess.DEVNULL).returncode == 0


def serve_and_ask():
    """In the namespace: a server, and a client once it listens."""
    with tempfile.TemporaryFile("w+") as log:
        server = subprocess.Popen(
            ["mpirun", "--oversubscribe", "-np", "2", "pvserver", f"--server-port={PORT}"],
            env=paraview.ENVIRONMENT, stdout=log, stderr=subprocess.STDOUT, text=True)
        try:
            wait_for("Accepting connection", server, log)
            print(paraview.run(["pvpython", paraview.HERE / "client.py", paraview.plugin(),
                                paraview.TREE / "data/samples/granular_film.gsf", PORT], 120))
            assert server.wait(timeout=30) == 0  # it ends with its client
        finally:
            paraview.end(server)


def wait_for(words, server, log):
    """Before that, a client would go on without a connection."""
    end = time.monotonic() + 60
    while time.monotonic() < end and server.poll() is None:
        log.seek(0)
        if words in log.read():
            return
        time.sleep(0.1)
    log.seek(0)
    sys.exit(f"the server did not come up:\n{log.read()}")


def main():
    if sys.argv[1:] == ["--isolated"]:
        serve_and_ask()
        return
    paraview.plugin()
    if not isolated():
        print("skipped: this user may not make a network namespace, and pvserver would listen on "
              "every interface")
        sys.exit(paraview.SKIPPED)
    me = pathlib.Path(__file__).resolve()
    inside = f'ip link set lo up; exec "{sys.executable}" -B "{me}" --isolated'
    print(paraview.run(["unshare", "-n", "bash", "-c", inside]))


if __name__ == "__main__":
    main()
