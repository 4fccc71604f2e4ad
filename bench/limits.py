#!/usr/bin/python3
"""Our frames beside those of a prototype, stage by stage, as ratios of times of the same minutes.

    bench/limits.py PROTOTYPE [--model FILE]... [--mesh NAME]... [--rounds 5] [--readme]

PROTOTYPE is `raster_limits.cpp`, which is then compiled, or the program made of it: a hand-written
frame for AVX-512 that leaves out what a renderer must do. It draws closed surfaces only (no triangle
seen from its back), one value a triangle, vertices snapped to 1/16 px, without clipping and tiles. It
is no part of the project. Without it there is nothing to hold frames against, and the script says so.

ink_bench writes its meshes as OBJ, the prototype reads them, and both draw what the prototype's
camera sees, in turns on one core. The stages of each are differences of least times over all rounds;
--model adds a mesh of yours, such as the dragon that `experiments/models/fetch dragon` gets. With
--readme the tables also replace the block between <!-- limits --> and <!-- /limits --> in
bench/README.md. Needs g++ (for a source), and Python.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from table import NS, ROOT, number, put_in_block

# Rows of the prototype's table, and the stage of ours that holds as much. `lists` is ours alone.
STAGES = [
    ("cull", "cull"),
    ("cull + transform", "transform"),
    (None, "lists"),
    ("cull + transform + setup", "setup"),
    ("depth32 + u8 G-buffer", "fill"),
    ("whole frame: depth32 + u8 + Laplacian", "edges"),
]
WHOLE = STAGES[-1][0]
# what is drawn, the middle of the benchmarks' names
KINDS = [
    ("both sides, smooth", "both/smooth"),
    ("both sides, flat", "both/flat"),
    ("fronts, smooth", "front/smooth"),
    ("fronts, flat", "front/flat"),
]
METHODS = ["mote4", "surface8", "label8", "ids"]


class Trouble(Exception):
    """What went wrong, and what is accepted."""


def make_prototype(path, folder):
    """The program: `path` itself, or what it compiles to."""
    if not path.is_file():
        raise Trouble(f"{path}: no such file (accepted: raster_limits.cpp, the prototype, or the "
                      "program made of it; bench/README.md says what it is)")
    if path.suffix != ".cpp":
        return path.resolve()
    program = folder / "raster_limits"
    command = ["g++", "-O3", "-march=native", "-std=c++17", "-pthread", "-w", path, "-o", program]
    made = subprocess.run(command, capture_output=True, text=True, check=False)
    if made.returncode != 0:
        last = made.stderr.strip().splitlines()[:1]
        raise Trouble(f"{path}: g++ does not compile it here: {' '.join(last)} (accepted: a CPU with "
                      "AVX-512 and its headers)")
    return program


class Least:
    """Least times in ms, by name."""

    def __init__(self):
        self.ms = {}
        self.labels = {}

    def add(self, name, ms):
        self.ms[name] = min(ms, self.ms.get(name, ms))


def run_prototype(program, mesh_file, cores, threads, seconds, least):
    """One run over one mesh; its table's least column."""
    environment = {**os.environ, "BENCH_SECONDS": str(seconds)}
    command = [program, str(threads), "1920", "1080", f"obj:{mesh_file}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment,
                          preexec_fn=lambda: os.sched_setaffinity(0, cores))
    if done.returncode != 0:
        raise Trouble(f"{program}: ended with {done.returncode} on {mesh_file}: "
                      f"{(done.stdout + done.stderr).strip()[-200:]} (accepted: 0)")
    for line in done.stdout.splitlines():
        row = re.match(r"(.+?)\s{2,}([0-9.]+)\s+([0-9.]+)\s", line)
        if row:
            least.add(row.group(1).strip(), float(row.group(3)))


def run_ours(program, names, flags, cores, least):
    """One run of the benchmarks with these names."""
    pattern = "^(" + "|".join(names) + ")$"
    command = [program, *flags, f"--benchmark_filter={pattern}", "--benchmark_format=json",
               "--benchmark_repetitions=5", "--benchmark_min_time=0.004"]
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: os.sched_setaffinity(0, cores))
    if done.returncode != 0:
        raise Trouble(f"{program}: ended with {done.returncode}: {done.stderr.strip()[-200:]} "
                      "(accepted: 0)")
    for entry in json.loads(done.stdout)["benchmarks"]:
        if entry.get("run_type") == "iteration":
            least.add(entry["run_name"], entry["real_time"] * NS[entry["time_unit"]] / 1e6)
            least.labels[entry["run_name"]] = entry


