#!/usr/bin/env python3
"""Runs the tests of one suite of a GoogleTest program in one process.

When the process crashes, or one test takes longer than the limit, that test is named and those not
run yet run in a new process. A listed test without a result is a failure. The program has a home
of its own, with --display an X server of its own, too: suites that run at a time share no
focus, pointer, clipboard or settings. Program and server end with this script, however that ends.
The output of passing tests is not printed.
Usage: tools/run_suite.py --display build/release/bin/asperity_panels_tests 'CardTest.*'
"""

import argparse
import contextlib
import glob
import os
import pathlib
import select
import signal
import subprocess
import sys
import tempfile
import time

import gtest_results
from gtest_results import Result

SCREEN = "1600x1000x24"


def start(command, last_signal, **options):
    """Starts a program, in a process group, that gets last_signal when this script ends.

    Not in a session: the first terminal that the leader of one opens, such as the one behind a virtual
    device, becomes its own, and closing it ends the program by SIGHUP.
    """
    return subprocess.Popen(["setpriv", "--pdeathsig", last_signal, *command],
                            stdin=subprocess.DEVNULL, process_group=0, **options)


@contextlib.contextmanager
def own_display():
    """Runs an X server; yields the name of its display, a free number that the server finds."""
    reader, writer = os.pipe()
    with start(["Xvfb", "-displayfd", str(writer), "-screen", "0", SCREEN, "-noreset", "-nolisten",
                "tcp"], "TERM", pass_fds=[writer], stdout=subprocess.DEVNULL,
               stderr=subprocess.DEVNULL) as server:
        os.close(writer)
        try:
            with open(reader, encoding="ascii") as answer:
                number = answer.readline().strip()
            if not number:
                sys.exit("no display: Xvfb could not be started (Debian package xvfb)")
            yield f":{number}"
        finally:
            server.terminate()


def own_environment(folder):
    """Returns the environment with homes in a folder.

    The cache stays the user's: without its shaders the first picture of each suite takes longer.
    """
    environment = dict(os.environ)
    environment.setdefault("XDG_CACHE_HOME", str(pathlib.Path.home() / ".cache"))
    for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"):
        home = folder / name.lower()
        home.mkdir(mode=0o700)
        environment[name] = str(home)
    return environment


