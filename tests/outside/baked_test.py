"""Models that `inkbench bake` has made, in the pages that show how (methods/outside/three, .../babylon): their lines
are those of surface8, of surface_lookup, chords and strokes. Without Chromium, Selenium or three.js it skips."""

import functools
import http.server
import io
import json
import struct
import sys
import threading
import unittest
from pathlib import Path
from typing import NamedTuple

import adapters

sys.path[:0] = [str(adapters.ROOT / "tests" / "page"), str(adapters.OUTSIDE / "webgl")]

import browser  # noqa: E402
import webgl  # noqa: E402

SIZE = "640x360"
SCREEN = (640, 360, 1)  # the same: width, height, pixel ratio
LEAST_EQUAL = 0.95  # as SwiftShader draws, see methods/outside/README.md
LEAST_EQUAL_OF_LOOKUP = 0.998  # as Mesa draws, with tables of the pose
LEAST_EQUAL_OF_REST = 0.99  # with those of the model at rest: the program makes its codes of the pose
INK = ("chords", "strokes")
MOST_APART = 4  # of 255, in the mean over pixels that have ink
SOFTWARE_GL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
MODELS = adapters.ROOT / "inkbench-out" / "models"


class Engine(NamedTuple):
    installed_for: str  # what methods/outside/install takes
    packages: dict  # folders that it has installed, by the names that the page gives them
    changed: tuple  # of the page: its clock in seconds, and what draws the picture; what draws the background alone


ENGINES = {
    "three": Engine("three_ids", {"three": "three-0.160.0"}, (
        "ms / 1000", "renderer.render(scene, camera)",
        "renderer.render(scene, camera), renderer.setClearColor(0xffffff), renderer.clear()")),
    "babylon": Engine("babylon", {name: f"{name}-9.28.0" for name in ("babylonjs", "babylonjs-loaders")}, (
        "performance.now() / 1000", "scene.render()", "scene.render(), engine.clear(scene.clearColor, true, true)")),
}


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class PageTest(browser.BrowserTest):
    """What the tests of all pages do."""

    harmless = ("favicon.ico", "GPU stall due to ReadPixels")

    @classmethod
    def make_runs(cls):
        """They make a folder for each page."""

    def inkbench(self, *words):
        done = adapters.run(adapters.PROGRAM, *words)
        self.assertEqual(done.returncode, 0, done.stderr)

    def page_of(self, model, folder):
        """The folder, with the page and all that it loads."""
        self.inkbench("bake", model, "-o", folder / "model.glb")
        for engine, (_, packages, _) in ENGINES.items():
            self.link(folder, adapters.OUTSIDE / engine / "lookup.html", f"{engine}.html")
            for name, installed in packages.items():
                self.link(folder, adapters.load_installer().store() / installed, name)
        for file in ("three/baked.html", "webgl/lookup.js", "webgl/pose.glsl"):
            self.link(folder, adapters.OUTSIDE / file)
        for method in ("surface8", "surface_lookup", "chords", "strokes"):
            self.link(folder, adapters.ROOT / "methods" / method / f"{method}.glsl")
        return folder

    def link(self, folder, file, name=None):
        (folder / (name or file.name)).symlink_to(file)

    def drawn(self, folder, page="baked.html", screens=(SCREEN,), read=""):
        """The picture of a page whose files are in a folder, as an array of greys: of the last of the screens that
        its window has in turn. Or what a script reads there."""
        handler = functools.partial(Quiet, directory=str(folder))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            for screen in screens:
                width, height, ratio = screen
                self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                    "width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False})
                if screen == screens[0]:
                    self.browser.get(f"http://127.0.0.1:{server.server_port}/{page}")
                grey = self.settled((height * ratio, width * ratio))
            return self.script(read) if read else grey
        finally:
            self.browser.get("about:blank")
            server.shutdown()
            server.server_close()

    def settled(self, shape):
        """The picture of this shape that a page shows once it has lines and no longer changes."""
        import numpy
        from PIL import Image

        def picture():
            found = self.find_all("canvas")
            image = Image.open(io.BytesIO(found[0].screenshot_as_png)) if found else Image.new("L", (1, 1))
            return numpy.asarray(image.convert("L"))

        def with_lines():
            grey = picture()
            is_done = grey.shape == shape and (grey < 99).sum() > 500 and numpy.array_equal(grey, picture())
            return [grey] if is_done else []

        try:
            return self.wait(with_lines)[0]
        except browser.TimeoutException as error:
            raise AssertionError(self.browser.get_log("browser")) from error


