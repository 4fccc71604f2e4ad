"""Figures of small runs: whole files, readable text, nothing clipped or hidden, colours apart."""

import contextlib
import io
import itertools
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["INKBENCH_SOURCE"])
SCRIPT = SOURCE / "notebooks" / "figures.py"
sys.dont_write_bytecode = True
sys.path[:0] = [str(SOURCE / "notebooks"), str(Path(__file__).parent)]

import colour_distance  # noqa: E402
import figures  # noqa: E402  (chooses the back end)
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402
import tiny_runs  # noqa: E402
from matplotlib.text import Text  # noqa: E402
from matplotlib.transforms import Bbox  # noqa: E402
from paper import catalogue, cost, images, layout, strips  # noqa: E402
from paper import style as looks  # noqa: E402
from paper.chart import Nothing, Table  # noqa: E402
from paper.runs import RunFolder, Runs  # noqa: E402

DESK = tempfile.TemporaryDirectory(prefix="inkbench-figures-")


def folder(name):
    return tiny_runs.make(name, DESK.name)


def runs_of(*names, **narrowed):
    return Runs([RunFolder(folder(name)) for name in names], **narrowed)


def style_of(runs, **options):
    return looks.Style(registry=runs.registry(), **options)


def process(*words):
    return subprocess.run([sys.executable, "-B", str(SCRIPT), *words], text=True,
                          capture_output=True, cwd=DESK.name)


