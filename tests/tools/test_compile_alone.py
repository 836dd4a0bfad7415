"""tools/compile_alone.py finds an include that a batch would hide."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"

LENGTH = "#pragma once\n#include <string>\nnamespace length { inline std::string text() { return {}; } }\n"
WIDTH = "#pragma once\n#include <string>\nnamespace width { inline std::string text() { return {}; } }\n"
USER = '#include "core/Length.h"\n#include "core/Width.h"\nint user() { return 0; }\n'


class CompileAlone(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = pathlib.Path(folder.name).resolve()
        self.write("core/Length.h", LENGTH)
        self.write("core/Width.h", WIDTH)
        self.write("core/User.cpp", USER)
        self.write("core/Other.cpp", "int other() { return 0; }\n")
        (self.top / "tools").mkdir()
        for tool in ("compile_alone.py", "cached_compiler.sh", "sanitizer_ignorelist.txt"):
            shutil.copy(TOOLS / tool, self.top / "tools")
        self.write(".gitignore", "build\n")
        self.git("init", "-q")
        self.commit()
        self.write("build/compile_commands.json", json.dumps(
            [{"directory": str(self.top / "build"), "file": str(self.top / source),
              "command": f"c++ -I{self.top} -O1 -g -std=c++20 -o {source}.o -c {self.top / source}"}
             for source in ("core/User.cpp", "core/Other.cpp", "core/Length.cpp")]))

    def write(self, name, text):
        file = self.top / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def git(self, *arguments):
        subprocess.run(["git", "-C", self.top, "-c", "user.name=A", "-c", "user.email=a@example.org",
                        *arguments], check=True, capture_output=True)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "-q", "-m", "some: change")

    def run_alone(self, commits=1):
        return subprocess.run([self.top / "tools/compile_alone.py", self.top / "build", str(commits)],
                              capture_output=True, text=True, check=False)

    def test_compiles_what_changed_and_a_user_of_each_header(self):
        self.write("core/Width.h", WIDTH + "int more();\n")
        result = self.run_alone()
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("4 of 4", result.stdout)  # the whole history, as it is short

    def test_compiles_a_header_by_its_own_source_that_begins_with_it(self):
        self.write("core/Length.cpp", '#include "core/Length.h"\n')
        self.commit()
        self.assertIn("4 of 4", self.run_alone(2).stdout)  # the three sources, and Width.h
        self.write("core/Length.cpp", '#include <string>\n#include "core/Width.h"\n#include "core/Length.h"\n')
        self.write("core/Length.h", LENGTH.replace("#include <string>\n", ""))
        self.commit()
        self.assertIn("core/Length.h does not compile by itself", self.run_alone().stdout)

    def test_leaves_out_what_is_older(self):
        for text in ("int one();\n", "int two();\n"):
            self.write("core/Other.cpp", f"int other() {{ return 0; }}\n{text}")
            self.commit()
        self.assertIn("1 of 1", self.run_alone().stdout)

    def test_leaves_out_what_changed_in_comments_alone(self):
        self.write("core/Other.cpp", "int other() { return 0; }\nconst char* url() { return \"a//b\"; }\n")
        self.commit()
        self.write("core/Other.cpp", "/* Of\n   two lines. */ int other() { return 0; }  // zero\n"
                                     "const char* url() { return \"a//b\"; }\n")
        self.commit()
        self.assertIn("0 of 0", self.run_alone().stdout)
        self.write("core/Other.cpp", "int other() { return 0; }\nconst char* url() { return \"a//c\"; }\n")
        self.assertIn("1 of 1", self.run_alone().stdout)

    def test_names_a_header_that_misses_an_include(self):
        self.write("core/Width.h", WIDTH.replace("#include <string>\n", ""))
        result = self.run_alone()
        self.assertEqual(result.returncode, 1)
        self.assertIn("core/Width.h does not compile by itself", result.stdout)
        self.assertNotIn("core/User.cpp does not", result.stdout)

    def test_names_a_source_that_misses_an_include(self):
        self.write("core/Other.cpp", "std::string other();\n")
        self.commit()
        result = self.run_alone()
        self.assertEqual(result.returncode, 1)
        self.assertIn("core/Other.cpp does not compile by itself", result.stdout)

    def test_names_the_user_of_a_header_that_lost_an_include(self):
        self.write("core/User.cpp", '#include "core/Length.h"\nstd::string user() { return length::text(); }\n')
        self.write("core/Length.h", "#pragma once\nnamespace length { inline const char* text() { return 0; } }\n")
        result = self.run_alone()
        self.assertEqual(result.returncode, 1)
        self.assertIn("core/User.cpp does not compile by itself", result.stdout)


if __name__ == "__main__":
    unittest.main()
