"""tools/run_suite.py names what crashed, hangs or is missing, and runs the rest; tools/gtest_results.py counts."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

from planted_tree import TOOLS

# Behaves as a GoogleTest program; a test's name says what it does.
PROGRAM = r"""#!/usr/bin/env python3
import os, sys, time
from xml.sax.saxutils import quoteattr

tests = {tests}
flags = dict(argument[2:].partition("=")[::2] for argument in sys.argv[1:])
wanted = flags["gtest_filter"].split(":")
tests = [test for test in tests if wanted == ["S.*"] or "S." + test in wanted]
if "gtest_list_tests" in flags:
    print("Running main() from gtest_main.cc\nS.")
    for test in tests:
        print("  " + test + ("  # GetParam() = 1" if "/" in test else ""))
    sys.exit()
cases = []
for test in tests:
    if test == "Forgotten":
        continue
    if test == "CrashesBefore":
        os.abort()
    if "EnvironmentSkips" not in tests:
        print("[ RUN      ] S." + test, flush=True)
    if test == "Skips":
        print("T.cpp:5: Skipped\nno <device>")
    else:
        print("printed by", test, os.environ.get("DISPLAY"), os.environ["HOME"], end="", flush=True)
    if test == "Races":
        print("\nWARNING: data race", flush=True)
    if test.startswith("Crashes"):
        os.kill(os.getpid(), 11)
    if test == "Exits":
        sys.exit(0)
    if test == "ClosesATerminal":
        master, slave = os.openpty()
        os.open(os.ttyname(slave), os.O_RDWR)
        os.close(master)
    while test == "Hangs":
        time.sleep(1)
    tag = dict(Fails="failure", Skips="skipped").get(test.split("/")[0])
    word = dict(failure="[  FAILED  ]", skipped="[  SKIPPED ]").get(tag, "[       OK ]")
    print(word, "S." + test + (", where GetParam() = 1" if "/" in test and tag else ""), "(0 ms)", flush=True)
    inner = "<" + tag + " message=" + quoteattr("T.cpp:5\nno <device>") + "/>" if tag else ""
    cases.append('<testcase classname="S" name="' + test + '" status="run">' + inner + "</testcase>")
if "EnvironmentFails" in tests:
    cases.append('<testcase classname="" name="" status="run"><failure message="no"/></testcase>')
with open(flags["gtest_output"].removeprefix("xml:"), "w") as file:
    file.write("<testsuites>" + "".join(cases) + "</testsuites>")