class BakedTest(PageTest):
    switches = SOFTWARE_GL

    def test_lines_are_those_of_surface8(self):
        import numpy
        from PIL import Image

        for scene in ("blocks", "torus"):
            with adapters.scratch() as name:
                folder = Path(name)
                adapters.export_view(scene, SIZE, folder)
                self.inkbench("draw", scene, "--views", "1", "--method", "surface8", "--response", "--size", SIZE,
                              "-o", folder / "ours.png")
                self.page_of(next(folder.rglob("mesh.glb")), folder)
                theirs = self.drawn(folder) < 30
                ours = numpy.asarray(Image.open(folder / "ours.png").convert("L")) >= 128
            self.assertEqual(theirs.shape, ours.shape)
            equal = 1 - (theirs != ours).sum() / (2 * ours.sum())
            print(f"{scene}: {equal:.4f} of {ours.sum()} line pixels", flush=True)
            self.assertGreater(equal, LEAST_EQUAL)

    def test_a_character_a_building_and_a_part_have_lines(self):
        models = [MODELS / f"{name}.glb" for name in ("dancer", "house", "engine")]
        there = [model for model in models if model.exists()]
        if not there:
            self.skipTest("experiments/models/fetch dancer house engine gets the models")
        for model in there:
            with adapters.scratch() as name:
                folder = self.page_of(model, Path(name))
                self.assertGreater((self.drawn(folder) < 30).sum(), 500, model)


