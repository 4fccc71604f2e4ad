"""The numbers of pages are those of the runs that are kept; experiments/kept.py holds them, and is held here."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = "method,f_2px,f_lo,f_hi,cube\nmote4,0.90149,0.8,0.95,0.5\nsurface8,0.98913,0.9512,,1.0\n"
LEADS = "pair,difference,lo\nsurface8-mote4,0.08764,-0.01\n"
PAGE = """F is 0.901<!-- = run mote4 f_2px -->, +0.088<!-- = run surface8-mote4 difference --> less.

<!-- numbers: - key run.f_2px:2 run.f_lo..f_hi - run.cube:1 -->
| you have | use | F | 95 % | as | on the cube |
|---|---|--:|--:|---|--:|
| a mesh | `surface8`, a byte | 0.99 | 0.951-- | 7 | 1.0 (cube) |
"""


def run(*words):
    return subprocess.run([sys.executable, "-B", ROOT / "experiments/kept.py", *words], capture_output=True, text=True)


class Numbers(unittest.TestCase):
    def setUp(self):
        desk = tempfile.TemporaryDirectory()
        self.addCleanup(desk.cleanup)
        self.folder = Path(desk.name)
        (self.folder / "run.csv").write_text(KEPT)
        (self.folder / "run.differences.csv").write_text(LEADS)
        self.page = self.folder / "page.md"

    def of(self, text, *words):
        self.page.write_text(text)
        return run(self.page, "--kept", self.folder, *words)

    def test_of_every_page_are_those_of_its_runs(self):
        done = run()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_that_are_right_stay(self):
        self.assertEqual(self.of(PAGE).returncode, 0)

    def test_that_are_wrong_are_found_and_made_right(self):
        for right, wrong in (("0.901", "0.902"), ("+0.088", "-0.088"), ("0.951--", "0.951-0.99"),
                             ("| 0.99 |", "| 1.0 |"), ("1.0 (", "0.9 (")):
            done = self.of(PAGE.replace(right, wrong))
            self.assertEqual(done.returncode, 1, wrong)
            self.assertIn("page.md:", done.stdout)
            self.of(PAGE.replace(right, wrong), "--write")
            self.assertNotIn(wrong, self.page.read_text())

    def test_without_a_source_are_refused(self):
        for right, wrong, said in (("mote4 f_2px", "mote5 f_2px", "no 'mote5'"), ("run mote4", "ran mote4", "'ran'"),
                                   ("mote4 f_2px", "mote4 f_3px", "no 'f_3px'"), ("- key", "- -", "one of them key"),
                                   ("= run mote4", "= run", "a mark"), ("-->\n| you", "-->\n\n| you", "a mark")):
            done = self.of(PAGE.replace(right, wrong))
            self.assertEqual(done.returncode, 2, wrong)
            self.assertIn(said, done.stderr)

    def test_of_the_first_pages_all_have_a_source(self):
        """A score of three digits is of a kept run, or in a table with the command that prints it."""
        for page in ("README.md", "experiments/findings.md"):
            text = (ROOT / page).read_text(encoding="utf-8")
            text = re.sub(r"[+-]?[\d.]+<!-- = .*?-->|<!-- (numbers|made by): .*?-->\n(\|.*\n)+", "", text)
            self.assertEqual(re.findall(r".*\b0\.\d{3}\b(?! %).*", text), [], page)

    def test_of_methods_is_that_of_the_registry(self):
        count = sum(file.stem == file.parent.name for file in ROOT.glob("methods/*/*.toml"))
        self.assertIn(f"compares {count} ways", (ROOT / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
