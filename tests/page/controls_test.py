"""Every control of the page, one after the other, as a reader works it: after each change the viewer,
the thumbnails and the charts must hold drawn pixels, and nothing may watch what is no longer there."""

import sys
import unittest

from browser import BrowserTest, Keys, inkbench, webdriver
from controls import controls, work
from ink import broken_attributes, count_ink, settle

# Fewer drawn pixels than these are no picture: an axis alone has no colour, an empty canvas no ink.
LEAST = {"stage": {"left": 60, "right": 60}, "thumb": {"ink": 20}, "card": {"ink": 20},
         "chart": {"ink": 400, "colour": 30}}

# Before any script of the page: keeps what observers watch and which timers run.
WATCH = """
window.watched = new Map();
window.timers = new Set();
for (const name of ['ResizeObserver', 'IntersectionObserver']) {
    window[name] = class extends window[name] {
        observe(node, ...more) {
            super.observe(node, ...more);
            if (!watched.has(this)) watched.set(this, new Set());
            watched.get(this).add(node);
        }
        unobserve(node) { super.unobserve(node); watched.get(this)?.delete(node); }
        disconnect() { super.disconnect(); watched.delete(this); }
    };
}
((start, stop) => {
    window.setInterval = (...words) => { const timer = start(...words); timers.add(timer); return timer; };
    window.clearInterval = timer => { stop(timer); timers.delete(timer); };
})(setInterval, clearInterval);
"""

LOST = """
return [...watched.values()].flatMap(nodes => [...nodes]).filter(node => !node.isConnected)
    .map(node => `${node.tagName} ${node.className}`);
"""


