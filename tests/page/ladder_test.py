"""The live page's times: what its ladder makes of a made-up timer, sound, coarse or disturbed; and the card of them,
copied, saved and made a table of."""

import json
import subprocess
import sys
import unittest
from pathlib import Path

from browser import BrowserTest, inkbench

TABULATE = Path(__file__).resolve().parents[2] / "experiments" / "cards" / "tabulate"

# A timer of a GPU that takes 200 us for a mesh and 10 us for what is drawn over the screen, and 50 us for a query; or,
# without queries, the clock of the page. No time of this test is the machine's.
MADE_UP = """
const {gl} = renderer;
const get = gl.getExtension.bind(gl), ask = gl.getParameter.bind(gl);
const timer = {ns: 0, step_ns: arguments[0], isDisjoint: arguments[1], isForQueries: arguments[2]};
const read = () => Math.floor(timer.ns / timer.step_ns) * timer.step_ns;
Object.defineProperty(renderer, 'name', {value: 'Made-up GPU 1'});
gl.drawElements = () => { timer.ns += 200e3; };
gl.drawArrays = (kind, first, count) => { timer.ns += kind === gl.TRIANGLES && count > 3 ? 200e3 : 10e3; };
gl.getExtension = name => (name !== 'EXT_disjoint_timer_query_webgl2' ? get(name)
    : timer.isForQueries ? {TIME_ELAPSED_EXT: 1, QUERY_COUNTER_BITS_EXT: 2, GPU_DISJOINT_EXT: 3} : null);
if (!timer.isForQueries) performance.now = () => read() / 1e6;
gl.getParameter = what => (what === 3 ? timer.isDisjoint : ask(what));
gl.getQuery = () => 64;
gl.createQuery = () => ({});
gl.beginQuery = () => { timer.ns = 50e3; };
gl.endQuery = () => { timer.read_ns = read(); };
gl.getQueryParameter = (query, what) => (what === gl.QUERY_RESULT ? timer.read_ns : true);
gl.deleteQuery = () => {};
"""


class LadderTest(BrowserTest):
    switches = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-watchdog")
    harmless = ("GPU stall due to ReadPixels",)

    @classmethod
    def make_runs(cls):
        cls.page = cls.folder / "cube.html"
        inkbench("page", "cube", "--size", "64x36", "--views", "iso", "-o", cls.page)

    def open_made_up(self, step_ns=1, is_disjoint=False, is_for_queries=True):
        self.open(self.page)
        self.script("window.copied = []; Object.defineProperty(navigator, 'clipboard', {configurable: true, "
                    "value: {writeText: async text => { copied.push(text); }}})")
        self.script(MADE_UP, step_ns, is_disjoint, is_for_queries)

    def measure(self):
        self.press("Measure")
        self.wait(lambda: "Drawn by" in self.find("#times").text)
        return self.find("#times").text

    def press(self, name):
        self.script("[...document.querySelectorAll('#methods button')].find(b => b.textContent === arguments[0]).click()", name)

    def time(self, method):
        return self.browser.execute_async_script(
            "const done = arguments[1]; inkbench.time({method: arguments[0], width: 64, height: 36, view: 'iso'}).then(done)", method)

    def test_a_pass_of_ten_microseconds_is_found(self):
        self.open_made_up()
        for method, passes, mesh_ns in (("surface8", 1, 200e3), ("surface_lookup", 3, 200e3), ("inverted_hull", 1, 400e3)):
            times = self.time(method)
            self.assertAlmostEqual(times["lines_ns"], passes * 10e3, places=3, msg=method)
            self.assertAlmostEqual(times["mesh_ns"], mesh_ns, places=3, msg=method)
            self.assertAlmostEqual(times["lines_spread_ns"] + times["mesh_spread_ns"], 0, places=3)
            self.assertAlmostEqual(times["ms"], (passes * 10e3 + mesh_ns) / 1e6)
        self.assertNotIn("too coarse", self.measure())

    def test_a_clock_of_a_tenth_of_a_millisecond_will_do(self):
        self.open_made_up(step_ns=100e3)
        times = self.time("surface8")
        self.assertAlmostEqual(times["lines_ns"], 10e3, delta=300)
        self.assertLess(times["lines_spread_ns"], 300)

    def test_a_coarse_clock_is_told(self):
        self.open_made_up(step_ns=30e6)
        self.script("choose({left: 'surface8', right: 'mote4'})")
        times = self.time("surface8")
        self.assertGreater(times["lines_spread_ns"], 0.15 * times["lines_ns"])
        self.assertRegex(self.measure(), "too coarse, or the machine too busy, for the lines of surface8, mote4")

    def test_a_disturbed_clock_gives_no_time(self):
        self.open_made_up(is_disjoint=True)
        self.script("choose({left: 'surface8', right: 'mote4'})")
        self.assertIsNone(self.time("surface8")["ms"])
        self.assertIn("surface8 not measured, mote4 not measured", self.measure())

    def test_the_card_is_copied_saved_and_read_back(self):
        self.open_made_up()
        self.script("choose({left: 'surface8', right: 'mote4'})")
        self.assertIn("by the GPU's own timer", self.measure())
        self.press("Copy card")
        self.wait(lambda: self.script("return copied.length"))
        text = self.script("return copied[0]")
        self.script("window.saveFile = (name, type, text) => copied.push(name, text)")
        self.press("Save card")
        self.assertEqual(self.script("return copied.slice(1)"), ["card.json", text])
        card = json.loads(text)
        self.assertEqual((card["gpu"], card["clock"], card["view"]), ("Made-up GPU 1", "timer query", "iso"))
        self.assertEqual([times["method"] for times in card["methods"]], ["surface8", "mote4"])
        file = self.folder / "card.json"
        file.write_text(text)
        said = subprocess.run([TABULATE, file], capture_output=True, text=True, check=True).stdout
        self.assertRegex(said, r"(?m)^\| GPU \| Made-up GPU 1 \|$")
        self.assertRegex(said, r"(?m)^\| `surface8` \| 0\.01 \|$")
        self.script("choose({view: 'iso'})")
        self.assertEqual(self.script("return [...document.querySelectorAll('button')].filter(b => /card/.test(b.textContent)).length"), 0)

    def test_frames_are_timed_where_queries_are_not(self):
        self.open_made_up(step_ns=100e3, is_for_queries=False)
        times = self.time("surface8")
        self.assertIn("many frames in a row", times["clock"])
        self.assertAlmostEqual(times["lines_ns"], 10e3, delta=300)
        self.assertAlmostEqual(times["mesh_ns"], 200e3, delta=300)

    def test_software_is_timed_by_frames(self):
        self.open(self.page)
        times = self.time("surface8")
        self.assertIn("many frames in a row", times["clock"])
        for of in ("lines", "mesh"):  # beside other work a slope may be none, and its spread is large then
            self.assertGreater(times[f"{of}_ns"] + times[f"{of}_spread_ns"], 0)


if __name__ == "__main__":
    sys.argv[1:1] = ["-v"]
    unittest.main()
