"""tools/listed_path.py links the programs of listed packages and of no other."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from planted_tree import TOOLS

sys.path.append(str(TOOLS))
import listed_path


class ListedPath(unittest.TestCase):
    """Of a machine on which the packages of tools/packages.txt are installed."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name).resolve() / "programs"
        self.list = pathlib.Path(scratch.name) / "list.txt"

    def make(self, *lists):
        return subprocess.run([TOOLS / "listed_path.py", self.folder, *lists],
                              capture_output=True, text=True)

    def listing(self, text):
        self.list.write_text(text)
        return self.make(self.list)

    def exit_code(self, command):
        """Of a shell that finds the programs of the folder alone."""
        return subprocess.run(["/bin/sh", "-c", command], env={"PATH": str(self.folder)},
                              capture_output=True).returncode

    def test_holds_what_is_listed(self):
        made = self.make(TOOLS / "packages.txt")
        self.assertEqual((made.stdout, made.stderr), (f"{self.folder}\n", ""))
        self.assertGreaterEqual({link.name for link in self.folder.iterdir()},
                                {"g++", "cmake", "ctest", "ffmpeg", "ffprobe", "mpirun", "python3",
                                 "pdftotext", "xvfb-run"})

    def test_holds_what_every_machine_has(self):
        self.listing("")
        self.assertGreaterEqual({link.name for link in self.folder.iterdir()},
                                {"awk", "bash", "cat", "env", "sh", "timeout"})

    def test_holds_what_a_listed_package_needs(self):
        self.listing("g++\n")
        self.assertEqual(self.exit_code("c++ --version && ld --version"), 0)

    def test_a_program_may_be_in_both_folders(self):
        self.listing("iproute2\n")  # /bin/ip and /sbin/ip
        self.assertEqual(self.exit_code("ip -Version"), 0)

    def test_a_program_of_no_list_is_not_found(self):
        self.listing("# a comment\npython3\n")
        self.assertEqual(self.exit_code("python3 -c pass"), 0)
        for program in ("c++", "cmake", "ffmpeg", "mpirun"):
            with self.subTest(program):
                self.assertEqual(self.exit_code(f"{program} --version"), 127)

    def test_forgets_an_earlier_list(self):
        self.listing("ffmpeg\n")
        self.listing("python3\n")
        self.assertFalse((self.folder / "ffmpeg").exists())

    def test_refuses_a_package_that_is_not_installed(self):
        made = self.listing("python3\nno-such-package\n")
        self.assertEqual(made.stdout, "")
        self.assertEqual(made.stderr,
                         "not installed: no-such-package (tools/install_packages.sh)\n")
        self.assertEqual(made.returncode, 1)


class Closure(unittest.TestCase):
    def closure(self, root, **packages):
        """From what each package needs and, after a slash, provides."""
        parts = {name: text.partition("/") for name, text in packages.items()}
        return listed_path.closure(
            {name: {"needs": listed_path.names(needs), "provides": provides.split()}
             for name, (needs, _, provides) in parts.items()}, [root])

    def test_follows_what_is_needed_once(self):
        self.assertEqual(self.closure("a", a="b (>= 1.2), c:any", b="a", c="d", d="", e=""),
                         {"a", "b", "c", "d"})

    def test_takes_the_first_alternative_that_is_installed(self):
        self.assertEqual(self.closure("a", a="b | c", b="", c=""), {"a", "b"})
        self.assertEqual(self.closure("a", a="b | c | d", c="", d=""), {"a", "c"})

    def test_takes_what_provides_a_virtual_package(self):
        self.assertEqual(self.closure("a", a="awk | b", b="", mawk="/awk"), {"a", "mawk"})
        self.assertEqual(self.closure("a", a="awk", awk="", mawk="/awk"), {"a", "awk"})

    def test_goes_on_past_what_is_not_installed(self):
        self.assertEqual(self.closure("a", a="b, c", c=""), {"a", "c"})


if __name__ == "__main__":
    unittest.main()