def script(*words):
    """The same in this process, which has its libraries."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.chdir(DESK.name), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = figures.main([str(word) for word in words])
        except SystemExit as end:
            code = end.code
    return subprocess.CompletedProcess(words, code or 0, out.getvalue(), err.getvalue())


def drawn_texts(figure):
    """The texts that are seen: tick labels beyond their axis are made, but not drawn."""
    figure.draw_without_rendering()
    hidden = set()
    for ax in figure.axes:
        for axis in (ax.xaxis, ax.yaxis):
            shown = set(axis._update_ticks()) if ax.axison and axis.get_visible() else set()
            for tick in axis.get_major_ticks() + axis.get_minor_ticks():
                if tick not in shown:
                    hidden |= {tick.label1, tick.label2}
    return [text for text in figure.findobj(Text)
            if text.get_visible() and text.get_text().strip() and text not in hidden]


ALL_RUNS = ("compare", "stress")


class EveryFigure(unittest.TestCase):
    def test_no_text_leaves_the_figure(self):
        runs = runs_of(*ALL_RUNS)
        for width_mm, font_pt in ((178, 8), (84, 7)):
            style = style_of(runs, width_in=width_mm / 25.4, font_pt=font_pt)
            made = 0
            for name in catalogue.FIGURES:
                try:
                    charts = catalogue.draw(name, runs, style)
                except Nothing:
                    continue
                for chart in charts:
                    if isinstance(chart, Table):
                        continue
                    made += 1
                    self.check_texts(f"{name} at {width_mm} mm", chart.figure, style)
                    self.assertTrue(chart.caption.endswith("."), chart.caption)
                    plt.close(chart.figure)
            self.assertGreaterEqual(made, 5)

    def check_texts(self, name, figure, style):
        page = figure.bbox
        self.assertAlmostEqual(figure.get_figwidth(), style.width_in, places=6, msg=name)
        for text in drawn_texts(figure):
            box = text.get_window_extent()
            inside = (box.x0 >= page.x0 - 0.6 and box.x1 <= page.x1 + 0.6 and
                      box.y0 >= page.y0 - 0.6 and box.y1 <= page.y1 + 0.6)
            self.assertTrue(inside, f"{name}: '{text.get_text()}' at {box.extents}, page "
                            f"{page.extents}")
            self.assertGreaterEqual(text.get_fontsize(), style.font_pt - 1, name)

    def test_of_a_run_that_lacks_its_table_says_why(self):
        runs = runs_of("stress")
        for name in ("strips", "error_time", "classes", "verdict"):
            with self.assertRaises(Nothing) as caught:
                catalogue.draw(name, runs, style_of(runs))
            self.assertGreater(len(str(caught.exception)), 10)


class ErrorTime(unittest.TestCase):
    def test_points_that_coincide_are_both_seen(self):
        dots = [(10, 10), (10, 10.2), (10.1, 10), (50, 50)]
        self.assertEqual(cost.stacks(dots, 3), [0, 1, 2, 0])
        names = ["mote4", "mote16", "ids"]
        summary = pd.DataFrame({
            "f_2px": [0.9, 0.9, 0.95], "f_lo": [0.85, 0.85, 0.94], "f_hi": [0.95, 0.95, 0.96],
            "draw_ms": [1.0, 1.0, 2.0], "draw_ms_lo": [0.9, 0.9, 1.9],
            "draw_ms_hi": [1.1, 1.1, 2.1]}, index=names)
        figure, _ = cost._error_time(looks.Style(), summary, summary, 4)
        marks = [line for line in figure.axes[0].lines
                 if line.get_marker() not in ("None", "") and len(line.get_xdata()) == 1]
        self.assertEqual(len(marks), 3)
        first, second = [m for m in marks if m.get_xdata()[0] == 1.0]
        ring, dot = sorted((first, second), key=lambda m: -m.get_markersize())
        self.assertGreater(ring.get_markersize(), dot.get_markersize() + 2)
        self.assertEqual(ring.get_markerfacecolor(), "none")
        plt.close(figure)

    def test_labels_do_not_touch(self):
        random = np.random.default_rng(7)
        names = [f"method_{i:02d}" for i in range(21)]
        f = 1 - 10 ** random.uniform(-2, -0.6, 21)
        ms = 10 ** random.uniform(-0.3, 0.8, 21)
        f[3], ms[3] = f[2], ms[2]
        summary = pd.DataFrame({
            "f_2px": f, "f_lo": f - 0.3 * (1 - f), "f_hi": f + 0.3 * (1 - f), "draw_ms": ms,
            "draw_ms_lo": 0.9 * ms, "draw_ms_hi": 1.1 * ms}, index=names)
        for width_mm in (178, 84):
            style = looks.Style(width_in=width_mm / 25.4)
            free = any(cost._error_time(style, summary, summary, tall * style.width_in)[1]
                       for tall in (0.62, 1.0, 1.7))
            plt.close("all")
            self.assertTrue(free, f"{width_mm} mm")

    def test_the_front_is_what_nothing_beats(self):
        points = {"slow": (3, 0.1), "fast": (1, 0.3), "beaten": (2, 0.4), "tied": (3, 0.1)}
        self.assertEqual(cost.front(points), ["fast", "slow"])


class Colours(unittest.TestCase):
    def test_errors_and_classes_are_seen_and_told_apart(self):
        errors = [looks.MISSING, looks.FALSE]
        classes = list(looks.CLASS_COLOURS.values())
        self.check(errors + classes, 25)
        for a in errors:
            self.assertGreater(colour_distance.distance(a, looks.MIST), 25)
        lightness = sorted(colour_distance.lab(c)[0] for c in errors + [looks.INK])
        self.assertGreater(min(np.diff(lightness)), 15, "told apart in grey print")

    def test_causes_are_seen_and_told_apart(self):
        causes = {(cause["kind"], cause["name"]): cause["figure"] for cause in looks.VOCABULARY["causes"]}
        # No method has both: whoever declares a code has no undeclared misses.
        undeclared = causes.pop(("false_negatives", "undeclared"))
        self.check([*causes.values(), *looks.CLASS_COLOURS.values()], 16)
        self.check([undeclared, *looks.CLASS_COLOURS.values()], 16)

    def check(self, colours, least):
        for colour in colours:
            self.assertGreaterEqual(colour_distance.contrast_on_white(colour), 3, colour)
        for a, b in itertools.combinations(colours, 2):
            self.assertGreater(colour_distance.distance(a, b), least, (a, b))


class Images(unittest.TestCase):
    def test_marks_keep_the_width_of_lines(self):
        labels = np.zeros((40, 40), np.uint8)
        labels[20, 8:32] = 1
        response = np.zeros_like(labels)
        response[17:24, 8:20] = 255          # a fat line on the true one
        response[9:12, 24:30] = 255          # a fat line where none is
        errors = np.zeros_like(labels)
        errors[10, 24:30] = 1
        errors[20, 23:32] = 8
        view = images.View("s", "v", None, labels, [])
        marks = images.marks(view, images.Drawing("m", None, response, errors, response >= 128))
        self.assertTrue((marks[17:24, 8:19] == images.HIT).all())
        self.assertTrue((marks[9:12, 24:30] == images.WRONG + 1).all())
        self.assertTrue((marks[20, 23:32] == images.WRONG + 8).all())
        self.assertTrue((marks[0:8] == images.BLANK).all())

    def test_shrinking_keeps_every_line(self):
        codes = np.zeros((90, 120), np.uint8)
        codes[:, 57] = 3
        codes[41, :] = 2
        small = images.shrunk(codes, (30, 20), np.arange(14))
        self.assertEqual(small.shape, (20, 30))
        self.assertTrue((small.max(axis=1) == 3).all())
        self.assertTrue((small.max(axis=0) >= 2).all())

    def test_the_window_lies_where_methods_differ(self):
        labels = np.zeros((60, 80), np.uint8)
        labels[30] = 1
        drawings = []
        for i in range(3):
            errors = np.zeros_like(labels)
            errors[10:14, 5:9] = 6           # all miss this
            errors[40:44, 60:60 + 4 * i] = 1  # they differ here
            drawings.append(images.Drawing(str(i), None, errors, errors, errors > 0))
        view = images.View("s", "v", None, labels, drawings)
        x, y, w, h = images.telling_window(view, (0, 0, 80, 60), (16, 10))
        self.assertTrue(x <= 61 < x + w and y <= 41 < y + h, (x, y))

    def test_without_errors_the_window_lies_where_lines_are(self):
        labels = np.zeros((60, 80), np.uint8)
        labels[30, 50:] = 1
        none = np.zeros_like(labels)
        view = images.View("s", "v", None, labels, [images.Drawing("a", None, none, none, labels > 0)])
        x, y, w, h = images.telling_window(view, (0, 0, 80, 60), (16, 10))
        self.assertTrue(50 <= x and x + w <= 80 and y <= 30 < y + h, (x, y))


class Strips(unittest.TestCase):
    def texts(self, runs, **options):
        charts = strips.strips(runs, style_of(runs, **options))
        return [text for chart in charts for text in drawn_texts(chart.figure)]

    def test_truth_stands_once_a_band_and_numbers_under_each_image(self):
        words = [t.get_text() for t in self.texts(runs_of("compare"))]
        self.assertEqual(sum(word == "truth" for word in words), 2)
        self.assertEqual(sum(bool(re.fullmatch(r"F [01]\.\d{3}", w)) for w in words), 16)
        self.assertEqual(sum(w.endswith(" ms") for w in words), 16)

    def test_only_a_lone_best_is_bold(self):
        texts = [t for t in self.texts(runs_of("compare", scenes=["cube"]))
                 if t.get_text().startswith("F ")]
        best = max(t.get_text() for t in texts)
        bold = [t for t in texts if t.get_fontweight() == "bold"]
        is_alone = sum(t.get_text() == best for t in texts) == 1
        self.assertEqual([t.get_text() for t in bold], [best] if is_alone else [])

    def test_ink_is_as_dark_as_its_share(self):
        view, = images.shown_views(runs_of("ink"), 1)
        for drawing in view.drawings:
            is_ink = drawing.method in ("strokes", "chords")
            self.assertEqual(drawing.is_ink, is_ink, drawing.method)
            marks = images.marks(view, drawing)
            marks[0, 0] = images.WRONG + 1
            shown = strips.drawn_colours(drawing, marks, drawing.response)
            for code in (images.BLANK, images.HIT):
                self.assertEqual(len(np.unique(shown[marks == code], axis=0)) > 2, is_ink, drawing.method)
            self.assertTrue((shown[0, 0] == strips.mark_table()[images.WRONG + 1]).all())

    def test_windows_are_those_given(self):
        runs = runs_of("compare", scenes=["cube"])
        chart, = strips.strips(runs, style_of(runs, windows=[(10, 20, 30, 16), (50, 40, 20, 10)]))
        self.assertIn("10,20,30,16; 50,40,20,10", chart.facts[0])
        plt.close(chart.figure)


class Program(unittest.TestCase):
    CHARTS = ["strips", "error_time", "classes"]

    def test_writes_all_formats_whole_and_the_same_bytes_again(self):
        words = [folder("compare"), "--format", "pdf,svg,png", "--width", "84mm", "--font-size",
                 "7", "--only", ",".join(self.CHARTS + ["verdict", "stress"]), "--out"]
        first = process(*words, "one")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual(first.stderr, "")
        self.assertEqual(process(*words, "two").returncode, 0)
        one = {p.name: p.read_bytes() for p in Path(DESK.name, "one").iterdir()}
        two = {p.name: p.read_bytes() for p in Path(DESK.name, "two").iterdir()}
        self.assertEqual(sorted(one), sorted(two))
        for name in one:
            self.assertTrue(one[name] == two[name], f"{name} differs")
        self.assertFalse([name for name in one if name.endswith(".part")])
        for name in self.CHARTS:
            self.check_pdf(one[f"{name}.pdf"], name)
            self.check_svg(one[f"{name}.svg"].decode(), name)
            self.assertTrue(one[f"{name}.png"].startswith(b"\x89PNG\r\n"), name)
        page = one["figures.md"].decode()
        for name in one:
            self.assertTrue(name == "figures.md" or f"[{name}]({name})" in page, name)
        self.assertIn("- `stress`: no axis_summary.csv", page)
        self.assertIn(r"\toprule", one["verdict.tex"].decode())
        self.assertIn(r"mote4\_tuned", one["verdict.tex"].decode())

    def check_pdf(self, content, name):
        self.assertTrue(content.startswith(b"%PDF"), name)
        self.assertTrue(content.rstrip().endswith(b"%%EOF"), name)
        self.assertIn(b"/FontFile2", content, f"{name}: the font is not embedded")
        self.assertNotIn(b"/Type3", content, name)
        width = float(re.search(rb"/MediaBox \[ *0 0 ([\d.]+)", content)[1])
        self.assertAlmostEqual(width, 84 / 25.4 * 72, delta=0.05, msg=name)

    def check_svg(self, text, name):
        self.assertIn("</svg>", text[-20:], name)
        self.assertRegex(text, r"<text [^>]*>[^<]*[a-z]{3}", f"{name}: text is not text")
        self.assertIn("Arial", text, name)
        self.assertRegex(text, r'width="238\.\d+pt"', name)

    def test_a_figure_of_an_older_run_does_not_stay(self):
        for names in ("classes,error_time", "classes"):
            self.assertEqual(script(folder("compare"), "--only", names, "--out", "old").returncode, 0)
        left = sorted(p.name for p in Path(DESK.name, "old").iterdir())
        self.assertEqual(left, ["classes.png", "classes.svg", "figures.md"])

    def test_bad_input_is_one_sentence_and_leaves_nothing(self):
        run = folder("compare")
        for words, wanted in (
                (["--out", "bad"], ["needs a run"]),
                (["nowhere", "--out", "bad"], ["nowhere", "no such folder"]),
                ([DESK.name, "--out", "bad"], ["rows.csv"]),
                ([run, "--format", "eps", "--out", "bad"], ["--format", "'eps'", "pdf, svg, png"]),
                ([run, "--width", "84", "--out", "bad"], ["--width", "'84'", "84mm"]),
                ([run, "--width", "3mm", "--out", "bad"], ["--width", "40mm"]),
                ([run, "--font-size", "x", "--out", "bad"], ["--font-size", "'x'"]),
                ([run, "--window", "1,2,3", "--out", "bad"], ["--window", "'1,2,3'"]),
                ([run, "--only", "strip", "--out", "bad"], ["'strip'", "did you mean strips?"]),
                ([run, "--methods", "sobl", "--out", "bad"], ["--methods", "'sobl'", "mote4"]),
                ([run, "--scenes", "torsu", "--out", "bad"], ["--scenes", "'torsu'", "cube"]),
                ([run, "--widht", "84mm", "--out", "bad"], ["--widht"])):
            done = script(*words)
            self.assertEqual(done.returncode, 2, words)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertNotIn("Traceback", done.stderr)
            for part in wanted:
                self.assertIn(part, done.stderr)
            self.assertFalse(Path(DESK.name, "bad").exists(), words)
        done = script(run, "--only", "strips", "--window", "150,0,40,20", "--out", "bad")
        self.assertEqual(done.returncode, 2)
        self.assertIn("160x90", done.stderr)

    def test_a_half_installed_matplotlib_is_one_sentence(self):
        for content, wanted in (("import a_missing_part", "No module named 'a_missing_part'"),
                                ("raise ValueError('binary\\nmismatch')", "binary mismatch")):
            package = Path(DESK.name, "half", "matplotlib")
            package.mkdir(parents=True, exist_ok=True)
            (package / "__init__.py").write_text(content)
            done = subprocess.run([sys.executable, "-B", str(SCRIPT), folder("compare")], text=True,
                                  capture_output=True, cwd=DESK.name,
                                  env={**os.environ, "PYTHONPATH": str(package.parent)})
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(wanted, done.stderr)
            self.assertIn("apt-get install", done.stderr)

    def test_captions_name_the_run_and_its_command_stands_once(self):
        model = Path(DESK.name, "models", "square.obj")
        model.parent.mkdir()
        model.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        run = Path(DESK.name, "of-a-file")
        made = subprocess.run([tiny_runs.PROGRAM, "compare", str(model), "--methods", "ids,mote4", "--size",
                               "160x90", "--no-sweep", "--quiet", "--out", str(run)], capture_output=True)
        self.assertIn(made.returncode, (0, 3), made.stderr)
        self.assertEqual(script(str(run), "--only", "strips,classes,error_time", "--out", "short").returncode, 0)
        page = Path(DESK.name, "short", "figures.md").read_text()
        self.assertEqual(page.count("inkbench compare"), 1)
        self.assertIn("- of-a-file: `inkbench compare square.obj --methods", page)
        self.assertNotIn(DESK.name, page)

    def test_check_reads_options_alone(self):
        self.assertEqual(script("--check", "--width", "3.3in").returncode, 0)
        self.assertEqual(script("--check", "--width", "3.3").returncode, 2)


class Answer(unittest.TestCase):
    """Figures say what the run says: its winner, its intervals, its digits."""

    def figures(self, out, *words, run="seven"):
        done = subprocess.run([tiny_runs.PROGRAM, "figures", folder(run), "--only",
                               "verdict,error_time", "--out", out, *words], text=True,
                              capture_output=True, cwd=DESK.name)
        self.assertEqual(done.returncode, 0, done.stderr)
        return Path(DESK.name, out)

    def cells(self, out, ms=3):
        """The lines of the LaTeX table by method: F, interval, ms as verdict.md writes them."""
        lines = {}
        for line in (out / "verdict.tex").read_text().splitlines():
            if " & " in line and not line.startswith(("&", "method")):
                cells = [re.sub(r"\\textbf\{(.*?)\}", r"\1", cell) for cell in line.split(" & ")]
                shown = [re.sub(r"\b0\.", ".", cell).replace("--", "-") for cell in cells[1:3]]
                lines[cells[0].replace("\\", "")] = [*shown, cells[ms].replace("--", "-")]
        return lines

    def test_is_that_of_the_run(self):
        self.check_is_that_of("seven", at=3)

    def test_of_ink_is_soft_f(self):
        self.check_is_that_of("ink", at=4)  # behind F
        drawn = Path(DESK.name, "answer-ink", "verdict.tex").read_text()
        self.assertIn(r"method & soft $F$ & 95\,\% & $F$ & ms", drawn)
        summary = pd.read_csv(Path(folder("ink"), "summary.csv")).set_index("method").loc[["strokes", "surface8"]]
        figure, _ = cost._error_time(looks.Style(), summary, summary, 4)
        ax = figure.axes[0]
        self.assertEqual(ax.get_ylabel(), "error 1 − soft F")
        marks = [line.get_ydata()[0] for line in ax.lines if line.get_marker() not in ("None", "") and len(line.get_xdata()) == 1]
        np.testing.assert_allclose(sorted(marks), sorted(1 - summary["soft_f"]))
        plt.close(figure)

    def check_is_that_of(self, run, at):
        out, said = self.figures(f"answer-{run}", run=run), Path(folder(run), "verdict.md").read_text()
        for method, f, interval, ms in re.findall(
                r"^\| (\w+)(?: \*)? \| (\S+) \| (\S+) \|.*\| (\S+) \| \S+ \| \S+ \|$", said, re.M):
            self.assertEqual(self.cells(out, at)[method], [f, interval, ms])
        self.assertEqual(len(self.cells(out)), 8)
        answer, ms = re.search(r"^\*\*(\w+)\*\* finds .*? in (\S+ ms)", said, re.M).groups()
        f = "(soft )?F 0" + re.escape(self.cells(out, at)[answer][0])
        bold = answer.replace("_", r"\_")
        self.assertIn(rf"\textbf{{{bold}}}", (out / "verdict.tex").read_text())
        self.assertEqual(len(re.findall(rf"(?m)^- the answer: {answer}, {f} in {ms}$", (out / "figures.md").read_text())), 2)

    def test_of_some_scenes_is_that_of_their_own_run(self):
        scenes = "cube,tiles,torus,blocks,gear,gem"
        out = self.figures("six", "--scenes", scenes)
        words = [scenes if "cube" in word else word for word in tiny_runs.COMMANDS["seven"]]
        own = Path(DESK.name, "own")
        subprocess.run([tiny_runs.PROGRAM, *words, "--size", "160x90", "--quiet", "--out", str(own)],
                       check=True, capture_output=True)
        for name in ("summary.csv", "differences.csv"):
            made, meant = (pd.read_csv(path / name) for path in (out, own))
            kept = [c for c in made if not c.startswith("draw_ms") and c not in ("answer", "answer_share", "ap")]
            pd.testing.assert_frame_equal(made[kept], meant[kept])
        self.assertIn("made of cube, tiles, torus", (out / "figures.md").read_text())
        self.assertEqual(set(self.cells(out)), set(pd.read_csv(own / "summary.csv")["method"]))
        self.assertIn("summary.csv is over all scenes",
                      script(folder("seven"), "--scenes", "cube", "--only", "verdict").stdout)


class Layout(unittest.TestCase):
    def test_panels_leave_as_few_places_empty_as_may_be(self):
        self.assertEqual(layout.grid_of(14, 5), (3, 5))
        self.assertEqual(layout.grid_of(15, 5), (3, 5))
        self.assertEqual(layout.grid_of(8, 5), (2, 4))
        self.assertEqual(layout.grid_of(1, 5), (1, 1))

    def test_labels_of_lines_stand_apart_and_near(self):
        box = Bbox([[0, 0], [10, 100]])
        self.assertEqual(layout._moved_apart([10, 50], 8, box), [10, 50])
        self.assertEqual(layout._moved_apart([50, 50, 50], 8, box), [42, 50, 58])
        for wanted in ([0, 0, 1], [99, 99, 100], [3, 40, 41, 90, 97]):
            placed = layout._moved_apart(wanted, 8, box)
            self.assertGreaterEqual(min(np.diff(placed)), 8 - 1e-9, wanted)
            self.assertTrue(0 <= placed[0] and placed[-1] <= 100, placed)

    def test_widths_have_units(self):
        for text in ("84mm", "8.4cm", "238.11pt", "3.3071in"):
            self.assertAlmostEqual(looks.length_in(text), 84 / 25.4, places=3)



if __name__ == "__main__":
    try:
        unittest.main(verbosity=1)
    finally:
        DESK.cleanup()
