"""A model that `inkbench bake` has made, in the page of three.js that shows how (methods/outside/three/baked.html):
its lines are those of surface8. Without Chromium, Selenium or three.js it skips."""

import functools
import http.server
import io
import sys
import threading
import unittest
from pathlib import Path

import adapters

sys.path.insert(0, str(adapters.ROOT / "tests" / "page"))

import browser  # noqa: E402

SIZE = "640x360"
LEAST_EQUAL = 0.95  # as SwiftShader draws, see methods/outside/README.md


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class BakedTest(unittest.TestCase):
    def inkbench(self, *words):
        done = adapters.run(adapters.PROGRAM, *words)
        self.assertEqual(done.returncode, 0, done.stderr)

    def page_of(self, model, folder):
        """The folder, with the page and all that it loads."""
        self.inkbench("bake", model, "-o", folder / "model.glb")
        (folder / "three").symlink_to(adapters.load_installer().store() / "three-0.160.0")
        (folder / "baked.html").symlink_to(adapters.OUTSIDE / "three" / "baked.html")
        (folder / "surface8.glsl").symlink_to(adapters.ROOT / "methods" / "surface8" / "surface8.glsl")
        return folder

    def drawn(self, folder):
        """The picture of the page whose files are in a folder, as an array of greys."""
        import numpy
        from PIL import Image

        handler = functools.partial(Quiet, directory=str(folder))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        driver = browser.open_browser(folder, ("--use-angle=swiftshader", "--enable-unsafe-swiftshader"))
        try:
            driver.get(f"http://127.0.0.1:{server.server_port}/baked.html")

            def picture():
                found = driver.find_elements("css selector", "canvas")
                return found and numpy.asarray(Image.open(io.BytesIO(found[0].screenshot_as_png)).convert("L"))

            def has_lines(_):
                grey = picture()
                return grey is not False and len(grey) > 0 and (grey < 30).sum() > 500

            try:
                browser.WebDriverWait(driver, 60).until(has_lines)
            except Exception as error:
                raise AssertionError(driver.get_log("browser")) from error
            return picture()
        finally:
            driver.quit()
            server.shutdown()
            server.server_close()

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
        models = [adapters.ROOT / "inkbench-out" / "models" / f"{name}.glb" for name in ("dancer", "house", "engine")]
        there = [model for model in models if model.exists()]
        if not there:
            self.skipTest("experiments/models/fetch dancer house engine gets the models")
        for model in there:
            with adapters.scratch() as name:
                folder = self.page_of(model, Path(name))
                self.assertGreater((self.drawn(folder) < 30).sum(), 500, model)


if __name__ == "__main__":
    adapters.skip_without("three_ids")
    unittest.main(verbosity=2)
