#!/usr/bin/env python3
"""Counts the test functions in the XML results of GoogleTest programs; names those skipped or failed.
Usage: gtest_results.py FOLDER ..."""

import dataclasses
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

BEGIN = re.compile(r"\[ RUN +\] ([\w/.]+)$")
# A test may print something just before on the same line; the summary at the end has no time.
END = re.compile(r"\[ +(OK|SKIPPED|FAILED) +\] ([\w/.]+)(?:, where .*)? \(\d+ ms\)$")
OUTCOMES = {"OK": "passed", "SKIPPED": "skipped", "FAILED": "failed"}


@dataclasses.dataclass
class Result:
    """The outcome of a test function: passed, skipped or failed, and why."""

    outcome: str
    message: str = ""


def listed_tests(listing):
    """Returns the full names of the tests in the output of --gtest_list_tests."""
    tests = []
    suite = None
    for line in listing.splitlines():
        name = line.split("#")[0].rstrip()
        if not line.startswith(" "):
            suite = name if name.endswith(".") else None
        elif suite and "DISABLED_" not in suite + name:
            tests.append(suite + name.strip())
    return tests


class Output:
    """What a GoogleTest program printed, by test: complete or up to its crash."""

    def __init__(self, text):
        self.outcomes = {}  # test -> outcome, in the order of their ends
        self.sections = {}  # test -> its lines
        self.outside = []  # lines of no test
        self.running = None  # the test that has begun and not ended
        for line in text.splitlines():
            self._read(line)

    def _read(self, line):
        begin, end = BEGIN.search(line), END.search(line)
        if begin:
            self.running = begin[1]
        lines = self.sections.setdefault(self.running, []) if self.running else self.outside
        lines.append(line)
        if end and end[2] == self.running:
            self.outcomes[self.running] = OUTCOMES[end[1]]
            self.running = None


def read_xml(path):
    """Returns {test: Result} of the tests that ran; None where there is no complete XML file."""
    try:
        text = path.read_bytes().decode("utf-8", "replace")
        root = ElementTree.fromstring(text)
    except (OSError, ElementTree.ParseError):
        return None
    results = {}
    for case in root.iter("testcase"):
        # Failures outside of the tests are in a case without a name.
        if case.get("status") != "run" or not case.get("name"):
            continue
        result = Result("passed")
        for tag, outcome in (("skipped", "skipped"), ("failure", "failed")):
            for told in case.iter(tag):
                result = Result(outcome, told.get("message", ""))
        results[f"{case.get('classname')}.{case.get('name')}"] = result
    return results


def write_xml(path, results):
    """Writes {test: Result} as GoogleTest does."""
    root = ElementTree.Element("testsuites")
    for test, result in results.items():
        suite, _, name = test.partition(".")
        case = ElementTree.SubElement(root, "testcase", classname=suite, name=name, status="run")
        tag = {"skipped": "skipped", "failed": "failure"}.get(result.outcome)
        if tag:
            ElementTree.SubElement(case, tag, message=result.message)
    ElementTree.ElementTree(root).write(path, encoding="UTF-8", xml_declaration=True)


def summary(results):
    """Returns the count of each outcome, in words."""
    outcomes = [result.outcome for result in results]
    return f"{len(outcomes)} tests, " + ", ".join(
        f"{outcomes.count(outcome)} {outcome}" for outcome in OUTCOMES.values())


def skip_line(test, result):
    """Returns one line about a skipped test, without the place in its source."""
    reason = " ".join(line for line in result.message.splitlines()
                      if not re.search(r":\d+(: Skipped)?$", line))
    return f"SKIPPED {test}: {reason}"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    files = [file for folder in sys.argv[1:] for file in sorted(pathlib.Path(folder).glob("*.xml"))]
    results = [(test, result) for file in files for test, result in (read_xml(file) or {}).items()]
    for test, result in results:
        if result.outcome == "skipped":
            print(skip_line(test, result))
    for test, result in results:
        if result.outcome == "failed":
            print(f"FAILED {test}")
    print(summary([result for _, result in results]))
    return 0 if results and all(result.outcome != "failed" for _, result in results) else 1


if __name__ == "__main__":
    sys.exit(main())