sys.exit(23 if {"LeaksAtTheEnd", "Races", "EnvironmentFails"} & set(tests) else "failure" in "".join(cases))
"""


class RunSuite(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        own = unittest.mock.patch.dict(os.environ, TMPDIR=folder.name)  # for what a killed suite leaves
        own.start()
        self.addCleanup(own.stop)

    def command(self, tests, *options):
        program = self.folder / "program"
        program.write_text(PROGRAM.replace("{tests}", repr(tests.split())))
        program.chmod(0o755)
        return [sys.executable, "-B", TOOLS / "run_suite.py", "--results", self.folder / "results" / "a.S",
                *options, program, "S.*"]

    def run_suite(self, tests, *options):
        """Returns exit code and lines."""
        run = subprocess.run(self.command(tests, *options), capture_output=True, text=True)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout.splitlines()

    def count(self):
        run = subprocess.run([sys.executable, "-B", TOOLS / "gtest_results.py", self.folder / "results"],
                             capture_output=True, text=True)
        self.assertEqual(run.stderr, "")
        return run.returncode, run.stdout.splitlines()

    def test_prints_one_line_where_all_pass(self):
        self.assertEqual(self.run_suite("First Second/0"),
                         (0, ["a.S: 2 tests, 2 passed, 0 skipped, 0 failed"]))
        self.assertEqual(self.count(), (0, ["2 tests, 2 passed, 0 skipped, 0 failed"]))

    def test_names_what_was_skipped_and_why(self):
        skipped = "SKIPPED S.Skips: no <device>"
        self.assertEqual(self.run_suite("First Skips"),
                         (0, [skipped, "a.S: 2 tests, 1 passed, 1 skipped, 0 failed"]))
        self.assertEqual(self.count(), (0, [skipped, "2 tests, 1 passed, 1 skipped, 0 failed"]))

    def test_prints_the_output_of_failures_only(self):
        code, lines = self.run_suite("First Fails/0 Last")
        self.assertEqual(code, 1)
        self.assertEqual(lines[0], "[ RUN      ] S.Fails/0")
        self.assertTrue(lines[1].startswith("printed by Fails/0"))
        self.assertEqual(lines[2:], ["FAILED S.Fails/0", "a.S: 3 tests, 2 passed, 0 skipped, 1 failed"])
        self.assertEqual(self.count(), (1, ["FAILED S.Fails/0", "3 tests, 2 passed, 0 skipped, 1 failed"]))

    def test_names_each_crash_and_runs_the_rest(self):
        code, lines = self.run_suite("First Skips CrashesA Fails CrashesB Last")
        self.assertEqual(code, 1)
        self.assertEqual(lines[-5:], [
            "SKIPPED S.Skips: no <device>", "CRASHED S.CrashesA (signal 11)",
            "FAILED S.Fails", "CRASHED S.CrashesB (signal 11)",
            "a.S: 6 tests, 2 passed, 1 skipped, 3 failed"])
        self.assertNotIn("printed by First", "\n".join(lines))
        self.assertEqual(self.count()[1][-4:], ["FAILED S.CrashesA", "FAILED S.Fails", "FAILED S.CrashesB",
                                                "6 tests, 2 passed, 1 skipped, 3 failed"])

    def test_a_terminal_that_closes_ends_no_test(self):
        self.assertEqual(self.run_suite("First ClosesATerminal"),
                         (0, ["a.S: 2 tests, 2 passed, 0 skipped, 0 failed"]))

    def test_names_a_test_that_ends_the_program(self):
        code, lines = self.run_suite("First Exits Last")
        self.assertEqual((code, lines[-2:]), (1, ["EXITED S.Exits (exit code 0)",
                                                  "a.S: 3 tests, 2 passed, 0 skipped, 1 failed"]))

    def test_ends_and_names_a_test_that_hangs(self):
        code, lines = self.run_suite("First Hangs Last", "--limit", "1")
        self.assertEqual((code, lines[-2:]), (1, ["TIMED OUT S.Hangs (1 s)",
                                                  "a.S: 3 tests, 2 passed, 0 skipped, 1 failed"]))

    def test_names_tests_without_result(self):
        self.assertEqual(self.run_suite("First Forgotten Last"),
                         (1, ["NO RESULT S.Forgotten", "a.S: 3 tests, 2 passed, 0 skipped, 1 failed"]))
        self.assertEqual(self.count(),
                         (1, ["FAILED S.Forgotten", "3 tests, 2 passed, 0 skipped, 1 failed"]))

    def test_does_not_begin_forever_where_no_test_begins(self):
        self.assertEqual(self.run_suite("CrashesBefore Second"),
                         (1, ["CRASHED outside of the tests (signal 6)", "NO RESULT S.CrashesBefore",
                              "NO RESULT S.Second", "a.S: 2 tests, 0 passed, 0 skipped, 2 failed"]))

    def test_a_test_that_never_began_has_no_result(self):
        code, lines = self.run_suite("EnvironmentSkips Second")
        self.assertEqual((code, lines[-3:]), (1, [
            "NO RESULT S.EnvironmentSkips", "NO RESULT S.Second",
            "a.S: 2 tests, 0 passed, 0 skipped, 2 failed"]))
        self.assertEqual(self.count()[1][-1], "2 tests, 0 passed, 0 skipped, 2 failed")

    def test_fails_where_the_program_fails_after_its_tests(self):
        self.assertEqual(self.run_suite("First LeaksAtTheEnd"),
                         (1, ["EXITED outside of the tests (exit code 23)",
                              "a.S: 2 tests, 2 passed, 0 skipped, 0 failed"]))

    def test_prints_what_a_sanitizer_says_while_a_test_passes(self):
        code, lines = self.run_suite("First Races Last")
        self.assertEqual((code, lines[0], lines[2]), (1, "[ RUN      ] S.Races", "WARNING: data race"))
        self.assertEqual(lines[-2:], ["EXITED outside of the tests (exit code 23)",
                                      "a.S: 3 tests, 3 passed, 0 skipped, 0 failed"])

    def test_fails_where_a_global_environment_fails(self):
        self.assertEqual(self.run_suite("EnvironmentFails"),
                         (1, ["EXITED outside of the tests (exit code 23)",
                              "a.S: 1 tests, 1 passed, 0 skipped, 0 failed"]))

    def test_fails_without_tests(self):
        run = subprocess.run(self.command(""), capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("lists no tests named S.*", run.stderr)

    def test_counts_no_earlier_results(self):
        self.run_suite("First CrashesA Last")
        self.run_suite("First")
        self.assertEqual(self.count(), (0, ["1 tests, 1 passed, 0 skipped, 0 failed"]))

    def test_counts_nothing_as_a_failure(self):
        (self.folder / "results").mkdir()
        self.assertEqual(self.count(), (1, ["0 tests, 0 passed, 0 skipped, 0 failed"]))

    def printed(self, run):
        """What the test "Fails" printed: its display and home."""
        return next(line for line in run[1] if line.startswith("printed by Fails")).split()[3:5]

    def test_gives_a_home_of_its_own(self):
        display, home = self.printed(self.run_suite("Fails"))
        self.assertEqual(display, str(os.environ.get("DISPLAY")))
        self.assertNotEqual(home, os.environ.get("HOME"))
        self.assertFalse(pathlib.Path(home).exists())

    def test_gives_a_display_of_its_own(self):
        command = self.command("Fails Hangs", "--display", "--limit", "2")
        both = [subprocess.Popen(command, stdout=subprocess.PIPE, text=True)]
        command[4] = self.folder / "results" / "b.S"
        both.append(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
        runs = [(0, run.communicate()[0].splitlines()) for run in both]
        displays = {self.printed(run)[0] for run in runs}
        self.assertEqual(len(displays), 2, runs)
        self.assertNotIn(os.environ.get("DISPLAY"), displays)

    def children(self, parent):
        """Returns {id: name} of what the runner has started."""
        run = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(parent.pid)], capture_output=True,
                             text=True)
        self.assertIsNone(parent.poll(), run.stdout)
        return dict(line.split()[:2] for line in run.stdout.splitlines())

    def test_program_and_display_end_with_a_runner_that_is_killed(self):
        for number in (signal.SIGTERM, signal.SIGKILL):
            runner = subprocess.Popen(self.command("First Hangs", "--display"))
            log = self.folder / "results" / "a.S.1.log"
            while not log.exists() or "S.Hangs" not in log.read_text():
                self.children(runner)
                time.sleep(0.05)
            started = self.children(runner)
            self.assertEqual(len(started), 2, started)
            runner.send_signal(number)
            runner.wait()
            log.unlink()
            until = time.monotonic() + 20
            while any(pathlib.Path("/proc", pid).exists() for pid in started):
                self.assertLess(time.monotonic(), until, started)
                time.sleep(0.05)


if __name__ == "__main__":
    unittest.main()
