"""Cameras, buffers and methods that are functions: what Python gets is what the program has of them."""

import contextlib
import csv
import io
import re
import sys
import tempfile
import time
import unittest
from fractions import Fraction
from pathlib import Path

from program import SIZE, SOURCE, read_gray, run, sentence

import inkbench
import numpy as np

sys.path.append(str(SOURCE / "tests/referees"))
from gltf_files import Glb  # noqa: E402

CAMERA = inkbench.Camera((3, 2, 5), (0.1, 0, 0), up=np.array([0, 1, 0.5]), fov_deg=30, size=(320, 180))
AS_OPTIONS = ("--eye", "3,2,5", "--target", "0.1,0,0", "--up", "0,1,0.5", "--fov", "30", "--size", "320x180")


def patch_lines(seen):
    """A line wherever the smooth patch changes."""
    return np.uint8(255) * (np.hypot(*np.gradient(1.0 * seen.patch)) > 0)


def five_lines(page):
    """The first block of Python of a page that imports the module."""
    blocks = re.findall(r"```python\n(.*?)```", (SOURCE / page).read_text(encoding="utf-8"), re.S)
    return next(block for block in blocks if "import inkbench" in block)


class Compare(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def rows_of_program(self, *arguments):
        """The lines of rows.csv of a comparison, as text."""
        out = self.folder / "run"
        run("compare", *arguments, "--no-sweep", "--no-cache", "--quiet", "--images", "none", "--out", out)
        with open(out / "rows.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def keep_image(self, name, scene, view, image):
        """Puts an image where an entrant of this name has it."""
        from PIL import Image

        path = self.folder / name / scene / f"{view}.png"
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(image).save(path)

    def test_the_lines_that_the_guide_shows_give_the_f_of_the_program(self):
        lines = five_lines("experiments/guide.md")
        self.assertEqual(lines.count("\n"), 5)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as told:
            exec(lines, names)  # pylint: disable=exec-used
        told = {name: (f, ns) for name, f, ns in map(str.split, told.getvalue().splitlines())}
        self.assertGreater(int(told["mine"][1]), 0)
        self.keep_image("mine", "gear", "eye0", names["mine"](inkbench.buffers("gear", names["camera"])))
        rows = self.rows_of_program("gear", "--methods", "surface8", "--eye", "3,2,5", "--size", "640x360",
                                    "--entrant", f"mine={self.folder / 'mine'}", "--force")
        self.assertEqual({row["method"]: row["f_2px"] for row in rows}, {name: f for name, (f, _) in told.items()})
        self.assertGreater(float(told["mine"][0]), 0.5)

    def test_a_row_is_that_of_the_program(self):
        path = self.folder / "1.obj"  # a name that is no number
        path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", encoding="utf-8")
        found = inkbench.compare([path, "cube"], {}, CAMERA, methods=["decaudin", "surface8"], times=False, crease_deg=50,
                                 settings={"surface8": {"turn_deg": 5}})
        told = self.rows_of_program(f"{path},cube", "--methods", "decaudin,surface8", "--crease", "50", *AS_OPTIONS,
                                    "--set", "surface8.turn_deg=5")
        self.assertEqual(len(found), len(told))
        as_text = {None: "", True: "true", False: "false"}
        is_time = re.compile(r"_ns|draw_n$|time_doubt")
        for row, line in zip(found, told):
            self.assertEqual(list(row), list(line))
            for column, value in row.items():
                if is_time.search(column):
                    self.assertIsNone(value, column)
                elif isinstance(value, (int, float)) and not isinstance(value, bool):
                    self.assertEqual(value, float(line[column]), column)
                else:
                    self.assertEqual(as_text.get(value, value), line[column], column)
        self.assertEqual({row["scene"] for row in found}, {"1", "cube"})

    def test_truth_and_drawing_are_those_of_the_camera(self):
        run("truth", "gear", *AS_OPTIONS, "--time", "0.25", "-q", "--no-cache", "-o", self.folder / "t.png")
        np.testing.assert_array_equal(
            inkbench.truth("gear", CAMERA, time_s=0.25, intersections="all").labels, read_gray(self.folder / "t.png"))
        run("draw", "gear", *AS_OPTIONS, "--method", "mote4", "--response", "-o", self.folder / "d.png")
        edges = inkbench.draw("mote4", "gear", CAMERA)
        np.testing.assert_array_equal(edges, read_gray(self.folder / "d.png"))
        turned = inkbench.draw("mote4", "gear", CAMERA, time_s=0.25)
        self.assertTrue((edges != turned).any())
        self.assertRaises(inkbench.Error, inkbench.Camera, (3, 2, 5), up=["here"])
        inkbench.Camera((3, 2, 5), up=["x"])  # an axis by name
        for quarter in (Fraction(1, 4), np.float32(0.25)):  # numbers are passed as such, whatever they print
            np.testing.assert_array_equal(inkbench.draw("mote4", "gear", CAMERA, time_s=quarter), turned)

    def test_parallel_cameras_are_those_of_the_program(self):
        camera = inkbench.Camera((3, 2, 5), parallel_height=2.5, size=(320, 180))
        run("draw", "gear", "--eye", "3,2,5", "--parallel", "2.5", "--size", "320x180", "--method", "ids", "--response",
            "-o", self.folder / "d.png")
        np.testing.assert_array_equal(inkbench.draw("ids", "gear", camera), read_gray(self.folder / "d.png"))
        found = inkbench.compare("cube", {}, projection=("perspective", "parallel"), views=1, methods="ids",
                                 times=False, **SIZE)
        self.assertEqual({(row["view"], row["projection"]) for row in found},
                         {("view0", "perspective"), ("view0.parallel", "parallel")})

    def test_buffers_are_those_that_export_writes(self):
        from PIL import Image

        run("export", "blocks", "--size", "320x180", "--truth", "none", "-o", self.folder / "out")
        seen = inkbench.buffers("blocks", **SIZE)
        folder = self.folder / "out" / "blocks" / seen.view["view"]
        rgb = np.asarray(Image.open(folder / "ids.png")).astype(np.uint32)
        np.testing.assert_array_equal(seen.object + np.uint32(1), rgb @ np.array([1, 256, 65536], np.uint32))
        sky = seen.object == 2**32 - 1
        self.assertTrue(sky.any() and not sky.all())
        np.testing.assert_array_equal(np.isinf(seen.depth), sky)
        np.testing.assert_allclose(np.linalg.norm(seen.normal, axis=2), np.where(sky, 0, 1), atol=1e-6)
        for ids in (seen.patch, seen.triangle, seen.material):
            self.assertEqual((ids.dtype, ids.shape), (np.uint32, (180, 320)))
            np.testing.assert_array_equal(ids == 2**32 - 1, sky)
        self.assertGreater(len(np.unique(seen.triangle)), len(np.unique(seen.patch)))

    def test_layers_hold_the_codes(self):
        for method, planes, bits in (("surface8", 1, 8), ("two_sums", 2, 8), ("mote16", 1, 16)):
            layers = inkbench.layers(method, "chess", **SIZE)
            codes = layers.get("codes", layers.get("packed"))
            self.assertEqual((codes.dtype, codes.shape), (np.uint16, (180, 320, planes)), method)
            self.assertEqual(codes.max() > 255, bits == 16, method)
        run("draw", "chess", "--method", "surface8", "--size", "320x180", "--layer", "codes", "-o", self.folder / "c.png")
        np.testing.assert_array_equal(inkbench.layers("surface8", "chess", **SIZE)["codes"][..., 0],
                                      read_gray(self.folder / "c.png")[..., 0])
        self.assertEqual(inkbench.layers("roberts", "cube", **SIZE)["normal"].shape, (180, 320, 3))

    def test_a_function_draws_every_view_once_and_its_time_is_the_call(self):
        views = []

        def slow(seen):
            views.append(seen.view["view"])
            time.sleep(0.02)
            return patch_lines(seen)

        rows = [row for row in inkbench.compare("torus", {"slow": slow}, **SIZE) if row["method"] == "slow"]
        self.assertEqual(views, [row["view"] for row in rows])
        self.assertEqual(len(views), 3)
        for row in rows:
            self.assertEqual((row["clock"], row["draw_n"], row["status"]), ("own", 1, "ok"))
            self.assertTrue(20e6 <= row["draw_ns"] < 200e6, row["draw_ns"])

    def test_what_a_function_throws_is_the_callers(self):
        def compare(function, **more):
            return inkbench.compare("cube", {"mine": function}, CAMERA, **more)

        with self.assertRaises(ZeroDivisionError):
            compare(lambda seen: 1 // 0)
        with self.assertRaisesRegex(TypeError, r"mine: its values are float32 \(accepted: uint8\)"):
            compare(lambda seen: seen.depth)
        with self.assertRaisesRegex(inkbench.Error, r"mine: its image is 320x3 \(accepted: 320x180, .*\)"):
            compare(lambda seen: patch_lines(seen)[:3])
        for name, function in (("mote4", patch_lines), ("a b", patch_lines), ("mine", 5)):
            with self.assertRaises(inkbench.Error):
                inkbench.compare("cube", {name: function}, CAMERA)
        kept = compare(patch_lines, settings={"mine": {"threshold": 255}})
        self.assertEqual(kept[0]["threshold"], 255)

    def test_refusals_are_one_line_and_that_of_the_program(self):
        for call, arguments in (
                (lambda: inkbench.draw("mote4", "cube", settings={"threshold": 500}),
                 ("draw", "cube", "--method", "mote4", "--set", "threshold=500", "-o", "x.png")),
                (lambda: inkbench.draw("mote4", "cube", settings={"fatten": 3.5}),
                 ("draw", "cube", "--method", "mote4", "--set", "fatten=3.5", "-o", "x.png")),
                (lambda: inkbench.draw("mote4", "cube", settings={"turn": [1]}),
                 ("draw", "cube", "--method", "mote4", "--set", "turn=[1]", "-o", "x.png")),
                (lambda: inkbench.draw("mote4", "cube", size=(0, 5)), ("draw", "cube", "--size", "0x5", "-o", "x.png")),
                (lambda: inkbench.truth("cube", crease_deg=200), ("truth", "cube", "--crease", "200")),
                (lambda: inkbench.truth("cube", threads="two"), ("truth", "cube", "--threads", "two")),
                (lambda: inkbench.truth("cube", threads=True), ("truth", "cube", "--threads", "true")),
                (lambda: inkbench.truth("cube", threads=np.True_), ("truth", "cube", "--threads", "true")),
                (lambda: inkbench.truth("cube", time_s=1), ("truth", "cube", "--time", "1")),
                (lambda: inkbench.truth("cube", seams="here"), ("truth", "cube", "--seams", "here")),
                (lambda: inkbench.buffers("cube", views="file", margin=0.1),
                 ("truth", "cube", "--views", "file", "--margin", "0.1")),
                (lambda: inkbench.Camera((1, 2)), ("truth", "cube", "--eye", "1,2")),
                (lambda: inkbench.Camera((1, 2, 3), up=(0, 0, 0)), ("truth", "cube", "--eye", "1,2,3", "--up", "0,0,0")),
                (lambda: inkbench.Camera((1, 2, 3), parallel_height=0),
                 ("truth", "cube", "--eye", "1,2,3", "--parallel", "0")),
                (lambda: inkbench.truth("cube", projection="flat"), ("truth", "cube", "--projection", "flat")),
                (lambda: inkbench.truth("cube", views="top", up="w"), ("truth", "cube", "--views", "top", "--up", "w")),
                (lambda: inkbench.truth("cube", inkbench.Camera((1, 2, 3), fov_deg=200)),
                 ("truth", "cube", "--eye", "1,2,3", "--fov", "200"))):
            with self.assertRaises(ValueError) as caught:
                call()
            told = sentence(*arguments)
            self.assertEqual(str(caught.exception), told)
            self.assertNotIn("\n", told)
        with self.assertRaisesRegex(inkbench.Error, r"sise: there is no such keyword .*did you mean size\?"):
            inkbench.draw("mote4", "cube", sise=3)
        with self.assertRaisesRegex(inkbench.Error, "the camera has one"):
            inkbench.draw("mote4", "cube", CAMERA, **SIZE)

    def test_seams_and_animation_reach_the_model(self):
        seams = [np.unique(inkbench.truth(self.two_materials(), CAMERA, seams=between).labels)
                 for between in ("objects", "materials")]
        self.assertNotIn(5, seams[0])
        self.assertIn(5, seams[1])
        path = self.moving()
        drawn = {}
        for name in ("rise", "slide"):
            run("draw", path, *AS_OPTIONS, "--animation", name, "--time", "1", "--method", "ids", "--response", "-o",
                self.folder / "d.png")
            drawn[name] = inkbench.draw("ids", path, CAMERA, animation=name, time_s=1)
            np.testing.assert_array_equal(drawn[name], read_gray(self.folder / "d.png"))
        self.assertTrue((drawn["rise"] != drawn["slide"]).any())
        with self.assertRaises(inkbench.Error) as caught:
            inkbench.compare(path, {}, CAMERA, methods="ids", animation="fall")
        self.assertEqual(str(caught.exception), sentence("truth", path, "--animation", "fall"))

    def two_materials(self):
        """A square of two triangles, each of a material of its own."""
        (self.folder / "two.mtl").write_text("newmtl a\nnewmtl b\n", encoding="utf-8")
        path = self.folder / "two.obj"
        path.write_text("mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n",
                        encoding="utf-8")
        return path

    def moving(self):
        """A triangle with two animations, `rise` and `slide`."""
        glb, path = Glb(), self.folder / "moving.glb"
        triangle = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        glb.put("meshes", {"primitives": [{"attributes": {"POSITION": glb.accessor(triangle)}}]})
        glb.put("nodes", {"mesh": 0})
        times = glb.accessor(np.float32([0, 1]))
        for name, end in (("rise", [0, 0.3, 0]), ("slide", [0.3, 0, 0])):
            glb.put("animations", {"name": name, "samplers": [{"input": times, "output": glb.accessor(np.float32([[0, 0, 0], end]))}],
                                   "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]})
        glb.write(path, scenes=[{"nodes": [0]}])
        return path


if __name__ == "__main__":
    unittest.main()
