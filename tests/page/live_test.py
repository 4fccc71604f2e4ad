"""The page that draws a model, as a reader works it: every control, what it draws, themes, widths; and what
programs call in it. Its lines must be those of the program's methods."""

import base64
import io
import itertools
import json
import sys
import unittest
from pathlib import Path

from access import faults
from browser import PROGRAM, BrowserTest, Keys, TimeoutException, inkbench, skip, webdriver
from controls import controls, work

sys.path.append(str(Path(__file__).parents[1] / "referees"))

try:
    import numpy
    from gltf_files import Glb
    from PIL import Image
except ImportError:
    skip("python3-numpy or python3-pil is not installed")

SHADERS = Path(PROGRAM).parent / "generated" / "shaders"  # whole
CLASSES = {each["name"]: each for each in json.loads((Path(__file__).parents[2] / "src/core/vocabulary.json").read_text())["classes"]}
SIZE = (320, 180)
SIZE_WORD = "320x180"
# The thresholds of the program's methods; 128 for what is not here.
THRESHOLDS = {"roberts": 74, "decaudin": 146, "mote4": 6}
MOST_SHADER_LINES = {"strokes": 1030, "chords": 540, "surface_lookup": 360}  # 60 for what is not here
INK = {"chords", "strokes"}
# SwiftShader snaps vertices to 1/16 px and the program to 1/256 px: so much of the lines is the same.
LEAST_EQUAL = 0.95
MOST_APART = 4  # of 255, in the mean over pixels with ink


