#!/usr/bin/python3
"""The table of speeds: ours beside what others do in the same run of ink_bench, as ratios.

    bench/table.py [FILE.json] [--readme] [--program PATH]

Reads what ink_bench wrote with --benchmark_out; without a file it runs ink_bench on what the table
needs (some minutes) and leaves the JSON beside the program. Prints Markdown. With --readme the
table also replaces the block between <!-- speed --> and <!-- /speed --> in bench/README.md. What was
not run is marked. Needs nothing but Python.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


class NotRun(Exception):
    """A benchmark that the file does not hold."""


class Run:
    """Least times of one run of ink_bench: processor time of one thread, time on the wall of two."""

    def __init__(self, data):
        self.context = data.get("context", {})
        self.least_ns = {}
        self.repetitions = {}
        for entry in data["benchmarks"]:
            is_repetition = entry.get("run_type") == "iteration"
            if not is_repetition and entry.get("aggregate_name") != "min":
                continue
            if entry.get("error_occurred"):
                continue
            name = entry["run_name"]
            clock = "real_time" if "/threads:2" in name else "cpu_time"
            time_ns = entry[clock] * NS[entry["time_unit"]]
            self.least_ns[name] = min(time_ns, self.least_ns.get(name, time_ns))
            if is_repetition:
                self.repetitions[name] = self.repetitions.get(name, 0) + 1

    def ns(self, name):
        if name not in self.least_ns:
            raise NotRun(name)
        return self.least_ns[name]

    def ms(self, *names):
        return sum(self.ns(name) for name in names) / 1e6

    def times(self, slow, quick):
        """How many times `quick` goes into `slow`."""
        return self.ns(slow) / self.ns(quick)


def number(value):
    digits = 0 if value >= 100 else 1 if value >= 10 else 2
    return f"{value:.{digits}f}"


class Check:
    """A value of ours beside its goal; `goal` None: shown only."""

    def __init__(self, value, unit, at_most=None, at_least=None):
        self.value, self.unit = value, unit
        self.at_most, self.at_least = at_most, at_least

    def judge(self, run):
        """(text, True, False or None)"""
        value = self.value(run)
        text = f"{number(value)} {self.unit}"
        if self.at_most is None and self.at_least is None:
            return text, None
        is_met = self.at_most is None or value <= self.at_most
        is_met = is_met and (self.at_least is None or value >= self.at_least)
        return text if is_met else f"**{text}**", is_met


class Row:
    def __init__(self, work, others, goal, checks):
        self.work, self.others, self.goal, self.checks = work, others, goal, checks

    def cells(self, run):
        texts, verdicts, missing = [], [], []
        for check in self.checks:
            try:
                text, is_met = check.judge(run)
                texts.append(text)
                verdicts.append(is_met)
            except NotRun as name:
                missing.append(str(name))
        if missing:
            texts.append("not run: " + ", ".join(f"`{n}`" for n in dict.fromkeys(missing)))
        return [self.work, self.others, self.goal, "; ".join(texts), verdict(verdicts, missing)]


def verdict(verdicts, missing):
    if False in verdicts:
        return "missed"
    if missing:
        return "not run"
    return "met" if True in verdicts else "-"


def in_ms(name):
    return Check(lambda run: run.ms(name), "ms")


def gain(slow, quick, what, **goal):
    return Check(lambda run: run.times(slow, quick), what, **goal)


def filter_row(work, store, goal, copy, over_opencv):
    ours = f"filter/laplacian/{store}/1080p"
    return Row(work, "a copy of as many bytes, OpenCV", goal, [
        gain(f"memcpy/{store}/1080p", ours, "of copy", at_least=copy),
        gain(f"opencv/laplacian/{store}/1080p", ours, "x OpenCV", at_least=over_opencv),
    ])


def frame_row(work, mesh, others=""):
    return Row(work, others + "Embree's primary rays", "the quicker", [
        in_ms(frame(mesh)),
        gain(f"embree/primary/{mesh}/1080p/threads:1", frame(mesh), "x Embree", at_least=1)])


def frame(mesh, threads=1, method="mote4"):
    return f"frame/{method}/{mesh}/1080p/threads:{threads}"


def two_threads(work, one, two):
    return Row(work, "", ">= 1.85 x one", [gain(one, two, "x", at_least=1.85)])


LINES = ["truth/dragon_coarse/1080p/eye", "truth/dragon_coarse/1080p/bvh", "truth/dragon_coarse/1080p/lines"]


def rows():
    u8 = "filter/laplacian/u8/1080p"
    dense = "truth_dense/dragon_coarse/1080p"
    return [
        filter_row("u8 four-neighbour Laplacian, scale, clip", "u8", ">= 9 x OpenCV", None, 9),
        filter_row("u16 the same", "u16", "0.97 of copy, 14 x OpenCV", 0.97, 14),
        filter_row("4 x f32 Laplacian, sum, threshold", "f32x4", "0.9 of copy, 5.3 x OpenCV",
                   0.9, 5.3),
        frame_row("whole frame, `mote4`: byte pack, depth and filter, coarse dragon (47 k triangles)",
                  "dragon_coarse"),
        frame_row("the same, dragon (871 k triangles)", "dragon"),
        two_threads("two threads, whole frame, coarse dragon", frame("dragon_coarse"), frame("dragon_coarse", 2)),
        two_threads("two threads, whole frame, dragon",
                    frame("dragon"), frame("dragon", 2)),
        two_threads("two threads, u8 filter", u8, u8 + "/threads:2"),
        Row("truth of the coarse dragon's lines (facing, tree, lines)",
            "16 x 16 rays in every pixel",
            "under 100 ms, >= 20 x less than dense rays",
            [Check(lambda run: run.ms(*LINES), "ms", at_most=100),
             Check(lambda run: run.ns(dense) / (run.ms(*LINES) * 1e6), "x less", at_least=20)]),
        Row("dense rays only where corners differ, coarse dragon", "17-23 x less\\*", ">= 20 x less",
            [gain(dense, "truth_adaptive/dragon_coarse/1080p", "x less", at_least=20)]),
        Row("scorer, 36 k truth pixels", "BSDS 29 s\\*", "< 25 ms",
            [Check(lambda run: run.ms("score/36k"), "ms", at_most=25)]),
        Row("1998's claim, whole frame, coarse dragon: `mote4` before `decaudin`", "`decaudin`",
            "the quicker", [gain(frame("dragon_coarse", method="decaudin"), frame("dragon_coarse"), "x", at_least=1)]),
        Row("the same, filter alone", "`decaudin`", "the quicker",
            [gain("filter/decaudin/1080p", u8, "x", at_least=1)]),
        Row("the same, raster alone, coarse dragon: one interpolant before four", "four floats",
            "the quicker",
            [gain("raster/f32x4/dragon_coarse/1080p/threads:1", "raster/u8/dragon_coarse/1080p/threads:1", "x",
                  at_least=1)]),
    ]


def needed():
    """The names that the table asks for, found by asking an empty run."""
    names = {}

    class Asked(Run):
        def ns(self, name):
            names[name] = None
            return 1.0

    asked = Asked({"benchmarks": []})
    for row in rows():
        row.cells(asked)
    return list(names)


def table(run):
    lines = ["| work | beside | aim | ours | |", "|---|---|---|---|---|"]
    lines += ["| " + " | ".join(row.cells(run)) + " |" for row in rows()]
    return "\n".join(lines + ["", footing(run)])


def footing(run):
    """Where and how it was measured."""
    context = run.context
    facts = []
    if run.repetitions:
        facts.append(f"Least of {min(run.repetitions.values())} or more interleaved repetitions")
    for key, before in (("cpu", ""), ("simd", ""), ("commit", "commit ")):
        if key in context:
            facts.append(before + context[key])
    if "date" in context:
        facts.append(context["date"][:10])
    return ("1920x1080, one pinned thread by default; bold is missed; \\* was measured on another "
            "machine. " + ", ".join(facts) + ".")


def put_in_block(name, text, path):
    """Replaces what stands between <!-- name --> and <!-- /name --> in a file."""
    begin, end = f"<!-- {name} -->", f"<!-- /{name} -->"
    old = path.read_text(encoding="utf-8")
    first, last = old.find(begin), old.find(end)
    if first < 0 or last < first:
        raise ValueError(f"{path}: no block between {begin} and {end}")
    path.write_text(f"{old[:first]}{begin}\n{text}\n{old[last:]}", encoding="utf-8")


def measure(program):
    """Runs what the table needs; the file it wrote."""
    out = program.resolve().parent / "speed.json"
    pattern = "^(" + "|".join(needed()) + ")$"
    subprocess.run([program, f"--benchmark_filter={pattern}", f"--benchmark_out={out}"],
                   check=True, stdout=subprocess.DEVNULL)
    return out


def read(path):
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    if not isinstance(data, dict) or "benchmarks" not in data:
        raise ValueError(f"{path}: no benchmarks in it (accepted: ink_bench's JSON)")
    return Run(data)


def run_script(page, block, add_options, text_of):
    """What both scripts do: print what `text_of` makes of the options, and put it in a README."""
    parser = argparse.ArgumentParser(description=page.split("\n", 1)[0])
    add_options(parser.add_argument)
    parser.add_argument("--readme", nargs="?", const=ROOT / "bench/README.md", type=Path,
                        help="replace the block in this file (bench/README.md)")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/ink_bench")
    options = parser.parse_args()
    try:
        text = text_of(options)
        if options.readme:
            put_in_block(block, text, options.readme)
    except (OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 2
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(run_script(
        __doc__, "speed",
        lambda add: add("json", nargs="?", help="what ink_bench wrote; without it, it is run"),
        lambda options: table(read(options.json or measure(options.program)))))