class Suite:
    """Some tests of a program: runs them and collects their results and what to print."""

    def __init__(self, program, limit, prefix, environment):
        self.program = program
        self.limit = limit  # seconds that a test may take
        self.prefix = prefix  # of the paths of results
        self.environment = environment
        self.results = {}
        self.failures = []  # one line each
        self.output = []  # lines of what failed
        self.processes = 0

    def listed(self, wanted):
        """Returns the tests that a filter names."""
        run = subprocess.run([self.program, "--gtest_list_tests", f"--gtest_filter={wanted}"],
                             env=self.environment, stdin=subprocess.DEVNULL, text=True,
                             capture_output=True, errors="replace", check=False)
        tests = gtest_results.listed_tests(run.stdout)
        if run.returncode != 0 or not tests:
            sys.exit(f"{run.stdout}{run.stderr}{self.program} lists no tests named {wanted}")
        return tests

    def run(self, tests):
        """Runs tests in as many processes as they take."""
        left, goes_on = tests, True
        while left and goes_on:
            goes_on = self.run_process(left)
            left = [test for test in left if test not in self.results]
        missing = {test: Result("failed", "no result") for test in left}
        for test in missing:
            self.fail(f"NO RESULT {test}", [])
        if missing:
            self.results |= missing
            gtest_results.write_xml(self.file("missing.xml"), missing)

    def run_process(self, tests):
        """Runs tests in one process; returns whether another one can run what it left over."""
        self.processes += 1
        log, xml = self.file(f"{self.processes}.log"), self.file(f"{self.processes}.xml")
        command = [self.program, f"--gtest_filter={':'.join(tests)}", f"--gtest_output=xml:{xml}",
                   "--gtest_color=no", "--gtest_brief=0"]
        with open(log, "wb") as written:
            process = start(command, "KILL", env=self.environment, stdout=written,
                            stderr=subprocess.STDOUT)
            timed_out = not self.ends(process, log)
        code = process.returncode
        end = (f"TIMED OUT {{}} ({self.limit:g} s)" if timed_out else
               f"CRASHED {{}} (signal {-code})" if code < 0 else f"EXITED {{}} (exit code {code})")
        output = output_in(log)
        results = gtest_results.read_xml(xml)  # written after all tests
        ended_early = results is None
        if ended_early:
            results = results_until(end, output)
            gtest_results.write_xml(xml, results)
        elif not output.sections:  # a global environment has skipped all: GoogleTest says "completed"
            xml.unlink()
            results = {}
        failed = [test for test, result in results.items() if result.outcome == "failed"]
        for test in failed:
            self.fail(end.format(test) if test == output.running else f"FAILED {test}",
                      output.sections.get(test, []))
        if not output.running and (ended_early or not results or (code != 0 and not failed)):
            # What a sanitizer reports while a test runs stands in the test's part: it passes all the same.
            sections = () if ended_early else output.sections.values()
            self.fail(end.format("outside of the tests"),
                      output.outside + [line for section in sections if len(section) > 2 for line in section])
        self.results |= results
        return ended_early and not results.keys().isdisjoint(tests)

    def ends(self, process, log):
        """Waits until a process ends; ends it and returns False where one test takes too long."""
        pause = min(1.0, self.limit / 4)
        printed, since = 0, time.monotonic()
        ended = os.pidfd_open(process.pid)
        try:
            while not select.select([ended], [], [], pause)[0]:
                output = output_in(log)
                if printed != len(output.sections) + len(output.outcomes):
                    printed, since = len(output.sections) + len(output.outcomes), time.monotonic()
                elif time.monotonic() - since > self.limit:
                    return False
            return True
        finally:
            os.close(ended)
            # What a test has left running ends, too. Not after wait(): the id may be another's.
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def fail(self, line, output):
        self.failures.append(line)
        self.output += output

    def file(self, ending):
        """Returns the path of a file of results."""
        return self.prefix.with_name(f"{self.prefix.name}.{ending}")

    def print_report(self):
        """Prints what failed, then one line on each test that was skipped or failed, then counts."""
        for line in self.output:
            print(line)
        for test, result in self.results.items():
            if result.outcome == "skipped":
                print(gtest_results.skip_line(test, result))
        for line in self.failures:
            print(line)
        print(f"{self.prefix.name}: {gtest_results.summary(self.results.values())}")


def results_until(end, output):
    """Returns the results of a process that ended before it wrote them."""
    results = {test: Result(outcome, "\n".join(output.sections[test][1:-1]))
               for test, outcome in output.outcomes.items()}
    if output.running:
        results[output.running] = Result("failed", end.format(output.running))
    return results


def output_in(log):
    return gtest_results.Output(log.read_text(encoding="utf-8", errors="replace"))


def parsed_options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--display", action="store_true", help="run with an X server")
    parser.add_argument("--limit", type=float, default=1500, metavar="SECONDS",
                        help="what one test may take")
    parser.add_argument("--results", type=pathlib.Path, metavar="PREFIX",
                        help="keep results: PREFIX.1.xml, PREFIX.1.log, 2 after a crash")
    parser.add_argument("program")
    parser.add_argument("filter", help="as in --gtest_filter")
    return parser.parse_args()


def remove_earlier_results(prefix):
    prefix.parent.mkdir(parents=True, exist_ok=True)
    for ending in ("[0-9]*", "missing"):  # "contact" is not to remove those of "contact.PullOffAlone"
        for file in prefix.parent.glob(f"{glob.escape(prefix.name)}.{ending}.*"):
            file.unlink()


def main():
    options = parsed_options()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # by way of each "finally"
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(
            prefix="asperity_suite_", ignore_cleanup_errors=True)))
        environment = own_environment(folder)
        if options.display:
            environment["DISPLAY"] = stack.enter_context(own_display())
        prefix = options.results or folder / "tests"
        remove_earlier_results(prefix)
        suite = Suite(options.program, options.limit, prefix, environment)
        suite.run(suite.listed(options.filter))
    suite.print_report()
    return 1 if suite.failures else 0


if __name__ == "__main__":
    sys.exit(main())
