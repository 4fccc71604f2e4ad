"""What README shows first is of today's program: `experiments/front` makes it again."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "experiments/pages"
MOST_BYTES = 4_000_000
MOST_PICTURE_BYTES = 300_000
HELD = re.compile(r'(<script type="application/json" id="(\w+)">)(.*?)(</script>)', re.S)


def program(*words):
    done = subprocess.run([os.environ["INKBENCH"], *map(str, words)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def code(page):
    """A page without what is of its run or model: style, scripts, shaders, structure."""
    page = re.sub(r'<script type="text/plain" class="mesh">.*?</script>\n', "", HELD.sub(r"\1\4", page), flags=re.S)
    return re.sub(r"<title>.*?</title>", "", page)


def data(page):
    return json.loads(next(found[3] for found in HELD.finditer(page) if found[2] == "data"))


class Front(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        desk = tempfile.TemporaryDirectory()
        cls.addClassCleanup(desk.cleanup)
        run = Path(desk.name) / "run"
        program("compare", "cube", "--demo", "--methods", "surface8", "--size", "64x36", "--out", run, "--quiet")
        program("page", "cube", "--run", run)
        program("report", run)
        cls.today = {name: (run / path).read_text() for name, path in
                     {"report.html": "report.html", "live": "live/cube.html"}.items()}
        cls.shipped = {path.name if path.parent == PAGES else "live": path.read_text()
                       for path in PAGES.rglob("*.html")}

    def test_pages_are_those_that_the_program_writes(self):
        self.assertEqual(self.shipped.keys(), self.today.keys())
        for name, page in self.today.items():
            self.assertTrue(code(self.shipped[name]) == code(page), f"{name} is old: experiments/front pages")
            here, there = data(self.shipped[name]), data(page)
            self.assertEqual(here["version"], there["version"], f"{name} is old: experiments/front pages")
            self.assertEqual(here.keys(), there.keys(), name)
            for one, other in zip(here.get("runs", []), there.get("runs", []), strict=True):
                self.assertEqual(one.keys(), other.keys(), name)

    def test_the_page_of_the_run_leads_to_the_one_that_draws(self):
        live = data(self.shipped["report.html"])["runs"][0]["live"].values()
        self.assertEqual({str(page.relative_to(PAGES)) for page in PAGES.glob("live/*")}, set(live))

    def test_commands_are_those_of_a_checkout(self):
        for command in data(self.shipped["report.html"])["runs"][0]["words"]["home"]["commands"]:
            self.assertNotRegex(str(command), r"[' ]/")

    def test_pages_and_picture_are_light(self):
        self.assertLess(sum(map(len, self.shipped.values())), MOST_BYTES)
        self.assertLess((ROOT / "experiments/front.png").stat().st_size, MOST_PICTURE_BYTES)


if __name__ == "__main__":
    unittest.main()
