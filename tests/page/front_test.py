"""The pages that README shows open from their files alone."""

import unittest
from pathlib import Path

from access import faults
from browser import BrowserTest

PAGES = Path(__file__).resolve().parents[2] / "experiments/pages"


class FrontTest(BrowserTest):
    switches = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-watchdog")
    harmless = ("GPU stall due to ReadPixels",)

    @classmethod
    def make_runs(cls):
        pass

    def test_ask_for_nothing_else(self):
        for page in sorted(PAGES.rglob("*.html")):
            self.open(page)
            self.assertEqual(self.script("return performance.getEntriesByType('resource').map(r => r.name)"), [], page)
            self.assertEqual(faults(self.browser), [], page)


if __name__ == "__main__":
    unittest.main()
