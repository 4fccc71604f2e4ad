"""Models that `inkbench bake` has made, in the pages of three.js that show how (methods/outside/three): their lines
are those of surface8, of surface_lookup and of chords. Without Chromium, Selenium or three.js it skips."""

import functools
import http.server
import io
import json
import struct
import sys
import threading
import unittest
from pathlib import Path

import adapters

sys.path[:0] = [str(adapters.ROOT / "tests" / "page"), str(adapters.OUTSIDE), str(adapters.OUTSIDE / "webgl")]

import browser  # noqa: E402
import glb  # noqa: E402
import webgl  # noqa: E402

SIZE = "640x360"
LEAST_EQUAL = 0.95  # as SwiftShader draws, see methods/outside/README.md
LEAST_EQUAL_OF_LOOKUP = 0.998  # as Mesa draws, with tables of the pose
LEAST_EQUAL_OF_REST = 0.99  # with those of the model at rest: the program makes its codes of the pose
MOST_APART = 4  # of 255, in the mean over pixels that have ink
SOFTWARE_GL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
MODELS = adapters.ROOT / "inkbench-out" / "models"


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class PageTest(unittest.TestCase):
    """What the tests of both pages do."""

    def inkbench(self, *words):
        done = adapters.run(adapters.PROGRAM, *words)
        self.assertEqual(done.returncode, 0, done.stderr)

    def page_of(self, model, folder):
        """The folder, with the page and all that it loads."""
        self.inkbench("bake", model, "-o", folder / "model.glb")
        self.link(folder, adapters.load_installer().store() / "three-0.160.0", "three")
        for file in ("baked.html", "lookup.html", "lookup.js"):
            self.link(folder, adapters.OUTSIDE / "three" / file)
        for method in ("surface8", "surface_lookup", "chords"):
            self.link(folder, adapters.ROOT / "methods" / method / f"{method}.glsl")
        return folder

    def link(self, folder, file, name=None):
        (folder / (name or file.name)).symlink_to(file)

    def drawn(self, folder, page="baked.html", switches=SOFTWARE_GL, pixel_ratio=1):
        """The picture of a page whose files are in a folder, as an array of greys."""
        import numpy
        from PIL import Image

        handler = functools.partial(Quiet, directory=str(folder))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        driver = browser.open_browser(folder, switches)
        width, height = map(int, SIZE.split("x"))
        try:
            driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                "width": width, "height": height, "deviceScaleFactor": pixel_ratio, "mobile": False})
            driver.get(f"http://127.0.0.1:{server.server_port}/{page}")

            def picture():
                found = driver.find_elements("css selector", "canvas")
                return found and numpy.asarray(Image.open(io.BytesIO(found[0].screenshot_as_png)).convert("L"))

            def has_lines(_):
                grey = picture()
                return grey is not False and len(grey) > 0 and (grey < 99).sum() > 500

            try:
                browser.WebDriverWait(driver, 60).until(has_lines)
            except Exception as error:
                raise AssertionError(driver.get_log("browser")) from error
            return picture()
        finally:
            driver.quit()
            server.shutdown()
            server.server_close()


class BakedTest(PageTest):
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

    gltf, data = glb.read_chunks(model)
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


class LookupTest(PageTest):
    def lines(self, model, method, time_s=None, has_tables_of_rest=False):
        """Ink of a method at a model's first camera, 0..255: as the program draws it, and as the page does."""
        import numpy
        from PIL import Image

        with adapters.scratch() as name:
            folder = self.page_of(model, Path(name))
            time = [] if time_s is None else ["--time", time_s]
            self.bake_tables(folder, *([] if has_tables_of_rest else time))
            width = ["--set", "width_px=1.5"] if method == "chords" else []
            self.inkbench("draw", model, "--views", "file", *time, *width, "--method", method, "--response",
                          "--size", SIZE, "-o", folder / "ours.png")
            text = (folder / "lookup.html").read_text()
            white = "renderer.render(scene, camera), renderer.setClearColor(0xffffff), renderer.clear()"
            for old, new in {"'chords';": f"'{method}';", "renderer.render(scene, camera)": white,
                             "ms / 1000": str(time_s)}.items():
                self.assertIn(old, text)
                text = text.replace(old, new)
            (folder / "lines.html").write_text(text)
            return (numpy.asarray(Image.open(folder / "ours.png").convert("L")).astype(int),
                    255 - self.drawn(folder, "lines.html", webgl.MESA_GL).astype(int))

    def bake_tables(self, folder, *words):
        self.inkbench("bake", folder / "model.glb", "--codes", "surface_lookup", *words, "-o", folder / "model.lookup")

    def equal(self, *words):
        ours, theirs = self.lines(*words)
        self.assertEqual(theirs.shape, ours.shape)
        return 1 - ((ours > 127) != (theirs > 127)).sum() / (2 * (ours > 127).sum())

    def check(self, what, model, time_s=None):
        equal = self.equal(model, "surface_lookup", time_s)
        ours, theirs = self.lines(model, "chords", time_s)
        apart = abs(ours - theirs)[(ours > 0) | (theirs > 0)].mean()
        print(f"{what}: {equal:.4f} of line pixels; ink {apart:.2f} of 255 apart", flush=True)
        self.assertGreaterEqual(equal, LEAST_EQUAL_OF_LOOKUP, what)
        self.assertLessEqual(apart, MOST_APART, what)

    def test_lines_are_those_of_the_methods(self):
        for scene in ("blocks", "torus", "gear"):
            with adapters.scratch() as name:
                adapters.export_view(scene, SIZE, Path(name))
                self.check(scene, next(Path(name).rglob("mesh.glb")))

    def test_pixels_are_those_of_the_screen(self):
        with adapters.scratch() as name:
            adapters.export_view("torus", SIZE, Path(name))
            folder = self.page_of(next(Path(name).rglob("mesh.glb")), Path(name))
            self.bake_tables(folder)
            self.assertEqual(self.drawn(folder, "lookup.html", webgl.MESA_GL, 2).shape, (720, 1280))

    def test_lines_follow_bones(self):
        if not (MODELS / "bull.glb").exists():
            self.skipTest("experiments/models/fetch bull gets the model")
        with adapters.scratch() as name:
            model = Path(name) / "bull.glb"
            with_camera(MODELS / "bull.glb", (2.6, 2.2, 3.6), (0, 0.75, 0), model)
            for time_s in (0.1, 0.3, 0.5):
                self.check(f"bull at {time_s} s", model, time_s)
                of_rest = self.equal(model, "surface_lookup", time_s, True)
                print(f"with tables of the model at rest {of_rest:.4f}", flush=True)
                self.assertGreaterEqual(of_rest, LEAST_EQUAL_OF_REST, time_s)


if __name__ == "__main__":
    adapters.skip_without("three_ids")
    unittest.main(verbosity=2)