class LiveTest(BrowserTest):
    # The watchdog ends what draws slowly, and all drawings with it.
    switches = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-watchdog")
    harmless = ("GPU stall due to ReadPixels",)

    @classmethod
    def make_runs(cls):
        inkbench("compare", "--scenes", "blocks", "--methods", "chords,surface8,ids", "--size", SIZE_WORD, "--views", "2",
                 "--repetitions", "1", "--no-sweep", "--no-crosscheck", "--out", cls.folder / "run")
        cls.page = cls.folder / "blocks.html"
        inkbench("page", "blocks", "--size", SIZE_WORD, "--views", "2", "--run", cls.folder / "run", "-o", cls.page)
        cls.parallel = cls.folder / "parallel.html"
        inkbench("page", "torus", "--size", SIZE_WORD, "--views", "iso,front", "-o", cls.parallel)

    def open_live(self, file=None):
        self.open(file or self.page)
        self.script("window.copied = []; Object.defineProperty(navigator, 'clipboard', {configurable: true, "
                    "value: {writeText: async text => { copied.push(text); }}})")
        self.settle()

    def settle(self):
        self.browser.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))")
        self.assertEqual(self.script("return document.getElementById('trouble').textContent"), "")

    def picture(self):
        """The canvas as it is seen, as an array of (height, width, 3)."""
        box = self.script("const b = canvas.getBoundingClientRect();"
                          "return {x: b.left + scrollX, y: b.top + scrollY, width: b.width, height: b.height, scale: 1}")
        png = self.browser.execute_cdp_cmd("Page.captureScreenshot", {
            "format": "png", "clip": box, "captureBeyondViewport": True})["data"]
        return numpy.asarray(Image.open(io.BytesIO(base64.b64decode(png))).convert("RGB")).astype(int)

    def ink(self, colour=(0, 0, 0)):
        """Pixels near a colour left and right of the middle, without labels and divider."""
        picture = self.picture()
        height, width = picture.shape[:2]
        is_ink = numpy.abs(picture - colour).sum(axis=2) < 150
        is_ink[:height // 8] = False
        return int(is_ink[:, :width // 2 - 20].sum()), int(is_ink[:, width // 2 + 20:].sum())

    def wait_for_ink(self, is_right, name="", colour=(0, 0, 0)):
        """Waits until the ink on both sides is as a test has it: where cores are all taken, what was drawn
        stands on the screen only some frames later."""
        counts = []
        try:
            self.wait(lambda: counts.append(self.ink(colour)) or is_right(*counts[-1]))
        except TimeoutException:
            self.fail(f"{name}: ink {counts[-1]}")

    def wait_for_lines(self, name="", colour=(0, 0, 0)):
        self.wait_for_ink(lambda left, right: min(left, right) > 30, name, colour)

    def ink_of(self, method, view="view0", width_px=1):
        text = self.script("const bytes = inkbench.draw({method: arguments[0], width: arguments[1], height: arguments[2],"
                           "view: arguments[3], lineWidthPx: arguments[4]}); return Array.from(bytes)",
                           method, *SIZE, view, width_px)
        return numpy.array(text, numpy.uint8).reshape(SIZE[1], SIZE[0])

    def drawn(self, method, view="view0"):
        return self.ink_of(method, view) > 0

    def drawn_by_program(self, scene, method, *words):
        file = self.folder / "ours.png"
        inkbench("draw", scene, "--method", method, "--response", "-o", file, *words, "--size", SIZE_WORD)
        return numpy.asarray(Image.open(file).convert("L"))

    def open_model(self, model, *words):
        """The page of a model; the name of its first view."""
        page = self.folder / "model.html"
        inkbench("page", model, "--size", SIZE_WORD, *words, "-o", page)
        self.open_live(page)
        return self.script("return inkbench.views[0]")

    def check_few_differ(self, corners, faces, eye, methods, most):
        """Of an OBJ file: `most` of the pixels of a method's lines are others in the page."""
        file = self.folder / "made.obj"
        file.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {' '.join(map(str, face))}\n" for face in faces))
        view = self.open_model(file, *eye)
        for method in methods:
            ours, theirs = self.drawn_by_program(file, method, *eye) > 0, self.drawn(method, view)
            self.assertGreater(ours.sum(), 200, method)
            self.assertLess((ours != theirs).sum(), most * ours.sum(), method)

    # ---- What it draws -----------------------------------------------------------------------

    def test_lines_are_those_of_the_program(self):
        cases = [(self.page, "blocks", ["--views", "2"], "view1"), (self.parallel, "torus", ["--views", "iso,front"], "iso")]
        for page, scene, more, view in cases:
            self.open_live(page)
            for method in set(self.script("return inkbench.methods")) - INK:
                ours = self.drawn_by_program(scene, method, "--view", view, *more) >= THRESHOLDS.get(method, 128)
                theirs = self.drawn(method, view)
                self.assertGreater(ours.sum(), 200, method)
                equal = 1 - (ours != theirs).sum() / (2 * ours.sum())
                self.assertGreater(equal, LEAST_EQUAL, f"{method} of {scene}")

    def test_ink_is_that_of_the_program(self):
        def soft_f(ink, scene, width_px, words):
            file = self.folder / "ink.png"
            Image.fromarray(ink).save(file)
            return json.loads(inkbench("score", file, "--model", scene, *words, "--coverage", "--line-width", width_px,
                                       "--json"))["soft_f"]

        for page, scene, more, view, widths in (
                (self.page, "blocks", ["--views", "2"], "view1", [1]),
                (self.parallel, "torus", ["--views", "iso,front"], "iso", [1, 2, 4])):
            self.open_live(page)
            for method, width_px in itertools.product(INK, widths):
                what, words = f"{method}, {scene}, {width_px} px", ["--view", view, *more]
                ours = self.drawn_by_program(scene, method, *words, "--set", f"width_px={width_px}")
                theirs = self.ink_of(method, view, width_px)
                has_ink = (ours > 0) | (theirs > 0)
                apart = numpy.abs(ours.astype(int) - theirs)[has_ink].mean()
                self.assertLess(apart, MOST_APART, what)
                scores = [soft_f(ink, scene, width_px, words) for ink in (ours, theirs)]
                self.assertAlmostEqual(*scores, delta=0.003, msg=what)

    def test_a_browser_without_clip_control_draws_the_same(self):
        self.open_live()
        self.assertEqual(self.script("return renderer.isReversed"), True)
        before = {method: self.drawn(method) for method in self.script("return inkbench.methods")}
        source = ("const get = WebGL2RenderingContext.prototype.getExtension; WebGL2RenderingContext.prototype.getExtension ="
                  " function(name) { return name === 'EXT_clip_control' ? null : get.call(this, name); };")
        added = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": source})
        try:
            self.open_live()
            self.assertEqual(self.script("return renderer.isReversed"), False)
            for method, lines in before.items():
                self.assertLess((self.drawn(method) != lines).sum(), 0.01 * lines.sum(), method)
        finally:
            self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)

    def test_a_browser_without_webgl_says_so(self):
        source = "HTMLCanvasElement.prototype.getContext = () => null;"
        added = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": source})
        try:
            self.open(self.page)
            self.assertIn("no WebGL 2", self.find("#trouble").text)
            self.assertEqual(self.find_all("canvas"), [])
        finally:
            self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)

    def test_each_shader_is_short_and_what_is_copied(self):
        self.open_live()
        for method in self.script("return inkbench.methods"):
            text = (SHADERS / f"{method}.glsl").read_text()
            self.assertLessEqual(len(text.splitlines()), MOST_SHADER_LINES.get(method, 60), method)
            self.assertEqual(self.script("return SHADERS[arguments[0]].text", method), text)
            self.script("choose({left: arguments[0]})", method)
            self.script("[...document.querySelectorAll('#methods button')].find(b => b.textContent.startsWith('Copy')).click()")
            self.wait(lambda text=text: self.script("return copied.at(-1)") == text)

    def test_covered_pixels_and_bad_words(self):
        self.open_live()
        share = self.script("const bytes = inkbench.cover({width: 64, height: 36, view: 'view0'});"
                            "return bytes.filter(b => b === 255).length / bytes.length")
        self.assertTrue(0.05 < share < 0.9, share)
        for asked, words in (("{method: 'nothing', width: 8, height: 8, view: 'view0'}", "no method is called nothing"),
                             ("{method: 'ids', width: 8, height: 8, view: 'below'}", "no view is called below"),
                             ("{method: 'ids', width: 0, height: 8, view: 'view0'}", "no size: 0 x 8")):
            said = self.script(f"try {{ inkbench.draw({asked}); return ''; }} catch (error) {{ return error.message; }}")
            self.assertIn(words, said)

    # ---- Controls ------------------------------------------------------------------------------

    def test_every_control_leaves_lines_on_both_sides(self):
        self.open_live()
        worked = 0
        for root in ("#methods", "#controls"):
            for control in controls(self.browser, root):
                if "Copy" in control["name"] or "Measure" in control["name"]:
                    continue
                for choice in control["choices"]:
                    if choice and "3840" in choice:
                        continue  # slow on software; a test of its own
                    self.assertTrue(work(self.browser, root, control, choice), control["name"])
                    self.settle()
                    worked += 1
                    if "Lines" in control["name"]:
                        self.wait_for_ink(lambda left, right: left == right == 0, control["name"])
                    else:
                        colour = ((0, 68, 204) if control["kind"] == "color" else (0, 114, 178) if "Classes" in control["name"]
                                  else (0, 0, 0))  # of contours
                        self.wait_for_lines(f"{control['name']} {choice}", colour)
                self.open_live()
                controls(self.browser, root)  # a new page knows none yet
        self.assertGreater(worked, 30)

    def test_exact_lines_lie_on_those_of_the_best_method(self):
        self.open_live()

        def marks(**choices):
            self.script("choose({left: 'surface_lookup', right: 'surface8', cut: 1, hasFill: false, ...arguments[0]})", choices)
            self.settle()
            is_mark = self.picture().min(axis=2) < 160
            is_mark[:len(is_mark) // 8], is_mark[:, -20:] = False, False  # labels, divider
            return is_mark

        def grown(is_mark):
            return numpy.array([numpy.roll(is_mark, (y, x), (0, 1)) for y in range(-3, 4) for x in range(-3, 4)]).any(axis=0)

        lines, exact = marks(), marks(hasLines=False, hasExactLines=True)
        self.assertEqual(self.find("#exact").text.split(), ["Exact", "lines:", "intersection", "crease", "contour"])
        self.assertGreater(exact.sum(), 300)
        self.assertGreater((exact & grown(lines)).sum(), 0.95 * exact.sum())
        self.assertGreater((lines & grown(exact)).sum(), 0.95 * lines.sum())
        self.find("canvas").send_keys(Keys.ARROW_LEFT)  # no view of the page
        self.settle()
        self.assertEqual(self.find_all("svg.exact path"), [])
        self.assertNotIn("Exact lines", self.find("#controls").text)

    def test_a_page_says_how_large_it_is_and_when_it_was_ready(self):
        self.open_live()
        self.assertRegex(self.find("#foot").text, r"It has 0\.\d MB and was ready after \d+\.\d s\.")

    def test_sizes_up_to_4k(self):
        self.open_live()
        self.script("choose({left: 'surface8', right: 'mote4', size: [3840, 2160]})")  # on software others take long
        self.settle()
        self.assertEqual(self.script("return [canvas.width, canvas.height]"), [3840, 2160])
        self.assertGreater(self.script("return inkbench.draw({method: 'surface8', width: 3840, height: 2160, view: 'view0'})"
                                       ".filter(b => b === 255).length"), 5000)

    def test_wider_lines_are_wider(self):
        self.open_live()
        self.script("choose({hasFill: false})")
        self.settle()
        self.wait_for_lines()
        thin = sum(self.ink())
        self.script("choose({lineWidthPx: 4})")
        self.wait_for_ink(lambda left, right: left + right > 2 * thin)

    def test_ink_is_grey_and_lines_of_pixels_are_not(self):
        self.open_live()
        self.script("choose({hasFill: false, size: [320, 180]}); frame.style.width = '320px'")
        self.settle()
        self.wait_for_lines()
        grey = numpy.ptp(self.picture(), axis=2) < 4
        grey &= abs(self.picture()[:, :, 0] - 128) < 64
        grey[:45] = False
        self.assertGreater(grey[:, :140].sum(), 100)
        self.assertEqual(grey[:, 180:].sum(), 0)

    def test_fins_and_triangles_without_a_surface_are_drawn(self):
        corners = [(0, 0, 0), (0, 0, 2), (1, 0.2, 0), (1, 0.2, 2), (-1, 0.4, 0), (-1, 0.4, 2), (0.1, 1, 0), (0.1, 1, 2),
                   (-2, 1, 0), (-1, 2, 0), (0, 3, 0)]  # the last three in a row
        faces = [(1, 2, 4), (1, 4, 3), (2, 1, 5), (2, 5, 6), (1, 2, 8), (1, 8, 7), (9, 10, 11)]
        # At an edge of three faces any may be the nearest.
        self.check_few_differ(corners, faces, ["--eye", "3,2.5,5", "--target", "0,0.5,1"], ("surface_lookup", "surface8", "ids"), 0.05)

    def test_lines_have_the_colours_of_the_programs_classes(self):
        file = self.folder / "classes.png"
        inkbench("draw", "blocks", "--views", "2", "--view", "view0", "--method", "surface_lookup", "--layer", "classes",
                 "--size", SIZE_WORD, "-o", file)
        ours = numpy.asarray(Image.open(file).convert("RGB"))
        own = {name: tuple(bytes.fromhex(each["picture"][1:])) for name, each in CLASSES.items()}
        self.open_live()
        self.script("choose({hasFill: false, size: arguments[0]}); frame.style.width = `${arguments[0][0]}px`", SIZE)

        def counts(method, **choices):
            """Pixels of each class in the page, of these those of that class in the program."""
            self.script("choose({left: arguments[0], right: 'ids', cut: 1, ...arguments[1]})", method, choices)
            self.settle()
            seen, found = self.picture(), {}
            for name, each in CLASSES.items():
                is_class = numpy.abs(seen - [*bytes.fromhex(each["over"][1:])]).sum(axis=2) < 60
                is_class[:45], is_class[:, -20:] = False, False  # labels, divider
                found[name] = int(is_class.sum()), int((is_class & (ours == own[name]).all(axis=2)).sum())
            return found

        for method, width_px in (("chords", 2), ("strokes", 2), ("surface_lookup", 1)):  # ink a pixel wide is seldom whole
            found = counts(method, hasClasses=True, lineWidthPx=width_px)
            for name in ("contour", "crease", "intersection"):
                seen, equal = found[name]
                self.assertGreater(seen, 40, f"{method}: {name}")
                self.assertGreater(equal, 0.75 * seen, f"{method}: {name}")  # the pen is wider
            self.assertEqual([found[name][0] for name in ("boundary", "seam")], [0, 0], method)
            self.assertEqual(self.find("#exact").text.split(), ["Classes:", *CLASSES])
            self.assertEqual(sum(seen for seen, _ in counts(method, hasClasses=False).values()), 0, method)
        self.assertEqual(sum(seen for seen, _ in counts("surface8", hasClasses=True).values()), 0)

    def test_lines_go_on_for_pixels_where_no_sample_tells_of_them(self):
        self.open_model("bars", "--no-truth")
        ours = self.drawn_by_program("bars", "strokes", "--view", "three_quarter").astype(int)
        theirs = self.ink_of("strokes", "three_quarter").astype(int)
        self.assertGreater((ours > 0).sum(), 2000)
        # SwiftShader's samples meet other parts of the bars; half of the ink, if lines end with the pixel.
        self.assertTrue(0.85 < theirs.sum() / ours.sum() < 1.1, theirs.sum() / ours.sum())

    def test_an_edge_of_many_faces_that_is_flat_is_no_line(self):
        # Two boxes that touch: above the wall between them are two faces that are flat, and the wall's two.
        corners = [(x, y, z) for x in (0, 1, 2) for y in (0, 1) for z in (0, 1)]
        sides = [(1, 2, 4, 3), (5, 6, 8, 7), (1, 2, 6, 5), (3, 4, 8, 7), (1, 3, 7, 5), (2, 4, 8, 6)]
        faces = [[i + 4 * box for i in side] for box in (0, 1) for side in sides]
        eye = ["--eye", "3.1,2.7,4.3", "--target", "1,0.5,0.5"]
        self.check_few_differ(corners, faces, eye, ("surface_lookup", "chords"), 0.1)  # the edge is a quarter of the lines

    def test_an_edge_of_many_faces_with_a_fin_that_no_sample_sees_is_a_line(self):
        # Two squares that are flat, and where they meet a fin of a fifth of a pixel.
        corners = [(x, y, z) for x, y in ((-1, 0), (0, 0), (1, 0), (0, 0.003)) for z in (0, 2)]
        faces, eye = [(1, 2, 4, 3), (3, 4, 6, 5), (3, 4, 8, 7)], ["--eye", "0.4,3.7,4.3", "--target", "0,0,1"]
        self.check_few_differ(corners, faces, eye, ("surface_lookup", "chords"), 0.1)  # the edge is a sixth of the lines

    def test_lines_follow_a_model_that_moves(self):
        corners = [[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        sides = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]
        glb, file = Glb(), self.folder / "bent.glb"
        bend = glb.accessor(numpy.array([[0.5 * y, 0.7 * y, 0] for _, y, _ in corners], "f4"))
        glb.put("meshes", {"weights": [0], "primitives": [
            {"attributes": {"POSITION": glb.accessor(numpy.array(corners, "f4"))}, "indices": glb.accessor(numpy.array(sides, "u4")),
             "targets": [{"POSITION": bend}]}]})
        glb.put("nodes", {"mesh": 0})
        times = glb.accessor(numpy.array([0, 1], "f4"))
        glb.put("animations", {"samplers": [{"input": times, "output": times}],
                               "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]})
        glb.write(file, scenes=[{"nodes": [0]}])
        eye = ["--eye", "2.5,2,4", "--target", "0.6,0.8,0.5"]
        view = self.open_model(file, *eye)
        rest = self.ink_of("chords", view)
        self.script("inkbench.pose(0.6)")  # between two poses
        for method in ("chords", "strokes", "surface_lookup", "surface8", "ids"):
            ours = self.drawn_by_program(file, method, *eye, "--time", "0.6").astype(int)
            theirs = self.ink_of(method, view)
            has_ink = (ours > 0) | (theirs > 0)
            self.assertLess(numpy.abs(ours - theirs)[has_ink].mean(), MOST_APART if method in INK else 255 / 10, method)
        self.assertGreater((rest != self.ink_of("chords", view)).sum(), 300)
        self.script("[...document.querySelectorAll('#controls button')].find(b => b.textContent === 'Play').click()")
        self.wait(lambda: self.script("return state.isPlaying && state.time > 0.7"))
        self.wait_for_lines()
        self.script("[...document.querySelectorAll('#controls button')].find(b => b.textContent === 'Play').click()")
        self.settle()
        paused = self.script("return state.time")
        self.settle()
        self.assertEqual(self.script("return state.time"), paused)

    def test_the_divider_moves_by_keys_and_pointer(self):
        self.open_live()
        divider = self.find(".divider")
        divider.send_keys(Keys.HOME)
        self.assertEqual(self.script("return state.cut"), 0)
        divider.send_keys(Keys.END, Keys.ARROW_LEFT)
        self.assertAlmostEqual(self.script("return state.cut"), 0.98)
        divider.send_keys(Keys.HOME, *[Keys.PAGE_UP] * 5)
        self.settle()  # it stands where it was until the next frame
        width = self.find("canvas").size["width"]
        webdriver.ActionChains(self.browser).drag_and_drop_by_offset(divider, -round(0.25 * width), 0).perform()
        self.assertAlmostEqual(self.script("return state.cut"), 0.25, delta=0.02)
        self.settle()

    def test_pointer_wheel_and_keys_turn_move_and_zoom(self):
        self.open_live()
        canvas = self.find("canvas")
        self.wait_for_lines()
        before = self.picture()
        cameras = [self.script("return camera.eye")]
        actions = {
            "drag": lambda: webdriver.ActionChains(self.browser).move_to_element_with_offset(canvas, -150, 40)
            .click_and_hold().move_by_offset(60, 20).release().perform(),
            "wheel": lambda: webdriver.ActionChains(self.browser).scroll_from_origin(
                webdriver.common.actions.wheel_input.ScrollOrigin.from_element(canvas), 0, 120).perform(),
            "arrow": lambda: canvas.send_keys(Keys.ARROW_LEFT),
            "plus": lambda: canvas.send_keys("+"),
            "shift": lambda: webdriver.ActionChains(self.browser).key_down(Keys.SHIFT).send_keys(Keys.ARROW_UP)
            .key_up(Keys.SHIFT).perform(),
        }
        for name, act in actions.items():
            act()
            self.settle()
            cameras.append(self.script("return camera.eye"))
            self.assertNotEqual(cameras[-1], cameras[-2], name)
            self.wait_for_lines(name)
        self.assertEqual(self.script("return state.view"), "")
        self.wait(lambda: numpy.abs(self.picture() - before).sum(axis=2).astype(bool).sum() > 1000)
        self.script("choose({view: 'view0'})")
        self.settle()
        self.assertEqual(self.script("return camera.eye"), cameras[0])

    def test_scores_of_the_run_stand_at_its_views(self):
        self.open_live()
        self.script("choose({left: 'surface8', right: 'ids'})")
        self.settle()
        self.assertRegex(self.find(".labels").text, r"surface8 F 0\.\d{3}\s+ids F 0\.\d{3}")
        self.script("choose({left: 'chords'})")
        self.settle()
        self.assertRegex(self.find(".labels").text, r"chords soft F 0\.\d{3}\s+ids F")
        self.script("DATA.scores.view0.ids = {why: 'crowded: 61 % are too dense'}; redraw()")
        self.settle()
        self.assertEqual(self.find("#why").text, "No F at this view. Crowded: 61 % are too dense.")
        self.script("chooseProjection(true)")
        self.settle()
        self.assertNotIn(" F ", self.find(".labels").text)

    def test_measuring_says_by_which_clock(self):
        self.open_live()
        self.script("[...document.querySelectorAll('#methods button')].find(b => b.textContent === 'Measure').click()")
        self.wait(lambda: "Drawn by" in self.find("#times").text)
        self.assertRegex(self.find("#times").text, r"chords [\d.]+ ms, surface_lookup [\d.]+ ms")
        self.assertIn("many frames in a row", self.find("#times").text)  # SwiftShader is no GPU

    # ---- Readers --------------------------------------------------------------------------------

    def test_themes_and_names_of_controls(self):
        for theme in ("light", "dark"):
            self.open_live()
            self.script("choose({theme: arguments[0]}); applyTheme()", theme)
            self.assertEqual(self.script("return document.documentElement.className"), f"{theme}-theme")
            self.assertEqual(faults(self.browser), [], theme)
            self.wait_for_lines(theme)

    def test_a_phone_sees_all_of_it(self):
        with self.window(390):
            for layout in ("two", "all"):
                self.open_live()
                self.script("choose({layout: arguments[0]})", layout)
                self.settle()
                self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), 390)
                self.wait_for_lines(layout)
            self.assertEqual(self.script("return Math.round(canvas.width / 2) * 2 <= 390"), True)


if __name__ == "__main__":
    sys.argv[1:1] = ["-v"]
    unittest.main()
