"""A batch that was compiled in one checkout is found by the compiler cache in another one."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES CXX)
set(ASPERITY_BATCH 3 CACHE STRING "")
include(cmake/Targets.cmake)
add_subdirectory(core)
"""
LIBRARY = """asperity_library(asperity_base SOURCES One.cpp Two.cpp Alone.cpp Apart.cpp AlsoApart.cpp)
set_source_files_properties(Alone.cpp PROPERTIES COMPILE_DEFINITIONS ALONE)
set_source_files_properties(Apart.cpp AlsoApart.cpp PROPERTIES COMPILE_OPTIONS "-DAPART=1 + 1;-DBOTH")
"""


class Batches(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()

    def checkout(self, name):
        top = self.folder / name
        (top / "core").mkdir(parents=True)
        for copied in ("cmake/Targets.cmake", "cmake/Batches.cmake", "tools/cached_compiler.sh", "tools/sanitizer_ignorelist.txt"):
            (top / copied).parent.mkdir(exist_ok=True)
            shutil.copy(TOP / copied, top / copied)
        (top / "CMakeLists.txt").write_text(PROJECT)
        (top / "core/CMakeLists.txt").write_text(LIBRARY)
        (top / "core/Text.h").write_text("#pragma once\n#include <string>\nstd::string text();\n")
        (top / "core/One.cpp").write_text('#include "core/Text.h"\nstd::string text() { return "one"; }\n')
        (top / "core/Two.cpp").write_text('#include "core/Text.h"\nstd::string two() { return text(); }\n')
        for name in ("Apart", "AlsoApart"):
            (top / f"core/{name}.cpp").write_text(
                f"#if APART != 2 || !defined(BOTH)\n#error\n#endif\nint {name}() {{ return 1; }}\n")
        (top / "core/Alone.cpp").write_text("#ifndef ALONE\n#error\n#endif\nint alone() { return 1; }\n")
        return top

    def build(self, top, compiler):
        """Configures and builds a checkout. Returns how many sources were compiled and how many the cache had."""
        environment = dict(os.environ, CCACHE_DIR=str(self.folder / "cache"))
        def run(*command):
            return subprocess.run(command, check=True, env=environment, capture_output=True, text=True).stdout
        run("ccache", "--zero-stats")
        run("cmake", "-G", "Ninja", "-S", top, "-B", top / "build/x", f"-DCMAKE_CXX_COMPILER={compiler}")
        output = run("cmake", "--build", top / "build/x")
        stats = dict(line.split("\t") for line in run("ccache", "--print-stats").splitlines())
        hits = int(stats["direct_cache_hit"]) + int(stats["preprocessed_cache_hit"])
        return len(re.findall(r"Building CXX object .*(?:batches|Alone)", output)), hits

    def test_are_found_in_another_checkout(self):
        for compiler in ("g++", "clang++"):
            if not shutil.which(compiler):
                continue  # clang is a package of the gates
            with self.subTest(compiler=compiler):
                compiled, _ = self.build(self.checkout(f"{compiler}/one"), compiler)
                self.assertEqual(compiled, 3)  # two batches of two, and one with definitions of its own
                compiled, hits = self.build(self.checkout(f"{compiler}/two"), compiler)
                self.assertEqual(compiled, 3)
                self.assertGreaterEqual(hits, 3)

    def test_include_from_the_top_folder(self):
        top = self.checkout("one")
        self.build(top, "g++")
        texts = [file.read_text() for file in sorted((top / "build/x/batches").iterdir())]
        included = [re.findall(r'#include "(.*)"', text) for text in texts]
        self.assertEqual(included, [["core/One.cpp", "core/Two.cpp"], ["core/Apart.cpp", "core/AlsoApart.cpp"]])
        self.assertNotIn(str(top), "".join(texts))

    def test_hold_a_source_of_two_targets_in_both(self):
        top = self.checkout("one")
        with (top / "core/CMakeLists.txt").open("a") as file:
            file.write("asperity_library(asperity_again SOURCES Two.cpp)\n")
        self.build(top, "g++")
        for library in ("base", "again"):
            symbols = subprocess.run(["nm", "-C", top / f"build/x/core/libasperity_{library}.a"], check=True,
                                     capture_output=True, text=True).stdout
            self.assertIn("T two[abi:cxx11]()", symbols)

    def test_refuse_what_would_not_reach_a_source(self):
        top = self.checkout("one")
        with (top / "core/CMakeLists.txt").open("a") as file:
            file.write("set_source_files_properties(Two.cpp PROPERTIES COMPILE_FLAGS -O3)\n")
        with self.assertRaises(subprocess.CalledProcessError) as refused:
            self.build(top, "g++")
        self.assertRegex(refused.exception.stderr, "core/Two.cpp:\\s+COMPILE_FLAGS does not reach")


if __name__ == "__main__":
    unittest.main()
