"""experiments/cards: its page has the table that the script makes, and the program reads every card."""

import os
import subprocess
import unittest
from pathlib import Path

CARDS = Path(__file__).resolve().parents[2] / "experiments" / "cards"
PROGRAM = os.environ.get("INKBENCH", "build/release/inkbench")


def said(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


class CardsTest(unittest.TestCase):
    def test_the_page_has_the_table(self):
        self.assertIn(f"<!-- cards -->\n{said(CARDS / 'tabulate')}<!-- /cards -->", (CARDS / "README.md").read_text())

    def test_the_program_reads_every_card(self):
        cards = list(CARDS.glob("*.json"))
        self.assertGreater(len(cards), 0)
        for card in cards:
            self.assertRegex(said(PROGRAM, "page", "--card", card), r"(?m)^surface8 +[\d.]+ +[\d.]+ ", card.name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
