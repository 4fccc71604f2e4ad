"""The page in a browser: a headless Chromium opens what the program wrote and uses it."""

import csv
import json
import shutil
import sys
import unittest
from random import Random

from browser import BrowserTest, Select, inkbench, webdriver


def median(values):
    """As the page and the program have it; None without values."""
    ordered = sorted(values)
    if not ordered:
        return None
    place = 0.5 * (len(ordered) - 1)
    low = int(place)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (place - low) * (ordered[high] - ordered[low])


class PageTest(BrowserTest):
    @classmethod
    def make_runs(cls):
        usual = ["--scenes", "cube,torus,tiles", "--methods", "mote4,ids,edge_hash", "--size",
                 "160x90", "--repetitions", "1", "--no-crosscheck"]
        inkbench("compare", *usual, "--out", cls.folder / "before")
        inkbench("compare", *usual, "--set", "mote4.threshold=40", "--out", cls.folder / "after")
        cls.printed = inkbench("compare", "--scenes", "cube,torus,tiles,blocks,hills,gear,staircase", "--methods",
                               "mote4,ids,edge_hash,surface8", "--size", "160x90", "--repetitions", "1", "--no-sweep",
                               "--no-crosscheck", "--images", "none", "--out", cls.folder / "seven")
        inkbench("compare", "--scenes", "cube,torus,tiles,blocks,hills,gear", "--methods", "strokes,surface_lookup,ids", "--size",
                 "160x90", "--repetitions", "1", "--no-crosscheck", "--out", cls.folder / "ink")
        cls.page = cls.folder / "two.html"
        inkbench("report", cls.folder / "before", cls.folder / "after", "-o", cls.page)

    def column(self, section, index):
        return self.script(
            "return [...document.querySelectorAll(`#${arguments[0]} tbody tr`)].map("
            "row => row.children[arguments[1]].textContent.trim())", section, index)

    # ---- What is shown -------------------------------------------------------------------

    def test_every_part_draws(self):
        self.open()
        self.script("for (const section of sections) if (!section.node.hidden) drawSection(section)")
        empty = self.script(
            "return sections.filter(s => !s.node.hidden && !s.body.textContent.trim()).map(s => s.id)")
        self.assertEqual(empty, [])
        words = self.script("return document.body.innerText")
        for nonsense in ("NaN", "undefined", "[object", "null"):
            self.assertNotIn(nonsense, words)
        self.assertGreater(len(self.script("return sections.filter(s => !s.node.hidden)")), 8)

    def table(self, name, run="seven"):
        with open(self.folder / run / name, newline="") as file:
            return list(csv.DictReader(file))

    INTERVALS = """
        const view = currentView();
        return Object.fromEntries(view.summaries.map(s => [s.method,
            ['f_2px', ...RECALL_GROUPS].map(name => rangeOf(view.run, s, name, view.hasAllScenes))]));"""

    def test_intervals_are_those_of_the_tables_and_none_under_a_filter_of_scenes(self):
        page = self.folder / "seven" / "report.html"
        self.open(page)
        shown = self.script(self.INTERVALS)
        keys = ["f"] + [f"recall_{name}" for name in self.script("return RECALL_GROUPS")]
        ends_of = lambda line, *ends: [float(line[end]) if line[end] else None for end in ends]
        for line in self.table("summary.csv"):
            for key, interval in zip(keys, shown[line["method"]]):
                with self.subTest(method=line["method"], key=key):
                    ends = [interval["low"], interval["high"]] if interval else [None, None]
                    self.assertEqual(ends, ends_of(line, f"{key}_lo", f"{key}_hi"))
        for line in self.table("differences.csv"):
            with self.subTest(pair=(line["method"], line["other"])):
                shown = self.script(
                    "const d = currentView().differenceOf(...arguments); return [d.value, d.range.low, d.range.high,"
                    " d.rangeOfAll.low, d.rangeOfAll.high, d.scenes, d.better, d.worse]", line["method"], line["other"])
                self.assertEqual(shown, [float(value) for value in list(line.values())[2:]])
        self.open(page, "#scenes=cube,torus,tiles,blocks,hills,gear", part="verdict")
        self.assertEqual({str(of) for of in self.script(self.INTERVALS).values()}, {str([None] * len(keys))})
        self.assertIn("sums alone", self.find("#verdict .note.sums").text)
        self.assertEqual(self.script("return currentView().differenceOf('ids', 'mote4').range"), None)

    def test_sums_under_filters_are_those_of_the_rows_to_the_last_digit(self):
        self.open(self.folder / "seven" / "report.html")
        self.check_sums({}, self.table("rows.csv"))
        rows = [row for row in self.table("rows.csv") if row["study"] == "compare"]
        random = Random(7)
        values = {name: sorted({row[name] for row in rows}) for name in ("scene", "split", "scene_kind", "method")}
        for _ in range(200):
            chosen = {"scenes": random.sample(values["scene"], random.randint(1, 7))}
            if random.random() < 0.5:
                chosen["split"] = random.choice(values["split"])
            if random.random() < 0.2:
                chosen["scene_kind"] = random.choice(values["scene_kind"])
            if random.random() < 0.5:
                chosen["methods"] = random.sample(values["method"], random.randint(1, 4))
            self.check_sums(chosen, [row for row in rows if row["scene"] in chosen["scenes"] and all(
                chosen.get(name, row[name]) == row[name] for name in ("split", "scene_kind"))])

    def check_sums(self, chosen, rows):
        """What the page makes of filters against sums of the rows that they leave."""
        shown = self.script(
            "for (const name of FILTERS) state.values[name] = name in arguments[0] ? arguments[0][name] : state.defaults[name];"
            "viewCache = null; const view = currentView(); return view.summaries.map(s => [s.method, s.views, s.scenes,"
            " s.value, s.f_1px, s.precision, s.recall, s.ms, s.classes.crease])", chosen)
        methods = dict.fromkeys(row["method"] for row in rows)
        if "methods" in chosen:
            methods = [m for m in methods if m in chosen["methods"] + ["none", "sampled", "exact_corner", "oracle"]]
        self.assertEqual([line[0] for line in shown], list(methods))
        for method, *values in shown:
            own = [row for row in rows if row["method"] == method and row["status"] == "ok"]
            total = lambda *names: sum(int(row[name] or 0) for row in own for name in names)
            ratio = lambda over, under, of_none=None: over / under if under else of_none
            with self.subTest(chosen=chosen, method=method):
                self.assertEqual(values, [
                    len(own), len({row["scene"] for row in own}),
                    ratio(2 * total("k_2px"), total("n_pred", "n_truth"), 1) if own else None,
                    ratio(2 * total("k_1px"), total("n_pred_1px", "n_truth"), 1) if own else None,
                    ratio(total("k_2px"), total("n_pred")), ratio(total("k_2px"), total("n_truth")),
                    median([int(row["draw_ns"]) * 1e-6 for row in own if row["draw_ns"]]),
                    ratio(total("k_crease"), total("truth_px_crease"))])

    def test_the_answer_is_that_of_terminal_verdict_and_latex(self):
        said = (self.folder / "seven" / "verdict.md").read_text()
        self.open(self.folder / "seven" / "report.html")
        first, rest = self.find("h1").text, self.find(".lead").text
        self.assertRegex(rest, r"\], 80 % interval over 7 scenes\)")
        self.assertRegex(first, "finds .* % of the outline, and .* % of what it draws is right, in ")
        self.assertIn(f"\n{first}. {rest} F is at", self.printed)
        self.assertIn(f"\n{first}. {rest} F is at", said.replace("*", "").replace("`", ""))
        for paragraph in self.find_all("header .more p"):
            text = paragraph.get_attribute("textContent")
            self.assertTrue(text in said or text.startswith("No method is both"), text)
        self.check_winner(first, rest)
        self.check_first_screen()
        self.open(self.folder / "seven" / "report.html", "#methods=mote4,ids")
        self.assertEqual(self.find(".lead").text, f"A filter is set: these are sums alone. The answer of all is {first}.")
        self.assertEqual(self.find_all(".paper-sentence"), [])

    def check_first_screen(self):
        """What the answer is, where it lies in the chart, and commands that the program takes."""
        method = self.script("return currentView().answer.method.method")
        self.assertTrue(self.find(".what").text.startswith(f"{method}: "))
        self.assertTrue(self.find(".what a").get_attribute("href").endswith(f"/methods/{method}/{method}.md"))
        self.assertEqual(self.script("return document.querySelector('.point:has(.answer)').dataset.method"), method)
        self.assertIn(f"{method}, the answer", self.find("#chart-error-time").text)
        run = self.folder / "seven"
        lines = [code.text for code in self.find_all(".take-home code")]
        self.assertEqual([line.split(" ")[1] for line in lines], ["page", "bake", "advise", "figures"])
        self.assertIn(f"inkbench page cube --run {run}", lines)
        self.script("window.copied = []; copyText = (text, ...rest) => window.copied.push(text)")
        for button in self.find_all(".take-home button"):
            button.click()
        self.assertEqual(self.script("return window.copied"), lines)

    def check_winner(self, first, rest):
        lines = {line["answer"]: line for line in self.table("summary.csv")}
        winner = lines.get("answer") or lines["both"]
        self.assertEqual(winner["method"], first.split(" ")[0])
        self.assertEqual(self.script("return currentView().answer.method.method"), winner["method"])
        self.check_latex(winner, first + " " + rest)

    def check_latex(self, winner, sentence):
        """The table for papers has the answer's name in bold, and its digits."""
        out = self.folder / "figures"
        said = inkbench("figures", self.folder / "seven", "--only", "verdict", "--out", out, codes=(0, 2))
        if "verdict.tex" not in said:  # without matplotlib
            return
        bold = [line for line in (out / "verdict.tex").read_text().splitlines() if line.startswith(r"\textbf{")]
        self.assertEqual(len(bold), 1)
        name, f, interval, ms = (cell.strip() for cell in bold[0].split("&")[:4])
        self.assertEqual(name, rf"\textbf{{{winner['method']}}}".replace("_", r"\_"))
        f = f.removeprefix(r"\textbf{").removesuffix("}")
        self.assertIn(f", in {ms} ms", sentence)
        self.assertIn(f"Its F is {f}", sentence)
        self.assertEqual(interval, f"{float(winner['f_lo']):.3f}--{float(winner['f_hi']):.3f}")
        self.assertEqual(self.script(
            "return formatRange(currentView().summaries.find(s => s.method === arguments[0]).range)", winner["method"]),
            interval.replace("--", " to "))

    def test_numbers_are_rounded_as_the_program_rounds_them(self):
        self.open()
        for value in (0.8125, 0.1875, 0.0625, 0.9375, 0.0005, 0.9995, 0.5, 1.0):
            self.assertEqual(self.script("return formatShare(arguments[0])", value), f"{value:.3f}")

    def test_few_scenes_have_no_interval(self):
        self.open()
        self.assertIn("3 scenes are too few for an interval; better on ", self.find(".lead").text)
        self.assertNotIn("[", self.find("header").text)
        self.assertEqual(self.script("return currentView().summaries.filter(s => s.range).length"), 0)

    def test_a_ratio_of_times_is_that_of_diff(self):
        self.open(self.page)
        shown = dict(self.script("return runLines(viewOf(runs[0]), viewOf(runs[1]), 'f_2px').map(l => [l.method, l.timeRatio])"))
        said = json.loads(inkbench("diff", self.folder / "before", self.folder / "after", "--json"))
        for method in said["methods"]:
            if method["method"] in shown:
                self.assertAlmostEqual(shown[method["method"]], method["time_ratio"], places=12)

    def test_numbers_are_those_of_summary_csv(self):
        self.open()
        shown = self.script(
            "return currentView().summaries.map(s => [s.method, s.value, s.f_1px, s.precision,"
            " s.recall, s.macro, s.train, s.heldout, s.real, s.ms])")
        lines = {line["method"]: line for line in self.table("summary.csv", "before")}
        self.assertEqual({line[0] for line in shown}, set(lines))
        keys = ["f_2px", "f_1px", "precision", "recall", "f_macro", "f_train", "f_heldout", "f_real",
                "draw_ms"]
        for method, *values in shown:
            for key, value in zip(keys, values):
                kept = lines[method][key]
                with self.subTest(method=method, key=key):
                    if kept == "":
                        self.assertIsNone(value)
                    else:
                        self.assertAlmostEqual(value, float(kept), places=9)

    def test_ink_is_measured_by_soft_f_first(self):
        page = self.folder / "ink" / "report.html"
        self.open(page, part="verdict")
        first = self.find("h1").text
        self.assertRegex(first, "finds .* % of the ink, and .* % of the ink it draws is right, in ")
        self.assertIn("Its soft F is 0.", self.find(".lead").text)
        self.assertIn(f"{first}. ", (self.folder / "ink" / "verdict.md").read_text().replace("*", ""))
        self.assertEqual(self.script("return [...document.querySelector('select[aria-label=Measure]').options].map(o => o.value)[0]"),
                         "soft_f")
        heads = [head.text for head in self.find_all("#verdict thead tr:last-child th")]
        self.assertEqual([heads[1][:6], heads.count("F at 2 px")], ["soft F", 1])
        lines = {line["method"]: line for line in self.table("summary.csv", "ink")}
        shown = self.script("return currentView().summaries.map(s => [s.method, s.value, s.f_2px, s.macro, s.range?.low])")
        for method, *values in shown:
            for key, value in zip(("soft_f", "f_2px", "soft_macro", "soft_lo"), values):
                self.assertAlmostEqual(value, float(lines[method][key]), places=7, msg=(method, key))
        for line in self.table("soft_differences.csv", "ink"):
            self.assertEqual(self.script("return currentView().differenceOf(...arguments).value", line["method"], line["other"]),
                             float(line["difference"]))
        Select(self.find("select[aria-label=Measure]")).select_by_value("f_2px")
        self.wait(lambda: "ink" not in self.find("h1").text)
        self.assertEqual(self.address(), "#measure=f_2px")
        self.show("time")
        self.assertIn("F at 2 px", self.find("#chart-error-time").text)
        self.find("#reset").click()
        self.wait(lambda: "soft F" in self.find("#chart-error-time").text and self.find("h1").text == first)

    def test_beside_a_run_without_ink_there_is_no_soft_f(self):
        for runs in (("ink", "seven"), ("seven", "ink")):
            inkbench("report", *(self.folder / run for run in runs), "-o", self.folder / "mixed.html")
            self.open(self.folder / "mixed.html", part="runs")
            self.assertEqual(self.script("return [shownMeasure(), currentView().measure]"), ["f_2px", "f_2px"])
            self.assertEqual(self.find_all("option[value=soft_f]"), [])
            self.assertIn("F at 2 px: ", self.find("#runs").text)

    def test_ink_under_a_filter_is_summed_from_the_rows(self):
        self.open(self.folder / "ink" / "report.html", "#scenes=cube,gear")
        rows = [row for row in self.table("rows.csv", "ink") if row["study"] == "compare" and row["scene"] in ("cube", "gear")]
        for method, value in self.script("return currentView().summaries.map(s => [s.method, s.value])"):
            own = [row for row in rows if row["method"] == method and row["status"] == "ok"]
            of = lambda name: sum(float(row[f"ink_{name}_px"]) for row in own)
            ink = 2 * (of("matched") + of("misplaced")) + of("surplus") + of("missing")
            self.assertAlmostEqual(value, 2 * of("matched") / ink, places=12)

    CODES = """
        const [done] = arguments;
        Promise.all(viewsWithImages(currentView()).flatMap(({scene, view}) => ['truth', 'mote4'].map(async name =>
            [scene, name, (await viewImages.codes(runs[0], scene, view, name)).codes.join('')]))).then(done)"""

    def part_images(self):
        """A copy of a run in which all views' images but the first's lie beside the page, as the program
        has it where they are too many."""
        run = self.folder / "parted"
        shutil.copytree(self.folder / "before", run)
        begin, rest = (run / "report.html").read_text().split('<script type="application/json" id="images">')
        text, end = rest.split("</script>", 1)
        packed = json.loads(text)
        for key, view in list(packed[0].items())[1:]:
            view["beside"] = f"images/{key.replace(chr(10), '/')}/page.js"
            images = {name: view.pop(name) for name in ("truth", "images", "inks")}
            (run / view["beside"]).write_text(f"document.currentScript.images={json.dumps(images)};\n")
        (run / "report.html").write_text(f'{begin}<script type="application/json" id="images">{json.dumps(packed)}</script>{end}')
        return run

    def test_images_beside_the_page_are_those_within_and_may_be_missing(self):
        self.open()
        within = self.browser.execute_async_script(self.CODES)
        self.assertEqual(len(within), 6)
        run = self.part_images()
        self.open(run / "report.html")
        self.assertEqual(self.browser.execute_async_script(self.CODES), within)
        self.assertIn("for the images of 2 views the folder images of its run", self.find("footer").text)
        self.harmless = ("page.js",)
        self.open(shutil.copy(run / "report.html", self.folder / "alone.html"), "#scene=torus", part="pictures")
        self.wait(lambda: "The images of 2 views are in the folder images of the run" in self.find("#pictures").text)
        self.wait(lambda: "cube" in (self.find("canvas.stage").get_attribute("data-drawn") or ""))
        self.assertEqual(self.browser.execute_async_script(self.CODES), within[:2])

    def test_page_needs_no_network(self):
        text = (self.folder / "before" / "report.html").read_text()
        self.open()
        loaded = self.script("return performance.getEntriesByType('resource').map(e => e.name)"
                             ".filter(name => !name.startsWith('data:'))")
        self.assertEqual(loaded, [])
        self.assertNotIn("src=\"http", text)

    # ---- Filters and state ----------------------------------------------------------------

    def test_filter_leaves_out_a_method_and_stands_in_the_address(self):
        self.open(part="verdict")
        self.assertIn("edge_hash", self.column("verdict", 0))
        self.assertEqual(self.address(), "")
        self.find('details.picker[data-name="methods"] summary').click()
        self.find('.picker-list input[value="edge_hash"]').click()
        self.show("verdict")
        self.wait(lambda: "edge_hash" not in self.column("verdict", 0))
        self.assertEqual(self.address(), "#methods=mote4,ids")
        self.open(address="#methods=mote4,ids", part="verdict")
        self.assertNotIn("edge_hash", self.column("verdict", 0))
        self.find("#reset").click()
        self.wait(lambda: self.address() == "")

    def test_a_filter_sums_no_settings_that_are_not_shown(self):
        self.open(part="time")
        self.script("window.sums = 0; for (const name of ['settingsOf', 'sweptMethods']) {"
                    "const sum = window[name]; window[name] = view => { ++sums; return sum(view); }; }")
        self.script("state.set({scenes: ['cube']})")
        self.assertEqual(self.script("return sums"), 0)
        self.script("state.set({'time.settings': true})")
        self.wait(lambda: self.find_all("#time path.setting"))
        self.assertEqual(self.script("return sums"), 1)

    def test_measure_and_scene_change_the_numbers(self):
        self.open(address="#scenes=cube&measure=crease", part="verdict")
        expected = self.script(
            "const rows = runs[0].rows.filter(r => r.method === 'mote4' && r.scene === 'cube');"
            "return d3.sum(rows, r => r.k_crease) / d3.sum(rows, r => r.truth_px_crease)")
        line = self.column("verdict", 0).index("mote4")
        self.assertEqual(self.column("verdict", 1)[line], f"{expected:.3f}")

    def test_budget_names_the_best_that_fits(self):
        self.open()
        fastest = self.script(
            "return currentView().contestants.reduce((a, b) => a.ms < b.ms ? a : b)")
        self.script("state.set({budget: arguments[0]})", fastest["ms"] * 1.0001)
        self.wait(lambda: "Within" in self.find("h1").text)
        self.assertIn(fastest["method"], self.find("h1").text)

    def test_table_sorts_both_ways_and_keeps_it_in_the_address(self):
        self.open(part="verdict")
        head = "#verdict thead tr:last-child th:nth-child(2) button"
        numbers = lambda: [float(v) for v in self.column("verdict", 1)]
        self.assertEqual(numbers(), sorted(numbers(), reverse=True))
        self.find(head).click()
        self.wait(lambda: numbers() == sorted(numbers()))
        self.assertIn("sort.verdict=value.up", self.address())

    # ---- Pointer, viewer, charts -----------------------------------------------------------

    def test_pointer_on_a_point_shows_its_image_and_a_click_blinks_the_truth(self):
        self.open(part="time")
        point = self.find('#time .point[data-method="ids"]')
        self.script("arguments[0].scrollIntoView({block: 'center'})", point)
        webdriver.ActionChains(self.browser).move_to_element(point).perform()
        self.wait(lambda: self.script("return card.node && !card.node.hidden"))
        self.assertIn("ids", self.find(".card-head").text)
        self.wait(lambda: self.script("return !card.canvas.hidden && card.canvas.width > 10"))
        point.click()
        self.wait(lambda: self.find(".card.pinned").is_displayed())
        seen = set()
        self.wait(lambda: seen.add(self.find(".card .note").text) or len(seen - {""}) == 2)
        self.assertIn("the truth", seen)
        self.find(".card button.main").click()
        self.wait(lambda: "right=ids" in self.address())

    def test_viewer_shows_errors_in_colour(self):
        self.open(address="#right=mote4&scene=cube", part="pictures")
        self.wait(lambda: "mote4" in (self.find("canvas.stage").get_attribute("data-drawn") or ""))
        wrong = self.script(
            "const row = runs[0].rows.find(r => r.method === 'mote4' && r.scene === 'cube');"
            "return row.false_negatives + row.false_positives")
        done = self.browser.execute_async_script(
            "const done = arguments[0]; const row = runs[0].rows.find(r => r.method === 'mote4' && r.scene === 'cube');"
            "viewImages.codes(runs[0], row.scene, row.view, 'mote4').then(image =>"
            " done([image.width, image.height, image.codes.filter(code => code >= FIRST_WRONG).length,"
            " image.codes.filter(code => code === 2).length]))")
        self.assertEqual(done[:2], [160, 90])
        self.assertGreater(done[3], 50)
        if wrong:
            self.assertGreater(done[2], 0)

    def test_viewer_shows_ink_with_its_grey(self):
        self.open(self.folder / "ink" / "report.html")
        colours = self.browser.execute_async_script(
            "const done = arguments[0]; const {scene, view} = runs[0].rows[0];"
            "const colours = (image, look) => new Set(new Uint32Array(paintCodes(image, look).getContext('2d')"
            "    .getImageData(0, 0, image.width, image.height).data.buffer)).size;"
            "Promise.all(['strokes', 'ids'].map(method => viewImages.codes(runs[0], scene, view, method))).then(images =>"
            "    done(images.map(image => ['errors', 'causes', 'drawn'].map(look => colours(image, look)))))")
        self.assertGreater(min(colours[0]), 50, "strokes")
        self.assertLess(max(colours[1]), 10, "ids")

    def test_chart_toggles_its_axis(self):
        self.open(part="time")
        ticks = lambda: self.script(
            "return [...document.querySelectorAll('#chart-error-time .axis:first-of-type .tick')].map(t => t.textContent)")
        before = ticks()
        button = [b for b in self.find_all("#time .toggle") if b.text == "log x"][0]
        self.assertEqual(button.get_attribute("aria-pressed"), "true")
        button.click()
        self.wait(lambda: ticks() and ticks() != before)
        self.assertEqual(self.address(), "#time.xlog=0")

    def test_chart_leaves_as_svg_and_csv(self):
        self.open(part="time")
        self.script("window.saved = []; saveFile = (name, type, text) => window.saved.push([name, type, text])")
        for button in self.find_all("#chart-error-time .chart-head button.quiet"):
            button.click()
        saved = self.script("return window.saved")
        self.assertEqual([file[0] for file in saved], ["error-time.svg", "error-time.csv"])
        self.assertIn("<svg", saved[0][2])
        self.assertNotIn("var(--", saved[0][2])
        lines = list(csv.reader(saved[1][2].splitlines()))
        self.assertEqual(lines[0][0], "method")
        self.assertIn("mote4", [line[0] for line in lines])

    # ---- Runs that compare nothing ----------------------------------------------------------

    def test_a_search_and_axes_have_their_finding_as_title(self):
        usual = ["--size", "160x90"]
        said = inkbench("tune", "mote4", "--scenes", "cube,torus", "--unseen", "gear", "--evaluations", "6", *usual,
                        "--out", self.folder / "tune")
        said += inkbench("stress", "--axes", "grazing", "--points", "3", "--methods", "mote4,ids", *usual,
                         "--out", self.folder / "stress")
        for run, words in (("tune", r": F [+-]\.[0-9]+ where it searched, [+-]\.[0-9]+ on gear: "), ("stress", "breaks mote4 first")):
            self.open(self.folder / run / "report.html")
            self.assertRegex(self.find("h1").text, words)
            self.assertIn(self.find("h1").text, said)

    # ---- Two runs --------------------------------------------------------------------------

    def test_two_runs_show_the_changed_threshold(self):
        section = self.open(self.page, part="runs")
        self.assertIn("mote4.threshold", section.text)
        self.assertIn("40", section.text)
        first = self.column("runs", 0)
        self.assertIn("mote4.threshold", first)
        self.assertIn("Results changed for mote4;", section.text)
        same = self.script("return runLines(viewOf(runs[0]), viewOf(runs[1]), 'f_2px')"
                           ".map(line => [line.method, line.isSame])")
        self.assertEqual(dict(same), {"mote4": False, "ids": True, "edge_hash": True})

    def test_second_run_can_be_shown(self):
        self.open(self.page, "#run=1")
        Select(self.find("#filters select")).select_by_visible_text("before")
        self.wait(lambda: self.address() == "")

    # ---- Warnings ---------------------------------------------------------------------------

    def test_a_run_that_is_not_finished_says_so_before_its_finding(self):
        half = self.folder / "half"
        shutil.copytree(self.folder / "before", half)
        record = (half / "run.toml").read_text()
        (half / "run.toml").write_text(record.replace("state = 'finished'", "state = 'unfinished'\nmissing = [ 'torus' ]"))
        inkbench("report", half, "-o", self.folder / "half.html")
        self.open(self.folder / "half.html")
        self.assertIn("not finished", self.find("header .warning").text)
        self.assertLess(self.find("header .warning").location["y"], self.find("h1").location["y"])

    def test_a_failed_view_is_seen_without_scrolling(self):
        # As a run names a view whose truth is disputed.
        cut = self.folder / "cut"
        shutil.copytree(self.folder / "before", cut)
        with open(cut / "unscored.csv", "a") as file:
            file.write("cube,front,,the two references differ,try --crease 60\n")
        inkbench("report", cut, "-o", self.folder / "cut.html")
        self.open(self.folder / "cut.html")
        warning = self.find(".warning")
        self.assertIn("the two references differ", warning.text)
        self.assertLess(warning.location["y"], 500)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + ["-v"] + sys.argv[1:])
