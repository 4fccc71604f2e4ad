"""The page as one reads it: what comes first, with the keyboard alone, on paper, and what it says of
what it does not know."""

import base64
import re
import sys
import unittest

from access import faults
from browser import BrowserTest, Keys, give_times, inkbench, webdriver
from ink import settle

# No two are alike: what is cheapest has one name.
TIMES_MS = {"mote4": .03, "surface8": .045, "ids": .06, "edge_list": .08, "edge_hash": .1, "sobel": .13}

ON_PAPER = """
window.onPaper = null;
addEventListener('beforeprint', () => {
    const there = sections.filter(s => !s.node.hidden && isOpen(s));
    window.onPaper = {
        folded: [...document.querySelectorAll('main details:not([open], .picker, .fold)')].length,
        undrawn: there.filter(s => !s.body.childElementCount).map(s => s.id),
        charts: [...document.querySelectorAll('figure.chart')].map(f => [f.id, f.querySelectorAll('svg > *').length]),
        theme: document.documentElement.className,
    };
});
"""

# Bars that are shown and texts beside points, as boxes: which of them meet.
CROSSED = """
const boxes = selector => [...document.querySelectorAll(selector)].map(node => [node.textContent, node.getBoundingClientRect()]);
const bars = boxes('#chart-error-time .cross.kept line');
return boxes('#chart-error-time .labels text').filter(([, text]) => bars.some(([, bar]) =>
    bar.left < text.right - 1 && text.left < bar.right - 1 && bar.top < text.bottom - 3 && text.top < bar.bottom - 3)).map(([text]) => text);
"""


