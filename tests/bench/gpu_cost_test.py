"""bench/gpu_cost: no pass has grown, one that grows is named, and methods/README.md has its table."""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "bench" / "gpu_counts.csv"


def gpu_cost(*words):
    return subprocess.run([ROOT / "bench" / "gpu_cost", *words], capture_output=True, text=True, check=False)


class GpuCostTest(unittest.TestCase):
    def test_no_pass_has_grown_and_the_page_has_the_table(self):
        done = gpu_cost("--check")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"<!-- gpu -->\n{done.stdout}<!-- /gpu -->", (ROOT / "methods" / "README.md").read_text())

    def test_what_grows_by_a_tenth_is_named(self):
        with KEPT.open() as file:
            rows = list(csv.DictReader(file))
        lines = next(row for row in rows if row["method"] == "surface8_depth" and row["pass"] == "lines")
        lines["instructions"] = int(int(lines["instructions"]) / 1.11)
        rows.remove(next(row for row in rows if row["method"] == "ids"))
        with tempfile.TemporaryDirectory() as folder:
            smaller = Path(folder) / "smaller.csv"
            with smaller.open("w") as file:
                writer = csv.DictWriter(file, rows[0])
                writer.writeheader()
                writer.writerows(rows)
            done = gpu_cost("--check", "--kept", smaller)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"^surface8_depth lines fragment RDNA2: \d+ instructions, \d+ in smaller.csv\n"
                                      r"ids mesh vertex RDNA2: not in smaller.csv\n$")


if __name__ == "__main__":
    probe = gpu_cost("--check")
    if probe.returncode == 77:
        print(f"Skipped: {probe.stderr.strip()}")
        sys.exit(77)
    unittest.main(verbosity=2)
