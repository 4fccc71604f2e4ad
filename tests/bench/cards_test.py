"""experiments/cards: its page has the table that the script makes."""

import csv
import json
import subprocess
import tempfile
import unittest
from collections import Counter
from pathlib import Path

CARDS = Path(__file__).resolve().parents[2] / "experiments" / "cards"


def said(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


class CardsTest(unittest.TestCase):
    def test_the_page_has_the_table(self):
        self.assertIn(f"<!-- cards -->\n{said(CARDS / 'tabulate')}<!-- /cards -->", (CARDS / "README.md").read_text())

    def test_a_time_is_held_against_the_count(self):
        with (CARDS.parents[1] / "bench" / "gpu_counts.csv").open() as file:
            counts = Counter()
            for row in csv.DictReader(file):
                if row["family"] == "RDNA2" and row["pass"] != "mesh":
                    counts[row["method"]] += int(row["instructions"])
        card = json.loads((CARDS / "software.json").read_text())

        def last_rows(ns_of):
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "made_up.json"
                card["methods"] = [times | {"lines_ns": ns_of(times["method"])} for times in card["methods"]]
                file.write_text(json.dumps(card))
                return [line.split(" | ")[-1].strip(" |") for line in said(CARDS / "tabulate", file).splitlines()[-2:]]

        self.assertEqual(last_rows(lambda method: 50 * counts[method]), ["1.00", "0 %"])
        self.assertEqual(last_rows(lambda method: 1e9 / counts[method])[0], "-1.00")


if __name__ == "__main__":
    unittest.main(verbosity=2)