class ControlsTest(BrowserTest):
    @classmethod
    def make_runs(cls):
        inkbench("compare", "--scenes", "cube,tiles", "--methods", "mote4,ids,sobel", "--size", "240x136",
                 "--views", "2", "--repetitions", "1", "--images", "all", "--out", cls.folder / "before")
        for name, images in (("after", "all"), ("bare", "none")):
            inkbench("compare", "--scenes", "cube", "--methods", "ids", "--size", "240x136", "--views", "2",
                     "--repetitions", "1", "--no-sweep", "--images", images, "--out", cls.folder / name)
        cls.three = cls.folder / "three.html"
        inkbench("report", *(cls.folder / name for name in ("before", "after", "bare")), "-o", cls.three)

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WATCH})

    def parts(self):
        return self.script("return sections.filter(s => !s.node.hidden).map(s => s.id)")

    def unfold(self, part):
        self.script("const part = sections.find(s => s.id === arguments[0]); if (part.fold) part.fold.open = true;"
                    "part.node.scrollIntoView()", part)
        settle(self.browser)

    def open_pictures(self, *words, **more):
        self.open(*words, **more)
        self.unfold("pictures")

    def check(self, what, root):
        """All pictures below `root` hold drawn pixels, no attribute lacks a number, and no observer
        or timer has outlived what it is for."""
        boxes = count_ink(self.browser, root)
        for box in boxes:
            for side, least in LEAST[box["kind"]].items():
                if box["kind"] == "stage" and box["cut"] == {"left": 0, "right": 1}[side]:
                    continue  # the divider leaves nothing of this side
                self.assertGreaterEqual(box[side], least, f"{box['name']} after {what}: {box}")
        self.assertEqual(broken_attributes(self.browser), [], f"after {what}")
        self.assertEqual(self.script(LOST), [], f"what is still watched after {what}")
        blinking = self.script("return document.querySelectorAll('#blink[aria-pressed=true]').length")
        self.assertEqual(self.script("return timers.size"), blinking, f"timers after {what}")
        return boxes

    def work_all(self, root, shown, first=None):
        """Works every control below `root` but heads of tables, each from the page's first state, or
        from the choices `first`."""
        found = [c for c in controls(self.browser, root) if c["kind"] not in ("head", "picture")]
        for control in found:
            for choice in control["choices"]:
                self.assertTrue(work(self.browser, root, control, choice), f"{control['name']} is gone")
                self.check(f"{root}, {control['name']} {choice or ''}", shown)
            self.script("state.reset(); state.set(arguments[0])", first or {})
        return found

    # ---- Every control ---------------------------------------------------------------------

    def test_every_choice_of_every_part_leaves_its_pictures(self):
        self.open()
        seen = set()
        worked = 0
        for part in self.parts():
            self.unfold(part)
            seen |= {box["kind"] for box in self.check(part, f"#{part}")}
            worked += len(self.work_all(f"#{part}", f"#{part}"))
            self.script("sections.filter(s => s.fold).forEach(s => { s.fold.open = false; })")
        self.assertEqual(seen, {"stage", "thumb", "chart"})
        self.assertGreater(worked, 30)

    def test_every_filter_leaves_the_pictures_of_all_parts(self):
        self.open()
        for part in self.parts():
            self.script("document.getElementById(arguments[0]).scrollIntoView()", part)
            settle(self.browser)
        self.script("scrollTo(0, 0)")
        names = [control["name"] for control in self.work_all("#filters", "body")]
        self.assertTrue(any("budget" in name for name in names) and any("Theme" in name for name in names), names)

    def test_every_name_that_is_ticked_off_leaves_the_pictures(self):
        self.open()
        for name in ("methods", "scenes"):
            self.find(f'details.picker[data-name="{name}"] summary').click()
            for control in [c for c in controls(self.browser, ".picker[open]") if c["kind"] == "checkbox"]:
                work(self.browser, ".picker[open]", control)
                self.check(f"{control['name']} off", "#pictures")
                self.assertTrue(work(self.browser, ".picker[open]", control), "the list has closed")
                self.check(f"{control['name']} on", "#pictures")
            self.find(f'details.picker[data-name="{name}"] summary').click()

    def test_every_head_sorts_its_table(self):
        self.open()
        for part in self.parts():
            self.unfold(part)
            heads = [c["name"] for c in controls(self.browser, f"#{part}") if c["kind"] == "head"]
            lazy = self.script(
                "const [selector, names] = arguments; const head = name => controlsBelow(selector).find(c => c.name === name).node;"
                "return names.filter(name => { head(name).click(); return head(name).closest('th').ariaSort === 'none'; })",
                f"#{part}", heads)
            self.assertEqual(lazy, [], part)
            if heads:
                self.check("sorting", f"#{part}")

    # ---- The viewer --------------------------------------------------------------------------

    def stage(self, what):
        return next(box for box in self.check(what, "#pictures") if box["kind"] == "stage")

    def test_keys_wheel_and_pointer_leave_the_viewer_drawn(self):
        self.open_pictures()
        canvas = self.find("canvas.stage")
        canvas.click()
        before = self.stage("a click")
        for key in (Keys.ARROW_LEFT, Keys.ARROW_RIGHT, "b", "b", "+", "-", "0"):
            canvas.send_keys(key)
            self.stage(f"key {key!r}")
        self.assertEqual(self.stage("keys"), before)
        webdriver.ActionChains(self.browser).scroll_from_origin(
            webdriver.common.actions.wheel_input.ScrollOrigin.from_element(canvas), 0, -100).perform()
        nearer = self.stage("the wheel")
        self.assertNotEqual((nearer["left"], nearer["right"]), (before["left"], before["right"]))
        webdriver.ActionChains(self.browser).move_to_element_with_offset(canvas, 150, 0).click_and_hold() \
            .move_by_offset(-60, 20).release().perform()
        self.stage("moving")
        webdriver.ActionChains(self.browser).move_to_element(canvas).click_and_hold() \
            .move_by_offset(-200, 0).release().perform()
        self.assertLess(self.stage("moving the divider")["cut"], 0.4)

    def test_only_runs_with_images_of_a_view_stand_on_the_right(self):
        self.open_pictures(self.three, "#scene=cube&rightRun=2")
        self.stage("a run without images")
        options = [option.text for option in self.find_all("#pictures select[aria-label='Right of run'] option")]
        self.assertEqual(options, ["before", "after"])
        self.work_all("#pictures", "#pictures", {"scene": "cube"})

    def test_what_was_enlarged_of_one_scene_is_not_of_the_next(self):
        self.open_pictures(address="#scene=cube")
        for _ in range(6):
            self.find("#nearer").click()
        self.script("state.set({scene: 'tiles'})")
        enlarged = self.stage("another scene")
        self.find("#fit").click()
        self.assertEqual(self.stage("Fit"), enlarged)

    def test_two_choices_in_a_row_leave_one_viewer_at_work(self):
        self.open_pictures()
        self.script("state.set({right: 'sobel'}); state.set({right: 'mote4'})")
        self.stage("two choices")
        self.find("#blink").click()
        self.assertEqual(self.find("#blink").get_attribute("aria-pressed"), "true")
        self.stage("blinking")
        self.script("state.set({scene: 'tiles'})")
        self.assertEqual(self.find("#blink").get_attribute("aria-pressed"), "false")
        self.stage("a choice while it blinks")

    def test_pictures_open_in_the_viewer(self):
        self.open()
        for part in ("pictures", "grid"):
            self.unfold(part)
            for control in [c for c in controls(self.browser, f"#{part}") if c["kind"] == "picture"]:
                self.assertTrue(work(self.browser, f"#{part}", control), control["name"])
                self.stage(control["name"])

    def test_a_width_of_nothing_leaves_no_mark(self):
        self.open()
        for part in ("pictures", "time"):
            self.unfold(part)
            for display in ("none", ""):
                self.script("document.getElementById(arguments[0]).style.display = arguments[1]", part, display)
                settle(self.browser)
            self.check("hiding and showing", f"#{part}")

    # ---- What floats ---------------------------------------------------------------------------

    def test_points_and_cells_show_their_picture(self):
        self.open()
        for part in self.parts():
            self.unfold(part)
            target = next(iter(self.find_all(
                f"#{part} .answers, #{part} .thumb-button:not([aria-label^=truth])")), None)
            if target is None:
                continue
            self.script("arguments[0].scrollIntoView({block: 'center'});"
                        "arguments[0].dispatchEvent(new PointerEvent('pointerenter', {clientX: 200, clientY: 200}))", target)
            shown = self.check(f"the pointer on {part}", "body > .card")
            self.assertEqual([box["kind"] for box in shown], ["card"], part)
            self.script("hideCard()")

    def test_what_floats_goes_with_what_it_is_about(self):
        self.open()
        self.unfold("time")
        for choice in ("bytes", "ms"):
            self.script("const point = document.querySelector('#time .point');"
                        "for (const type of ['pointerenter', 'pointermove']) point.dispatchEvent(new PointerEvent(type));"
                        "showTip('a point', 100, 100, point)")
            self.assertEqual(self.script("return [card.node.hidden, tip.node.hidden]"), [False, False])
            self.script("state.set({'time.x': arguments[0]})", choice)
            settle(self.browser)
            self.assertEqual(self.script("return [card.node.hidden, tip.node.hidden]"), [True, True])

    # ---- The reader's place ----------------------------------------------------------------------

    def test_a_choice_keeps_the_focus_and_the_scrolled_place(self):
        self.open()
        for part, selector, key in (("pictures", "select[aria-label=Right]", Keys.ARROW_DOWN),
                                    ("filters", "#budget", Keys.PAGE_DOWN)):
            self.script("document.querySelector(arguments[0]).focus()", f"#{part} {selector}")
            for _ in range(2):  # the second stroke arrives only if the first left the focus there
                before = self.address()
                webdriver.ActionChains(self.browser).send_keys(key).perform()
                settle(self.browser)
                self.assertNotEqual(self.address(), before, part)
            self.script("state.reset()")
        with self.window(400):
            self.unfold("rows")
            self.find("#rows details.picker summary").click()
            self.script("document.querySelector('#rows .picker-list').scrollTop = 200;"
                        "document.querySelector('#rows .data').parentElement.scrollLeft = 90;"
                        "document.querySelectorAll('#rows .picker-list input')[30].click()")
            settle(self.browser)
            self.assertEqual(self.script("return [document.querySelector('#rows .picker-list').scrollTop,"
                                         "document.querySelector('#rows .data').parentElement.scrollLeft]"), [200, 90])

    # ---- Themes and widths -------------------------------------------------------------------------

    def test_dark_and_light_and_a_phone_show_every_picture(self):
        # Light and wide is what all other tests see.
        for theme, width in (("dark", 1280), ("light", 400)):
            with self.window(width):
                self.open(address=f"#theme={theme}")
                for part in self.parts():
                    self.unfold(part)
                    self.check(f"{theme}, {width} px", f"#{part}")
                self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), width)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + ["-v"] + sys.argv[1:])
