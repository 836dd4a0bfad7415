"""ParaView as tools/build_paraview.sh sets it up, for the tests of the plugin."""

import os
import pathlib
import subprocess
import sys

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent
TREE = HERE.parents[2]
FOLDER = TREE / "build" / "paraview"
ROOT = FOLDER / "root" / "usr"
ENVIRONMENT = os.environ | {
    "PATH": f"{ROOT}/bin:{os.environ['PATH']}",
    "LD_LIBRARY_PATH": f"{ROOT}/lib/x86_64-linux-gnu",
    "PYTHONPATH": f"{ROOT}/lib/python3/dist-packages:{HERE}",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
}


def plugin():
    """The plugin's file; ends the test as skipped where there is none."""
    found = list((FOLDER / "plugin").rglob("AsperityPlugin.so"))
    if not (FOLDER / "root" / "complete").exists() or not found:
        print("skipped: the plugin for ParaView is not built here; tools/build_paraview.sh sets "
              "ParaView up and builds it")
        sys.exit(SKIPPED)
    plan = subprocess.run(["cmake", "--build", FOLDER / "plugin", "--", "-n"], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if "no work to do" not in plan.stdout:
        print("skipped: the plugin for ParaView is older than its sources; "
              "tools/build_paraview.sh builds it anew")
        sys.exit(SKIPPED)
    return str(found[0])


def run(command, seconds=300):
    """The output of a command, which must end well."""
    process = subprocess.Popen([str(part) for part in command], env=ENVIRONMENT, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        output, _ = process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        end(process)
        sys.exit(f"{command} took longer than {seconds} s")
    if process.returncode != 0:
        sys.exit(f"{output}\nexit code {process.returncode} of {command}")
    return output


def end(process):
    """Ends a process that may be mpirun, which then ends its ranks; killed it would leave them."""
    process.terminate()
    try:
        process.wait(timeout=10)
    except subprocess.TimeoutExpired:
        process.kill()


def pvbatch(script, *arguments, ranks=1):
    """Runs a script of this folder, which says "done" at its end."""
    start = ["mpirun", "--oversubscribe", "-np", ranks] if ranks > 1 else []
    output = run([*start, "pvbatch", HERE / script, *arguments])
    if "done" not in output.splitlines():
        sys.exit(f"{output}\n{script} did not come to its end")
    return output
