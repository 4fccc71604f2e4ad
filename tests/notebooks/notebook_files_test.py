"""What is committed of the notebooks: the pictures that their cells drew, and no figures that no page shows."""

import json
import os
import re
import sys
import unittest
from pathlib import Path

SOURCE = Path(os.environ["INKBENCH_SOURCE"])
NOTEBOOKS = SOURCE / "notebooks"
MOST_BYTES = 250_000
sys.dont_write_bytecode = True
sys.path.insert(0, str(NOTEBOOKS))

import keep  # noqa: E402


class NotebookFiles(unittest.TestCase):
    def test_carry_the_pictures_that_their_cells_drew(self):
        paths = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertGreaterEqual(len(paths), 3)
        for path in paths:
            notebook = json.loads(path.read_text(encoding="utf-8"))
            self.assertEqual(keep.stale(notebook), [], f"{path.name}: notebooks/execute --keep draws them again")
            for cell in keep.code_cells(notebook):
                kinds = {kind for output in cell["outputs"] for kind in output.get("data", {})}
                self.assertLessEqual(kinds, {"image/png"}, path.name)
            self.assertIn("image/png", path.read_text(encoding="utf-8"), path.name)
            self.assertLess(path.stat().st_size, MOST_BYTES, path.name)

    def test_a_cell_that_changed_is_stale(self):
        cell = {"id": "a", "cell_type": "code", "metadata": {}, "source": ["x"], "outputs": []}
        notebook = {"cells": [cell]}
        self.assertEqual(keep.stale(notebook), ["a"])
        self.assertEqual(keep.stale(keep.kept(notebook)), [])
        cell["source"].append("y")
        self.assertEqual(keep.stale(notebook), ["a"])

    def test_figures_are_those_that_pages_show(self):
        pages = [p for p in SOURCE.rglob("*.md")
                 if not {"build", "inkbench-out", ".git"} & set(p.relative_to(SOURCE).parts)]
        shown = set()
        for page in pages:
            for link in re.findall(r"\]\(([^)\s]*notebooks/figures/[^)\s]+)\)",
                                   page.read_text(encoding="utf-8")):
                path = (page.parent / link).resolve()
                self.assertTrue(path.is_file(), f"{page} shows {link}, which is not there")
                shown.add(path.name)
        there = {p.name for p in (NOTEBOOKS / "figures").iterdir()}
        self.assertEqual(there - shown, set(), "no page shows them")

    def test_name_figures_that_there_are(self):
        source = (NOTEBOOKS / "paper" / "catalogue.py").read_text(encoding="utf-8")
        known = set(re.findall(r'^    "(\w+)": ', source, re.M))
        for path in NOTEBOOKS.glob("*.ipynb"):
            cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
            for text in ("".join(c["source"]) for c in cells if c["cell_type"] == "code"):
                for name in re.findall(r'figures\.show\("[^"]+", "(\w+)"', text):
                    self.assertIn(name, known, path.name)


if __name__ == "__main__":
    unittest.main()