def steps(cumulative):
    """Differences of cumulative times; None where there is none, whose time goes to the next."""
    last, result = 0.0, []
    for value in cumulative:
        result.append(None if value is None else value - last)
        last = last if value is None else value
    return result


def cell(value):
    return "-" if value is None else f"{value:.2f}"


def frame_row(mesh, triangles, theirs, ours, two):
    whole = theirs.ms[WHOLE]
    one = [ours.ms[f"limit/{method}/{mesh}/threads:1"] for method in METHODS]
    twice = two.ms.get(f"limit/mote4/{mesh}/threads:2")
    cells = [f"`{mesh}`", f"{triangles / 1e3:.0f} k", number(whole), number(one[0] / whole)]
    cells += [number(ms / one[0]) for ms in one[1:]]
    cells.append("-" if twice is None else number(one[0] / twice))
    return "| " + " | ".join(cells) + " |"


def stage_rows(mesh, theirs, ours):
    whole = theirs.ms[WHOLE]
    lines = []
    limit = [None if name is None else theirs.ms[name] for name, _ in STAGES]
    kinds = [("prototype", limit)]
    for title, kind in KINDS:
        kinds.append((title, [ours.ms[f"limit/{stage}/{kind}/{mesh}"] for _, stage in STAGES]))
    for title, cumulative in kinds:
        shares = [None if ms is None else ms / whole for ms in steps(cumulative)]
        cells = [f"`{mesh}`", title, *map(cell, shares), cell(cumulative[-1] / whole)]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def measure(options, folder):
    """Both tables as Markdown."""
    prototype = make_prototype(options.prototype, folder)
    flags = [f"--model={path}" for path in options.model]
    subprocess.run([options.program, *flags, f"--write-meshes={folder}"], check=True)
    meshes = options.mesh or sorted(path.stem for path in folder.glob("*.obj"))
    for mesh in meshes:
        if not (folder / f"{mesh}.obj").is_file():
            known = ", ".join(sorted(path.stem for path in folder.glob("*.obj")))
            raise Trouble(f"--mesh: '{mesh}' (accepted: {known})")
    allowed = sorted(os.sched_getaffinity(0))
    core = {allowed[-1]}
    frames = ["| mesh | triangles | prototype, ms | `mote4` / prototype | `surface8` / `mote4` | "
              "`label8` / `mote4` | `ids` / `mote4` | two threads, `mote4` |",
              "|---|--:|--:|--:|--:|--:|--:|--:|"]
    stages = ["| mesh | what | cull | transform | lists | setup | fill | edges | frame |",
              "|---|---|--:|--:|--:|--:|--:|--:|--:|"]
    for mesh in meshes:
        theirs, ours, two = Least(), Least(), Least()
        kinds = [f"limit/{stage}/{kind}/{mesh}" for _, stage in STAGES for _, kind in KINDS]
        methods = [f"limit/{method}/{mesh}/threads:1" for method in METHODS]
        for _ in range(options.rounds):
            run_prototype(prototype, folder / f"{mesh}.obj", core, 1, options.seconds, theirs)
            run_ours(options.program, kinds + methods, flags, core, ours)
            if len(allowed) > 1:
                run_ours(options.program, [f"limit/mote4/{mesh}/threads:2"], flags, set(allowed), two)
        triangles = ours.labels[methods[0]]["triangles"]
        frames.append(frame_row(mesh, triangles, theirs, ours, two))
        stages += stage_rows(mesh, theirs, ours)
        print(frames[-1], *stages[-5:], sep="\n", file=sys.stderr)
    return "\n".join([*frames, "", "Stages, in frames of the prototype on the same mesh:", "",
                      *stages])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("prototype", type=Path, help="raster_limits.cpp, or the program made of it")
    parser.add_argument("--model", action="append", default=[], type=Path, metavar="FILE",
                        help="a model to draw as well")
    parser.add_argument("--mesh", action="append", default=[], metavar="NAME",
                        help="only this mesh (again for more); default: all")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=0.1,
                        help="that the prototype spends on each of its rows in a round")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/ink_bench")
    parser.add_argument("--readme", nargs="?", const=ROOT / "bench/README.md", type=Path,
                        help="replace the block in this file (bench/README.md)")
    options = parser.parse_args()
    try:
        with tempfile.TemporaryDirectory() as folder:
            text = measure(options, Path(folder))
        if options.readme:
            put_in_block("limits", text, options.readme)
    except (Trouble, OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        print(f"limits.py: {error}", file=sys.stderr)
        return 2
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