def with_camera(model, eye, target, file):
    """Writes a GLB again with a camera that looks from one place at another, y up."""
    import numpy

    gltf, data = adapters.read_glb(model)
    back = numpy.subtract(eye, target) / numpy.linalg.norm(numpy.subtract(eye, target))
    right = numpy.cross([0, 1, 0], back) / numpy.linalg.norm(numpy.cross([0, 1, 0], back))
    columns = [[*right, 0], [*numpy.cross(back, right), 0], [*back, 0], [*eye, 1]]
    gltf.setdefault("cameras", []).append(
        {"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01, "aspectRatio": 16 / 9}})
    gltf["nodes"].append({"camera": len(gltf["cameras"]) - 1, "matrix": numpy.ravel(columns).tolist()})
    gltf["scenes"][gltf.get("scene", 0)]["nodes"].append(len(gltf["nodes"]) - 1)
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    file.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def equal_share(ours, theirs):
    """Of the pixels that have a line."""
    return 1 - ((ours > 127) != (theirs > 127)).sum() / (2 * (ours > 127).sum())


# How many words of the faces, as the page has posed them, are others than those of the tables; of how many.
OTHER_WORDS = """
    const {gl, posed: {faces: {frame, width, height}}, faceCount} = lines, posed = new Uint32Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, posed);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return [posed.subarray(0, 8 * faceCount).filter((word, i) => word !== words[3 + i]).length, 8 * faceCount];
"""


class LookupTest(PageTest):
    switches = tuple(webgl.MESA_GL)

    def inks(self, method, model, time_s=None, screens=(SCREEN,), has_tables_of_rest=False):
        """Ink of a method at a model's first camera, 0..255: as the program draws it, and by engine as the
        page does in a window that has these screens in turn."""
        import numpy
        from PIL import Image

        with adapters.scratch() as name:
            folder = self.page_of(model, Path(name))
            words = [] if time_s is None else ["--time", time_s]
            self.bake_tables(folder, *([] if has_tables_of_rest else words))
            width, height, ratio = screens[-1]
            width_px = ["--set", f"width_px={1.5 * ratio}"] if method in INK else []
            self.inkbench("draw", model, "--views", "file", *words, *width_px, "--method", method, "--response",
                          "--size", f"{width * ratio}x{height * ratio}", "-o", folder / "ours.png")
            ours = numpy.asarray(Image.open(folder / "ours.png").convert("L")).astype(int)
            return ours, self.inks_of_pages(folder, method, time_s, screens)

    def inks_of_pages(self, folder, method, time_s, screens=(SCREEN,)):
        """By engine; those that are not installed are left out."""
        inks = {}
        for engine in self.engines():
            page = self.page_of_lines(engine, method, time_s, folder)
            inks[engine] = 255 - self.drawn(folder, page, screens).astype(int)
        return inks

    def engines(self):
        return [name for name, engine in ENGINES.items() if not adapters.missing_packages(engine.installed_for)]

    def page_of_lines(self, engine, method, time_s, folder):
        """The page of an engine, changed to draw the lines of a method alone, at one moment."""
        text = (folder / f"{engine}.html").read_text()
        clock, render, lines_alone = ENGINES[engine].changed
        for old, new in {"'chords';": f"'{method}';", render: lines_alone, clock: str(time_s)}.items():
            self.assertIn(old, text)
            text = text.replace(old, new)
        (folder / f"{engine}_lines.html").write_text(text)
        return f"{engine}_lines.html"

    def bake_tables(self, folder, *words):
        self.inkbench("bake", folder / "model.glb", "--codes", "surface_lookup", *words, "-o", folder / "model.lookup")

    def check_lines(self, what, least, *view, **options):
        ours, theirs = self.inks("surface_lookup", *view, **options)
        for engine, lines in theirs.items():
            equal = equal_share(ours, lines)
            print(f"{what} in {engine}: {equal:.4f} of line pixels", flush=True)
            self.assertGreaterEqual(equal, least, f"{what} in {engine}")

    def check(self, what, *view, **options):
        """The methods, at what `inks` takes."""
        self.check_lines(what, LEAST_EQUAL_OF_LOOKUP, *view, **options)
        for method in INK:
            ours, theirs = self.inks(method, *view, **options)
            for engine, ink in theirs.items():
                apart = abs(ours - ink)[(ours > 0) | (ink > 0)].mean()
                print(f"{what} in {engine}: ink of {method} {apart:.2f} of 255 apart", flush=True)
                self.assertLessEqual(apart, MOST_APART, f"{what} in {engine}")

    def test_lines_are_those_of_the_methods(self):
        for scene in ("blocks", "torus", "gear"):
            with adapters.scratch() as name:
                adapters.export_view(scene, SIZE, Path(name))
                self.check(scene, next(Path(name).rglob("mesh.glb")))

    def test_lines_follow_the_window(self):
        with adapters.scratch() as name:
            adapters.export_view("torus", SIZE, Path(name))
            self.check("torus in another window", next(Path(name).rglob("mesh.glb")),
                       screens=((400, 200, 1), (260, 160, 2)))

    def test_lines_follow_bones(self):
        self.check_moments("bull", ((2.6, 2.2, 3.6), (0, 0.75, 0)), (0.1, 0.3, 0.5))

    def test_lines_follow_morphs(self):
        self.check_moments("morph_cube", ((2.6, 2.9, 3.6), (0, 0.75, 0)), (0.5, 1.5))

    def test_a_model_without_a_camera_is_seen_whole(self):
        if not (MODELS / "bull.glb").exists():
            self.skipTest("experiments/models/fetch bull gets the model")
        with adapters.scratch() as name:
            folder = self.page_of(MODELS / "bull.glb", Path(name))
            self.bake_tables(folder)
            first, *others = self.inks_of_pages(folder, "surface_lookup", 0.5).values()
            self.assertFalse(first[[0, -1]].any() or first[:, [0, -1]].any())
            for ink in others:  # from the same place
                self.assertGreaterEqual(equal_share(first, ink), LEAST_EQUAL_OF_LOOKUP)

    def test_faces_of_a_pose_are_those_of_its_tables(self):
        if not (MODELS / "bull.glb").exists():
            self.skipTest("experiments/models/fetch bull gets the model")
        with adapters.scratch() as name:
            folder = self.page_of(MODELS / "bull.glb", Path(name))
            self.bake_tables(folder, "--time", 0.3)
            for engine in self.engines():
                page = folder / self.page_of_lines(engine, "surface_lookup", 0.3, folder)
                page.write_text(page.read_text().replace("lines.draw(", "Object.assign(window, {lines, words}).lines.draw("))
                others, count = self.drawn(folder, page.name, read=OTHER_WORDS)
                self.assertGreater(count, 20_000)
                self.assertEqual(others, 0, engine)

    def check_moments(self, name, eye_and_target, times_s):
        found = [model for ending in ("glb", "gltf") if (model := MODELS / f"{name}.{ending}").exists()]
        if not found:
            self.skipTest(f"experiments/models/fetch {name} gets the model")
        with adapters.scratch() as folder:
            model = Path(folder) / f"{name}.glb"
            self.inkbench("bake", found[0], "-o", model)
            with_camera(model, *eye_and_target, model)
            for time_s in times_s:
                self.check(f"{name} at {time_s} s", model, time_s)
            self.check_lines(f"{name} at {times_s[1]} s with tables of rest", LEAST_EQUAL_OF_REST, model, times_s[1],
                             has_tables_of_rest=True)


if __name__ == "__main__":
    adapters.skip_without("three_ids")
    unittest.main(verbosity=2)
