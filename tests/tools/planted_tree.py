"""Runs tools that read the whole tree on a small one in a temporary folder."""

import pathlib
import subprocess
import sys
import tempfile

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"


def outcome(tool, files):
    """The finished run of a tool on a tree of these files: {name: text}."""
    with tempfile.TemporaryDirectory() as tree:
        for name, text in files.items():
            file = pathlib.Path(tree, name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        return subprocess.run([sys.executable, TOOLS / tool, tree], capture_output=True, text=True)
