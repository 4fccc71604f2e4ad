"""What is committed of the notebooks: no outputs, and no figures that no page shows."""

import json
import os
import re
import unittest
from pathlib import Path

SOURCE = Path(os.environ["INKBENCH_SOURCE"])
NOTEBOOKS = SOURCE / "notebooks"


class NotebookFiles(unittest.TestCase):
    def test_carry_no_outputs(self):
        paths = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertGreaterEqual(len(paths), 3)
        for path in paths:
            for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
                if cell["cell_type"] == "code":
                    self.assertEqual(cell["outputs"], [], f"{path.name}; notebooks/execute writes "
                                     "executed notebooks elsewhere")
                    self.assertIsNone(cell["execution_count"], path.name)

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
