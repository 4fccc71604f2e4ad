"""methods/outside/table, on a small run with an entrant that draws one wrong stroke."""

import sys
import unittest
from pathlib import Path

import adapters

STROKE = """#!/usr/bin/python3
import json, sys, numpy
from PIL import Image
view = json.load(open(sys.argv[1]))
image = numpy.zeros((view["height_px"], view["width_px"]), "uint8")
image[20, 20:60] = 255
Image.fromarray(image).save(sys.argv[2])
print("draw_ms 2.5")
"""


class TableTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.desk = adapters.scratch()
        cls.folder = Path(cls.desk.name)
        program = cls.folder / "stroke"
        program.write_text(STROKE)
        program.chmod(0o755)
        cls.run_folder = cls.folder / "run"
        done = adapters.run(adapters.PROGRAM, "compare", "--scenes", "cube", "--methods", "ids",
                            "--size", "320x180", "--views", "1", "--entrant", f"stroke={program}",
                            "--no-sweep", "--no-crosscheck", "--out", cls.run_folder)
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.desk.cleanup()

    def table(self):
        done = adapters.run(sys.executable, adapters.OUTSIDE / "table", self.run_folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def cells_of(self, method):
        line, = [line for line in self.table().splitlines() if line.startswith(f"| `{method}`")]
        return [cell.strip() for cell in line.strip("|").split("|")]

    def test_it_has_scores_and_the_entrants_own_clock(self):
        self.assertGreater(float(self.cells_of("ids")[1]), 0.9)
        cells = self.cells_of("stroke")
        self.assertEqual(float(cells[1]), 0)
        self.assertEqual(cells[-1], "2.50 own")

    def test_it_lists_what_is_missing_and_what_is_false(self):
        self.assertIn("- misses more than 2 % in 1: cube 100", self.table())
        self.assertRegex(self.table(), r"- adds more than 2 % in 1: cube [0-9]+")

    def test_what_is_no_run_is_bad_input(self):
        done = adapters.run(sys.executable, adapters.OUTSIDE / "table", self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("accepted:", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
