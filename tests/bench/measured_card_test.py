"""experiments/cards/measure: the card that it writes without a reader is one that the table is made of."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

MEASURE = Path(__file__).resolve().parents[2] / "experiments" / "cards" / "measure"


class MeasuredCardTest(unittest.TestCase):
    def test_it_has_every_method(self):
        with tempfile.TemporaryDirectory() as folder:
            card = Path(folder) / "card.json"
            done = subprocess.run([MEASURE, card, "cube", "--size", "64x36", "--software"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, r"(?m)^\| model \| cube, 64x36 \|$")
            for method in ("chords", "surface_lookup", "inverted_hull"):
                self.assertRegex(done.stdout, rf"(?m)^\| `{method}` \| [\d.]+ ")

    def test_a_scene_that_is_none_is_said(self):
        done = subprocess.run([MEASURE, "card.json", "no_such_scene"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no_such_scene", done.stderr)


if __name__ == "__main__":
    if not shutil.which("chromedriver"):
        print("Skipped: chromium-driver is not installed (./bootstrap install browser installs it).")
        sys.exit(77)
    unittest.main(verbosity=2)
