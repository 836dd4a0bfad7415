#!/usr/bin/env python3
"""Compiles, each by itself, the sources and headers that changed in the last 20 commits or are not
committed, and a source that includes each such header. `release` and the gates compile sources in batches,
where an include that is missing is not missed. What changed in comments alone is left out. Of more than 150
sources, as after a move, every so many are compiled: the gate has no time for more; MOST = 0 compiles all.
Usage: [MOST=150] compile_alone.py BUILD [COMMITS]    BUILD: the folder of the preset dev, configured"""

import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[1]
INCLUDES = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
HEADERS = {".h", ".hpp"}
COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
MOST = int(os.environ.get("MOST", 150))


def git(*arguments, check=True):
    return subprocess.run(["git", "-C", TOP, *arguments], check=check, capture_output=True, text=True).stdout


def code_of(text):
    """A source without its comments and spaces."""
    return re.sub(r"\s+", "", COMMENT.sub(lambda m: m[0] if m[0][0] == '"' else "", text))


def changed_files(commits):
    """Paths of sources whose code the last commits and the working tree changed, in the checkout."""
    named = (git("log", "--cc", f"--max-count={commits}", "--name-only", "--pretty=format:")
             + git("diff", "--name-only", "HEAD") + git("ls-files", "--others", "--exclude-standard"))
    before = git("rev-list", f"--max-count={commits}", "HEAD").split()[-1] + "^"

    def is_other(name):
        return code_of((TOP / name).read_text(errors="replace")) != code_of(
            git("show", f"{before}:{name}", check=False))

    return sorted({name for name in named.split("\n")
                   if re.search(r"\.(h|hpp|cpp|cxx)$", name) and (TOP / name).is_file() and is_other(name)})


def commands_of(build):
    """The compiler's arguments for each source of the build, without what to compile and to write."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"]).resolve()
        if not source.is_relative_to(TOP) or source.is_relative_to(build):
            continue
        arguments = shlex.split(entry["command"])
        output = arguments.index("-o")
        del arguments[output:output + 2]
        arguments = [a for a in arguments if a not in ("-c", "-g", "-O1", entry["file"])]
        commands.setdefault(str(source.relative_to(TOP)), arguments)
    return commands


class Users:
    """Which sources include a header, themselves or through other headers."""

    def __init__(self, sources):
        self.sources = set(sources)
        self.includers = collections.defaultdict(list)
        for folder in ("app", "bench", "core", "hardware", "tests", "tools", "ui", "vtkplugins"):
            for file in sorted((TOP / folder).rglob("*")):
                if file.suffix in HEADERS | {".cpp", ".cxx"}:
                    for included in INCLUDES.findall(file.read_text()):
                        self.includers[included].append(str(file.relative_to(TOP)))

    def of(self, header, compiled):
        """The nearest source that includes the header, another than its own where there is one, and one that is
        compiled anyway where there is one; or None."""
        if known := [file for file in self.includers[header] if file in compiled
                     and pathlib.Path(file).stem != pathlib.Path(header).stem]:
            return known[0]
        seen, waiting, own = {header}, collections.deque([header]), None
        while waiting:
            for includer in self.includers[waiting.popleft()]:
                if includer in self.sources:
                    if pathlib.Path(includer).stem != pathlib.Path(header).stem:
                        return includer
                    own = own or includer
                elif includer not in seen:
                    seen.add(includer)
                    waiting.append(includer)
        return own


def is_first_in_its_source(header, sources):
    """Whether a header's own source is among these and begins with it: then that compiles it alone, too."""
    own = pathlib.Path(header).with_suffix(".cpp").as_posix()
    return own in sources and INCLUDES.findall((TOP / own).read_text())[:1] == [header]


def works_for(files, commands, users, folder):
    """(name, source, arguments) of each compilation; a header is compiled by its own source or by one with it
    alone."""
    sources, works = {file for file in files if file in commands}, []
    for file in files:
        if pathlib.Path(file).suffix in HEADERS and (user := users.of(file, sources)):
            sources.add(user)
            if is_first_in_its_source(file, sources):
                continue
            alone = folder / (file.replace("/", "_") + ".cpp")
            if not alone.exists():
                alone.write_text(f'#include "{file}"\n')
            works.append((file, str(alone), commands[user]))
    return works + [(source, str(TOP / source), commands[source]) for source in sorted(sources)]


def main(build, commits):
    build = build.resolve()
    folder = build / "alone"
    folder.mkdir(exist_ok=True)
    commands = commands_of(build)
    works = works_for(changed_files(commits), commands, Users(commands), folder)

    if MOST and len(works) > MOST:
        print(f"of {len(works)} sources and headers {MOST} at most are compiled")
        works = works[::-(-len(works) // MOST)]

    def compile_one(work):
        name, source, arguments = work
        return name, subprocess.run([*arguments, "-fsyntax-only", source], cwd=build, capture_output=True, text=True)

    failed = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, result in pool.map(compile_one, works):
            if result.returncode != 0:
                failed.append(name)
                print(f"{name} does not compile by itself:\n{result.stderr}", flush=True)
    print(f"{len(works) - len(failed)} of {len(works)} sources and headers compile by themselves")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 20))
