"""Runs tools that read the whole tree on a small one in a temporary folder."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"


class PlantedTree(unittest.TestCase):
    """Its tests name the tool and the files in which it finds nothing: {name: text}."""

    tool = None
    kept = {}

    def run_with(self, planted):
        """The tool's finished run on the kept files and these."""
        with tempfile.TemporaryDirectory() as tree:
            for name, text in (self.kept | planted).items():
                file = pathlib.Path(tree, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            run = subprocess.run([sys.executable, TOOLS / self.tool, tree],
                                 capture_output=True, text=True)
        self.assertEqual(run.stderr, "")
        return run

    def refuses(self, planted):
        """Each planted file has its fault: {name: (text, fault)}."""
        run = self.run_with({name: text for name, (text, _) in planted.items()})
        self.assertEqual(run.returncode, 1)
        for name, (text, fault) in planted.items():
            with self.subTest(name=name, text=text):
                self.assertTrue(any(line.startswith(f"{name}:") and fault in line
                                    for line in run.stdout.splitlines()), run.stdout)
