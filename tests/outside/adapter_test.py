"""One adapter of methods/outside, whose name is the first word: its camera, its lines, its errors.

Where its engine is not installed, the exit code is 77 and the last line says what is missing.
"""

import json
import os
import re
import sys
import unittest

import adapters

NAME = sys.argv.pop(1)

# F of cube, torus and blocks, less .02 to .05: what the engine draws without a fault in between. The
# depth edges of three.js are no better on these.
FLOORS = {
    "blender_line_art": (0.98, 0.98, 0.98),
    "three_outline": (0.70, 0.58, 0.80),
    "three_ids": (0.97, 0.85, 0.97),
    "webgl_surface8": (0.98, 0.96, 0.98),
    "webgl_surface8_depth": (0.98, 0.98, 0.98),
    "webgl_label8": (0.98, 0.87, 0.98),
    "webgl_ids": (0.98, 0.87, 0.98),
    "webgl_roberts": (0.98, 0.98, 0.98),
    "webgl_decaudin": (0.84, 0.97, 0.94),
    "webgl_mote4": (0.95, 0.98, 0.97),
    "webgl_inverted_hull": (0.85, 0.97, 0.73),
}
MASK_SCENE = "blocks"
MASK_SIZE = "640x360"
LINES_SIZE = "1280x720"
# Of the methods at default parameters; 128 for what is not here.
THRESHOLDS = {"roberts": 74, "decaudin": 146, "mote4": 6}


def grown(mask):
    """The mask, and all pixels beside it."""
    import numpy

    padded = numpy.pad(mask, 1)
    height, width = mask.shape
    return numpy.any([padded[y:y + height, x:x + width] for y in range(3) for x in range(3)], axis=0)


class AdapterTest(unittest.TestCase):
    def test_objects_cover_the_pixels_of_the_exported_ids(self):
        import numpy
        from PIL import Image

        with adapters.scratch() as folder:
            view = adapters.export_view(MASK_SCENE, MASK_SIZE, folder)
            out = view.parent / "mask.png"
            done = adapters.run(adapters.adapter(NAME), view, out, "--mask")
            self.assertEqual(done.returncode, 0, done.stderr)
            theirs = numpy.asarray(Image.open(out)) >= 128
            ids = view.parent / json.loads(view.read_text())["files"]["ids"]
            ours = numpy.asarray(Image.open(ids)).max(axis=2) > 0
        self.assertGreater(ours.sum(), 10000)
        self.assertGreaterEqual((ours & theirs).sum() / (ours | theirs).sum(), 0.995)
        far = (theirs & ~grown(ours)) | (~theirs & ~grown(~ours))
        self.assertEqual(far.sum(), 0, "pixels more than one from the silhouette differ")

    def test_it_takes_part_and_draws_what_its_engine_can(self):
        done = adapters.run(adapters.PROGRAM, "entrant-test", adapters.adapter(NAME),
                            "--entrant-seconds", "300")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = [float(f) for f in re.findall(r": F ([0-9.]+), [0-9.]+ ms", done.stdout)]
        print(f"{NAME}: F {found}", flush=True)
        self.assertEqual(len(found), 3, done.stdout)
        for f, floor in zip(found, FLOORS[NAME]):
            self.assertGreaterEqual(f, floor, done.stdout)

    @unittest.skipUnless(NAME.startswith("webgl_"), "it draws a method of the program's")
    def test_its_lines_are_those_of_the_method(self):
        import numpy
        from PIL import Image

        method = NAME.removeprefix("webgl_")
        for scene in ("torus", "blocks", "rocket", "gear", "room", "bars"):  # whose edges run through samples
            with adapters.scratch() as folder:
                view = adapters.export_view(scene, LINES_SIZE, folder)
                images = []
                for words in ((adapters.PROGRAM, "draw", scene, "--views", "1", "--method", method, "--response", "--size",
                               LINES_SIZE, "-o"), (adapters.adapter(NAME), view)):
                    done = adapters.run(*words, view.parent / "lines.png")
                    self.assertEqual(done.returncode, 0, done.stderr)
                    images.append(numpy.asarray(Image.open(view.parent / "lines.png").convert("L")))
            ours, theirs = images[0] >= THRESHOLDS.get(method, 128), images[1] > 0
            equal = 1 - (ours != theirs).sum() / (2 * ours.sum())
            self.assertGreaterEqual(equal, 0.995, scene)

    def test_it_says_how_long_its_engine_took(self):
        with adapters.scratch() as folder:
            view = adapters.export_view("cube", "160x90", folder)
            done = adapters.run(adapters.adapter(NAME), view, view.parent / "out.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^draw_ms [0-9.]+$")
        self.assertGreater(float(done.stdout.split()[1]), 0)

    def test_a_view_that_cannot_be_read_is_bad_input(self):
        done = adapters.run(adapters.adapter(NAME), "nowhere.json", "out.png")
        self.assertEqual(done.returncode, 2)
        self.assertIn("nowhere.json", done.stderr)

    def test_a_missing_engine_is_a_sentence(self):
        with adapters.scratch() as folder:
            view = adapters.export_view("cube", "160x90", folder)
            empty = {**os.environ, "PATH": folder, "XDG_CACHE_HOME": folder}
            done = adapters.run(adapters.adapter(NAME), view, view.parent / "out.png", env=empty)
        self.assertEqual(done.returncode, 3)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(f"methods/outside/install {NAME}", done.stderr)


if __name__ == "__main__":
    adapters.skip_without(NAME)
    unittest.main(verbosity=2)
