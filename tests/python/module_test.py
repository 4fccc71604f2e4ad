"""The Python module: the same numbers and images as the program, arrays that own no copy, errors with its sentences."""

import ast
import inspect
import json
import re
import site
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from program import PROGRAM, SIZE, SOURCE, read_gray, run, sentence

import inkbench
import numpy as np


class Module(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name):
        return str(self.folder / name)

    def test_truth_of_every_view(self):
        for view in ("front", "three_quarter", "close"):
            run("truth", "chess", "--view", view, "--size", "320x180", "-q", "--no-cache", "-o", self.file("t.png"))
            truth = inkbench.truth("chess", view, **SIZE, intersections="all")
            np.testing.assert_array_equal(truth.labels, read_gray(self.file("t.png")))
            self.assertGreater(len(truth.curves), 100)
            self.assertEqual(truth.sampled.shape, (180, 320))
            lengths = np.hypot(truth.curves["x1_px"] - truth.curves["x0_px"],
                               truth.curves["y1_px"] - truth.curves["y0_px"])
            self.assertGreater(lengths.sum(), np.count_nonzero(truth.labels))

    def test_drawing_is_that_of_the_program(self):
        for method, settings in (("mote4", {}), ("surface8", {}), ("ids", {"samples": "corner"}),
                                 ("surface8", {"turn_deg": 5}), ("mote4", {"fatten": True, "threshold": np.int64(9)}), ("strokes", {"width_px": 2})):
            texts = [text for key, value in settings.items() for text in ("--set", f"{key}={value}".lower())]
            run("draw", "torus", "--method", method, "--size", "320x180", "--response", *texts, "-o",
                self.file("edges.png"))
            edges = inkbench.draw(method, "torus", **SIZE, settings=settings)
            np.testing.assert_array_equal(edges, read_gray(self.file("edges.png")))
            self.assertGreater(edges.max(), 0)
        self.assertGreater(len(np.unique(edges)), 100, "ink is grey")

    def test_score_is_that_of_the_program(self):
        truth = inkbench.truth("torus", **SIZE)
        edges = inkbench.draw("decaudin", "torus", **SIZE)
        run("truth", "torus", "--size", "320x180", "-q", "-o", self.file("truth.exr"))
        run("draw", "torus", "--method", "decaudin", "--size", "320x180", "--response", "-o", self.file("edges.png"))
        # The program takes a truth as it is; compare and the module thin what the band leaves.
        told = json.loads(run("score", self.file("edges.png"), self.file("truth.exr"), "--json"))
        counts = told.get("counts", told)
        found = inkbench.score(edges, truth.labels, band_px=6, ignore=7)
        self.assertEqual((found.k, found.n_pred, found.n_truth), tuple(counts[n] for n in ("k", "n_pred", "n_truth")))
        self.assertAlmostEqual(found.f, 2 * found.k / (found.n_pred + found.n_truth), places=15)
        self.assertEqual({c.name for c in found.classes} - {"contour", "boundary", "crease", "intersection", "seam"},
                         set())
        against_truth = inkbench.score(edges, truth)
        self.assertLess(abs(against_truth.f - found.f), 0.01)

    def test_what_comes_out_is_no_copy_and_what_goes_in_is_not_changed(self):
        edges = inkbench.draw("mote4", "cube", **SIZE)
        self.assertFalse(edges.flags.owndata)
        self.assertTrue(edges.flags.c_contiguous and edges.flags.writeable)
        truth = inkbench.truth("cube", **SIZE)
        self.assertFalse(truth.labels.flags.owndata)
        self.assertEqual(truth.labels.ctypes.data, truth.labels.ctypes.data)
        kept = truth.labels
        del truth
        before = kept.copy(), edges.copy()
        turned = np.asfortranarray(edges)
        self.assertEqual(inkbench.score(edges, kept).k, inkbench.score(turned, kept).k)
        np.testing.assert_array_equal(kept, before[0])
        np.testing.assert_array_equal(edges, before[1])

    def test_errors_are_the_programs_sentences(self):
        with self.assertRaises(inkbench.Error) as caught:
            inkbench.truth("cubee")
        # The program takes lists and globs of scenes, and says that none fits.
        self.assertRegex(str(caught.exception), r"^scene: there is none called 'cubee' \(accepted: .*\bcube\b.*\)$")
        with self.assertRaises(inkbench.Error) as caught:
            inkbench.draw("mote5", "cube")
        self.assertRegex(str(caught.exception), r"^methods: there is no method 'mote5' \(accepted: .*\bmote4\b.*\)$")
        with self.assertRaises(ValueError) as caught:
            inkbench.truth("cube", "nowhere")
        self.assertEqual(str(caught.exception), sentence("truth", "cube", "--view", "nowhere"))
        image = np.zeros((180, 320), np.uint8)
        with self.assertRaisesRegex(inkbench.Error, "tolerance: 0"):
            inkbench.score(image, image, tolerance_px=0)
        with self.assertRaisesRegex(inkbench.Error, "tolerance: 9 px .*at most 8 px"):
            inkbench.score(image, image, tolerance_px=9)
        with self.assertRaisesRegex(inkbench.Error, "321"):
            inkbench.score(np.zeros((180, 321), np.uint8), image)

    def test_arrays_of_another_kind_are_refused(self):
        image = np.zeros((4, 4), np.uint8)
        with self.assertRaisesRegex(TypeError, r"edges: its values are float64 \(accepted: uint8\)"):
            inkbench.score(image.astype(float), image)
        with self.assertRaisesRegex(TypeError, "truth: this is a list"):
            inkbench.score(image, [[0]])
        with self.assertRaisesRegex(ValueError, "edges: it has 3 dimensions"):
            inkbench.score(np.zeros((4, 4, 3), np.uint8), image)

    def test_models_are_read(self):
        path = self.file("triangle.obj")
        Path(path).write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
        self.assertEqual(set(np.unique(inkbench.truth(path, **SIZE).curves["line_class"])), {2})
        with self.assertRaisesRegex(inkbench.Error, "nothing.obj"):
            inkbench.truth(self.file("nothing.obj"))

    def test_it_is_installed_where_python_looks_and_reads_models_there(self):
        subprocess.run(["cmake", "--install", Path(PROGRAM).parent, "--prefix", self.file("usr")], check=True,
                       capture_output=True)
        module = next((self.folder / "usr").rglob("inkbench.cpython*"))
        packages = str(module.parent.relative_to(self.folder / "usr"))
        self.assertTrue(any(path.endswith(packages) for path in site.getsitepackages()), packages)
        Path(self.file("t.obj")).write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
        code = "import inkbench; print(inkbench.__file__, inkbench.draw('ids', 't.obj', size='64x36').any())"
        told = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": str(module.parent)}, cwd=self.folder,
                              capture_output=True, text=True, check=True).stdout
        self.assertEqual(told, f"{module} True\n")

    def test_methods_are_those_of_the_program(self):
        told = json.loads(run("list", "methods", "--json"))["methods"]
        self.assertEqual([entry["name"] for entry in inkbench.methods()], [entry["name"] for entry in told])

    def test_every_name_stands_in_the_stub_with_its_parameters_and_defaults(self):
        stub = ast.parse((SOURCE / "src/python/inkbench.pyi").read_text(encoding="utf-8"))
        functions = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef)}
        classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
        fields = {name: {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
                  for name, node in classes.items()}
        views = fields.pop("_Views")
        public = {name for name in dir(inkbench) if not name.startswith("_")}
        self.assertEqual(public, set(functions) | set(fields))
        for name, node in functions.items():
            signature, _, text = getattr(inkbench, name).__doc__.partition("\n")
            self.assertGreater(len(text.strip()), 40, name)
            for argument in node.args.args:
                self.assertIn(f"{argument.arg}:", signature, name)
            # Options of the program stand in the text with their defaults, those of views at its end.
            told = dict(re.findall(r"^(\w+) = ([^:;\n]*)[^:\n]*: ", text, re.M))
            of_views = re.findall(r"^(.*): as the program's options of views", text, re.M)
            told |= {keyword: None for line in of_views for keyword in line.split(", ")}
            told.pop("scenes", None)
            if "**kwargs" in signature:
                self.assertEqual(ast.unparse(node.args.kwarg.annotation), "Unpack[_Views]", name)
                self.assertEqual(set(told), {argument.arg for argument in node.args.kwonlyargs} | views, name)
            for argument, default in zip(node.args.kwonlyargs, node.args.kw_defaults):
                value = ast.literal_eval(default)
                if "**kwargs" not in signature:
                    self.assertIn(f"{argument.arg}: ", signature, name)
                    self.assertIn(f" = {value!r}", signature, argument.arg)
                elif told[argument.arg] is not None and value is not ...:
                    value = "" if value == () else str(value).lower() if isinstance(value, bool) else str(value)
                    self.assertEqual(told[argument.arg], value, f"{name} {argument.arg}")
        for name, in_stub in fields.items():
            of = getattr(inkbench, name)
            if issubclass(of, Exception):
                continue
            there = {item for item, value in inspect.getmembers(of) if isinstance(value, property)}
            self.assertEqual(there, in_stub, name)
            for item in there:
                self.assertTrue(getattr(of, item).__doc__, f"{name}.{item}")


if __name__ == "__main__":
    unittest.main()