class ReadingTest(BrowserTest):
    @classmethod
    def make_runs(cls):
        # All lines of the fence are too dense at this size.
        inkbench("compare", "--scenes", "cube,gear,tiles,fence", "--methods",
                 "mote4,ids,edge_hash,edge_list,sobel,surface8", "--size", "320x180", "--views", "2",
                 "--repetitions", "1", "--no-crosscheck", "--images", "all", "--out", cls.folder / "before")
        give_times(cls.folder / "before", TIMES_MS)
        inkbench("compare", "--scenes", "cube", "--methods", "ids", "--size", "160x90", "--repetitions", "1",
                 "--no-sweep", "--no-crosscheck", "--out", cls.folder / "after")
        inkbench("report", cls.folder / "before", cls.folder / "after", "-o", cls.folder / "two.html")

    def press(self, *keys):
        webdriver.ActionChains(self.browser).send_keys(*keys).perform()
        settle(self.browser)

    def tab_to(self, selector, most=150):
        """Presses Tab until the focus is on what `selector` names."""
        for _ in range(most):
            if self.script("return document.activeElement.matches(arguments[0])", selector):
                return
            webdriver.ActionChains(self.browser).send_keys(Keys.TAB).perform()
        self.fail(f"{most} times Tab do not lead to {selector}")

    def is_held(self, selector):
        return self.script("return document.activeElement.matches(arguments[0])", selector)

    def unfold_all(self):
        self.script("for (const s of sections.filter(s => !s.node.hidden)) {"
                    "if (s.fold) s.fold.open = true; drawSection(s); }")

    # ---- Order -----------------------------------------------------------------------------

    def test_finding_chart_pictures_and_table_come_first_and_the_rest_is_folded(self):
        with self.window(1440, 1000):
            self.open()
            ends = self.script("return ['h1', '#chart-error-time svg', '#pictures', '#grid', '#verdict', 'details.fold']"
                               ".map(s => document.querySelector(s).getBoundingClientRect()).map(box => [box.top, box.bottom])")
            self.assertEqual([top for top, _ in ends], sorted(top for top, _ in ends))
            self.assertLessEqual(ends[1][1], 1000, "the chart's end is below the first screen")
        self.assertEqual(self.script("return sections.filter(s => !s.node.hidden && !s.fold).map(s => s.id)"),
                         ["time", "pictures", "grid", "verdict"])
        self.assertEqual(self.find_all("details.fold[open]"), [])

    def test_at_most_eight_links(self):
        for file in ("before/report.html", "two.html"):
            self.open(self.folder / file)
            links = [link for link in self.find_all("nav a") if link.is_displayed()]
            self.assertIn(len(links), range(5, 9), [link.text for link in links])
        links[-1].click()
        self.wait(lambda: self.find("#about details").get_attribute("open"))

    def test_the_viewer_opens_where_the_leaders_differ_most(self):
        self.open(part="pictures")
        self.wait(lambda: self.find("canvas.stage").get_attribute("data-drawn"))
        *_, scene, view = self.find("canvas.stage").get_attribute("data-drawn").split("|")
        # The six methods but the two worst.
        apart = self.script(
            "const view = currentView(); const best = view.contestants.slice().sort((a, b) => b.value - a.value);"
            "const names = [...new Set([view.best, ...best].map(s => s.method))].slice(0, 4); const made = {};"
            "for (const [key, rows] of groupBy(view.rows.filter(r => isScored(r) && names.includes(r.method)), r => r.scene + ' ' + r.view))"
            "    made[key] = d3.max(rows, r => r.f_2px) - d3.min(rows, r => r.f_2px);"
            "return made")
        self.assertGreater(max(apart.values()), min(apart.values()))
        self.assertEqual(apart[f"{scene} {view}"], max(apart.values()), apart)

    # ---- Keyboard --------------------------------------------------------------------------

    def test_the_keyboard_alone_leads_from_a_filter_to_a_picture(self):
        self.open()
        self.tab_to("#budget")
        first = self.find("h1").text
        self.press(Keys.ARROW_LEFT)
        self.press(Keys.ARROW_LEFT)
        self.assertTrue(self.is_held("#budget"), "a step took the focus away")
        self.wait(lambda: self.find("h1").text != first)
        self.tab_to("#reset")
        self.press(Keys.ENTER)
        self.assertTrue(self.is_held("#reset"), "Reset took the focus away")
        self.wait(lambda: self.find("h1").text == first)
        self.tab_to("canvas.stage")
        self.press(Keys.ARROW_LEFT)
        self.assertEqual(self.find("canvas.stage").get_attribute("data-cut"), "0.480")
        self.tab_to(".thumb-button[aria-label^='sobel on gear']")
        self.press(Keys.ENTER)
        self.wait(lambda: "sobel|gear" in (self.find("canvas.stage").get_attribute("data-drawn") or ""))
        self.assertTrue(self.is_held("canvas.stage"), "what Enter opened has not the focus")

    def test_a_card_takes_the_focus_and_gives_it_back(self):
        self.open(part="time")
        self.script("document.querySelector('#time .point[data-method=ids]').focus()")
        self.press(Keys.ENTER)
        self.assertTrue(self.is_held(".card button"))
        self.script("[...document.querySelectorAll('.card button')].find(b => b.textContent.startsWith('better')).focus()")
        for at in (2, 3):
            self.press(Keys.ENTER)
            self.assertIn(f"{at} of 6 views", self.find(".card").text)
        self.press(Keys.ESCAPE)
        self.assertTrue(self.is_held("#time .point[data-method=ids]"))

    def test_the_budget_steps_over_the_times_of_methods(self):
        self.open()
        words = lambda: self.script("return document.querySelector('#budget').getAttribute('aria-valuetext')")
        self.assertEqual(words(), "none")
        times = self.script("return currentView().contestants.map(s => [s.ms, s.method]).sort((a, b) => b[0] - a[0])")
        self.find("#budget").send_keys("")
        for ms, method in times:
            self.press(Keys.ARROW_LEFT)
            budget = self.script("return state.get('budget')")
            self.assertTrue(ms <= budget < 1.02 * ms, f"{budget} is no time of {method}, {ms}")
            self.assertIn(method, words())
        self.press(Keys.ARROW_LEFT)
        said = f"none is faster than {self.script('return formatMs(arguments[0])', times[-1][0])} ms ({times[-1][1]})"
        self.assertEqual(words(), said)
        self.assertIn(said, self.find("#filters").text)
        self.wait(lambda: said in self.find("h1").text)

    def test_the_margin_can_be_chosen(self):
        self.open()
        margin = self.find("#margin")
        self.assertEqual(margin.get_attribute("value"), "0.01")
        margin.clear()
        margin.send_keys("0.9", Keys.ENTER)
        self.wait(lambda: self.address() == "#margin=0.9")
        cheapest = self.script("return currentView().contestants.reduce((a, b) => a.ms < b.ms ? a : b).method")
        self.wait(lambda: cheapest in self.find("h1").text)
        self.find("#margin").clear()
        self.find("#margin").send_keys("-1", Keys.ENTER)
        self.assertEqual((self.find("#margin").get_attribute("value"), self.address()), ("0.9", "#margin=0.9"))

    def test_an_open_list_closes_by_escape_and_by_a_click_beside_it(self):
        self.open()
        names = ("methods", "scenes")
        is_open = lambda: [self.script("return document.querySelector(arguments[0]).open", f".picker[data-name={name}]")
                           for name in names]
        methods, scenes = (self.find(f".picker[data-name={name}] summary") for name in names)
        methods.click()
        self.find(".picker[open] input").send_keys(Keys.ESCAPE)
        self.assertEqual(is_open(), [False, False])
        self.assertEqual(self.browser.switch_to.active_element, methods)
        methods.click()
        scenes.click()
        self.assertEqual(is_open(), [False, True])
        self.find("h1").click()
        self.assertEqual(is_open(), [False, False])

    def test_the_first_chart_has_one_title_and_methods_alone(self):
        self.open(part="time")
        text = self.script("return document.querySelector('#time').innerText")
        self.assertEqual(text.lower().count("error, 1"), 1, text)
        self.assertEqual(self.find_all("#time path.setting"), [])

    def test_the_side_list_of_a_phone_is_whole_and_marks_the_answer(self):
        with self.window(390):
            self.open(part="pictures")
            tall, shown, named = self.script("const side = document.querySelector('.side'); return [side.scrollHeight, "
                                             "side.clientHeight, [...side.querySelectorAll('b')].map(b => b.textContent)]")
            self.assertLessEqual(tall, shown)
            self.assertEqual(named, ["answer"])

    def test_reset_gives_back_filters_alone(self):
        self.open(address="#theme=dark&scene=gear&right=sobel&measure=recall&budget=9&sort.verdict=ms.up")
        self.find("#reset").click()
        self.wait(lambda: "measure" not in self.address())
        self.assertEqual(self.script("return ['theme', 'scene', 'right', 'budget', 'sort.verdict'].map(n => state.get(n))"),
                         ["dark", "gear", "sobel", 0, "ms.up"])

    def test_the_divider_moves_while_the_images_blink(self):
        self.open(part="pictures")
        self.wait(lambda: self.find("canvas.stage").get_attribute("data-drawn"))
        self.find("#blink").click()
        self.find("#divider").send_keys(Keys.HOME)
        self.assertEqual(self.find("canvas.stage").get_attribute("data-cut"), "0.000")
        self.assertEqual(self.find("#blink").get_attribute("aria-pressed"), "false")

    def test_a_table_opened_whole_stays_so_when_it_is_sorted(self):
        self.open(part="about")
        lines = lambda: self.script("return [...document.querySelectorAll('#about table')].pop().tBodies[0].rows.length")
        self.assertEqual(lines(), 40)
        self.script("[...document.querySelectorAll('#about button')].find(b => b.textContent.startsWith('Show all')).click()")
        whole = lines()
        self.assertGreater(whole, 40)
        self.script("[...document.querySelectorAll('#about table')].pop().querySelector('thead button').click()")
        self.assertEqual(lines(), whole)

    # ---- What is not known -----------------------------------------------------------------

    def test_warnings_are_grouped_in_two_lines_and_unfold(self):
        with self.window(1440, 1000):
            self.open()
            warning = self.find("header .warning")
            self.assertEqual(warning.text, "2 views without a score. fence: all views too dense at 320x180; try --size 960x540.")
            self.assertLess(warning.size["height"], 2 * 30)
            self.find("header .warning summary").click()
            self.assertEqual([re.match(r"fence view\d: crowded", item.text) is not None
                              for item in self.find_all("header .warning li")], [True, True])

    def test_cells_without_a_score_are_hatched(self):
        self.open(part="scenes")
        looks = self.script(
            "return [...document.querySelectorAll('#scenes tbody tr')].map(row => [row.cells[0].textContent,"
            " [...row.cells].slice(5).map(cell => getComputedStyle(cell)).map(s => [s.backgroundImage, s.backgroundColor])])")
        for scene, cells in looks:
            for image, colour in cells:
                if scene == "fence":
                    self.assertIn("repeating-linear-gradient", image)
                    self.assertEqual(colour, "rgba(0, 0, 0, 0)")
                else:
                    self.assertEqual(image, "none")
        self.assertIn("fence", [scene for scene, _ in looks])
        unscored = self.script("return getComputedStyle(document.querySelector('#grid .unscored')).backgroundImage")
        self.assertIn("repeating-linear-gradient", unscored)

    def test_the_worst_view_says_of_how_many_there_are_images(self):
        for kept, said in ((6, "Worst of 6 views."), (2, "Worst of the 2 of 6 views with an image.")):
            self.open(part="time")
            self.script("const images = viewImages.packed[0]; const names = Object.keys(images).filter(n => !n.startsWith('fence'));"
                        "for (const name of names.slice(arguments[0])) delete images[name]; sections.find(s => s.id === 'time').isStale = true;"
                        "drawSection(sections.find(s => s.id === 'time'));"
                        "document.querySelector('#time .point[data-method=ids]').dispatchEvent(new PointerEvent('pointerenter'))", kept)
            self.assertIn(said, self.find(".card").text)

    def test_bars_run_through_no_name_and_show_where_one_points(self):
        for width in (1440, 390):
            with self.window(width, 900):
                self.open(part="time")
                self.assertEqual(self.script(CROSSED), [], width)
        opacity = lambda: self.script("return [...document.querySelectorAll('#chart-error-time .cross')].map(c => getComputedStyle(c).opacity)")
        self.open(part="time")
        self.assertIn("0", opacity())
        at = opacity().index("0")
        self.script("document.querySelectorAll('#chart-error-time .point')[arguments[0]].focus()", at)
        self.wait(lambda: opacity()[at] == "1")

    # ---- Paper, and reading by ear -----------------------------------------------------------

    def test_paper_has_what_is_open_on_at_most_ten_sheets(self):
        self.open(address="#theme=dark&open=classes")
        self.script(ON_PAPER)
        paper = base64.b64decode(self.browser.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})["data"])
        seen = self.wait(lambda: self.script("return window.onPaper"))
        self.assertEqual((seen["folded"], seen["undrawn"], seen["theme"]), (0, [], "light-theme"))
        self.assertGreaterEqual(len(seen["charts"]), 2)
        self.assertEqual([name for name, parts in seen["charts"] if not parts], [])
        sheets = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", paper)
        self.assertLessEqual(len(sheets), 10)
        self.assertGreater(float(sheets[0][0]), float(sheets[0][1]), "paper lies on its side")
        self.wait(lambda: not self.find_all("details[data-for-paper]"))
        self.assertEqual((self.address(), self.script("return document.documentElement.className")),
                         ("#theme=dark&open=classes", "dark-theme"))

    def test_print_with_all_pictures_draws_every_thumbnail(self):
        self.open()
        self.script("window.print = () => { window.drawn = [...document.querySelectorAll('canvas.thumb')]"
                    ".map(canvas => canvas.hasAttribute('width')); }; document.querySelector('footer button').click()")
        drawn = self.wait(lambda: self.script("return window.drawn"))
        self.assertTrue(len(drawn) > 20 and all(drawn), drawn)

    def test_nothing_bars_the_way_of_assistive_technology(self):
        for theme, width in (("light", 1440), ("dark", 390)):
            with self.window(width, 900):
                self.open(address=f"#theme={theme}")
                self.unfold_all()
                settle(self.browser)
                self.assertEqual(faults(self.browser), [], f"{theme}, {width} px")

    def test_no_width_cuts_the_page(self):
        for width in (1440, 1024, 390):
            with self.window(width, 900):
                for file in ("before/report.html", "two.html"):
                    self.open(self.folder / file)
                    self.unfold_all()
                    self.script("for (const list of document.querySelectorAll('.filters, .picker')) list.open = true")
                    self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), width)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + ["-v"] + sys.argv[1:])
