#!/usr/bin/python3
"""Instructions of the hot kernels, counted by valgrind's callgrind, as a Markdown table.

    bench/callgrind.py [--simd AVX2] [--mesh dragon_coarse] [--method mote4] [--functions] [--readme]

Filters: what one call of a row kernel costs, all it calls included, over its pixels. Stages of a
frame: what three draws cost more than one, halved, so that nothing of the start is in it, summed
over the functions of each stage (the table STAGES; --functions prints which function went where).
valgrind knows AVX2 but not AVX-512, so the instruction set is forced. Counts do not depend on the
machine's load; they do on compiler and flags. With --readme the table also replaces the block
between <!-- instructions --> and <!-- /instructions --> in bench/README.md. Needs valgrind and
Python.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from table import run_script

WIDTH_PX, HEIGHT_PX = 1920, 1080

# kernel, benchmark that calls it, function: one call is the whole picture
FILTERS = [
    ("Laplacian, u8", "filter/laplacian/u8/1080p", r"edge::laplacian\(ink::core::ImageView<unsigned char"),
    ("Laplacian, u16", "filter/laplacian/u16/1080p",
     r"edge::laplacian\(ink::core::ImageView<unsigned short"),
    ("Laplacian, 4 x f32", "filter/laplacian/f32x4/1080p", r"edge::laplacian_f32x4\("),
    ("Decaudin's two passes, four channels", "filter/decaudin/1080p", r"edge::decaudin\("),
]

# stage, functions whose own instructions it sums (the first that matches takes them), unit
STAGES = [
    ("vertices: place and values",
     r"::(ProjectCluster|project_cluster|PackSnapped|ComputePlane|ComputeLinear|compute_linear)\(|"
     r"compute_scalar_values|Values::compute|SurfaceInputs::|raster::(to_screen|outcode)\(|"
     r"put_on_screen|::encode_", "vertex"),
    ("facing, samples, clipping",
     r"::(CullCluster|cull_cluster|CullTriangles<)|settle_sides|scene::(facings|orient3d)|"
     r"raster::clip|ImageSides::|FrontDepth::hides", "triangle"),
    ("setup", r"::(SetUpLanes|set_up\w*|Collect|collect_corners)\(|TriangleStage::|PlaneMaker::|make_\w+_plane|"
              r"MeshRun::(add|process|store)\w*\(", "triangle"),
    ("binning", r"MeshRun::bin_\w+\(|raster::Bins::|::(ListTriangles|ListAllTriangles)\(|"
                r"list_(all_)?triangles\(", "triangle"),
    ("fill", r"raster::N_\w+::(Fill<|FindMicroTriangles|FindIn<|FindFragments|KeepFragments)|fill_fragments\(|MicroTriangleRun::|fill_lanes\(|fill_tile|covered_span|TileBuffer::|TileWorker::|"
             r"memset", "pixel"),
    ("filter", r"edge::(N_\w+::)?\w*([Ll]aplacian|[Dd]ecaudin|[Rr]espond)|Sink::", "pixel"),
]

# The same of methods that look lines up, a pixel: these take a function first, and are printed if they
# cost anything.
LINE_STAGES = [
    ("sides listed", r"methods::(N_\w+::)?(list_in|list_sides|AskedSides)|SampleFaces::"),
    ("walks", r"ScreenMesh::|each_lined_side|(Strokes|Chords)::look|SideLookup::"),
    ("pieces", r"CellStrokes::|LineFollower::|(Strokes|Chords)::(join|begin|touch_up)|__popcountdi2|"
               r"methods::Piece.*emplace_back|methods::(\(anonymous namespace\)::)?"
               r"(end_in_cell|near_sides|is_seen|clip_to_cell|edge_segment|intersection_segment|plane_q|depth_plane)"),
    ("ink", r"methods::((N_\w+::)?(draw_in|own_strip)|draw_ink|draw_pieces|.*see_from|InkPiece.*emplace_back)"),
]

# Threads that wait for each other at the start, as long as it takes: no part of a frame.
WAITING = r"wake_worker|steady_clock|clock_gettime|vdso"


class Profile:
    """Own and inclusive instructions per function, and its calls, of one callgrind file."""

    def __init__(self, path):
        self.own, self.inclusive, self.calls = {}, {}, {}
        self.names = {}
        function = None
        called = None
        with open(path, encoding="utf-8", errors="replace") as file:
            for line in file:
                if line.startswith("fn="):
                    function = self.name(line[3:])
                elif line.startswith("cfn="):
                    called = self.name(line[4:])
                elif line.startswith("calls="):
                    count = int(line[6:].split()[0])
                    self.calls[called] = self.calls.get(called, 0) + count
                    cost = int(next(file).split()[1])
                    self.add(self.inclusive, function, cost)
                elif line[:1] in "0123456789+-*" and function is not None:
                    cost = int(line.split()[1])
                    self.add(self.own, function, cost)
                    self.add(self.inclusive, function, cost)

    @staticmethod
    def add(costs, function, cost):
        costs[function] = costs.get(function, 0) + cost

    def name(self, text):
        """`(12) name` the first time, `(12)` from then on."""
        number, _, name = text.strip().partition(" ")
        if name:
            self.names[number] = name
        return self.names[number]


class Counter:
    """Runs one benchmark under callgrind."""

    def __init__(self, program, simd, folder):
        self.program, self.simd, self.folder = program, simd, Path(folder)

    def run(self, benchmark, *flags):
        """Its profile and the counters it reported; None if there is no such benchmark."""
        out, result = self.folder / "callgrind.out", self.folder / "result.json"
        for path in (out, result):
            path.unlink(missing_ok=True)
        ran = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", self.program,
             f"--simd={self.simd}", f"--benchmark_filter=^{benchmark}(/iterations:[0-9]+)?$",
             "--benchmark_repetitions=1", "--benchmark_min_time=1e-9",
             f"--benchmark_out={result}", *flags],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        if "Failed to match any benchmarks" in ran.stderr:
            return None
        if ran.returncode != 0:
            told = [line for line in ran.stderr.splitlines() if not line.startswith("==")]
            raise ValueError(" ".join(told) or f"valgrind: exit code {ran.returncode}")
        report = json.loads(result.read_text(encoding="utf-8"))
        return Profile(out), report["benchmarks"][0]


def filter_lines(counter):
    for kernel, benchmark, pattern in FILTERS:
        ran = counter.run(benchmark)
        found = [name for name in ran[0].calls if re.search(pattern, name)] if ran else []
        if not found:
            yield f"| {kernel} | `{benchmark}` | pixel | not run |"
            continue
        # The outermost of several is the one that costs most.
        name = max(found, key=lambda each: ran[0].inclusive.get(each, 0))
        per_image = ran[0].inclusive[name] / ran[0].calls[name]
        pixels = WIDTH_PX * HEIGHT_PX
        yield f"| {kernel} | `{benchmark}` | pixel | {per_image / pixels:.2f} |"


def stage_of(function):
    for stage, pattern, *_ in LINE_STAGES + STAGES:
        if re.search(pattern, function):
            return stage
    return "the rest"


def frame_lines(counter, benchmark, with_functions):
    one, three = counter.run(benchmark, "--draws=1"), counter.run(benchmark, "--draws=3")
    if one is None or three is None:
        yield f"| whole frame | `{benchmark}` | pixel | not run |"
        return
    units = {"pixel": WIDTH_PX * HEIGHT_PX, "triangle": three[1]["triangles"],
             "vertex": three[1]["vertices"]}
    costs = {name: (cost - one[0].own.get(name, 0)) / 2 for name, cost in three[0].own.items()}
    costs = {name: cost for name, cost in costs.items()
             if cost > 0 and not re.search(WAITING, name)}
    total = sum(costs.values())
    stages = {stage: 0 for stage, _, _ in STAGES}
    for name, cost in costs.items():
        stages[stage_of(name)] = stages.get(stage_of(name), 0) + cost
    unit_of = {stage: unit for stage, _, unit in STAGES}
    for stage, cost in [("whole frame", total), *stages.items()]:
        unit = unit_of.get(stage, "pixel")
        share = f", {100 * cost / total:.0f} % of the frame" if stage != "whole frame" else ""
        yield (f"| {stage}{share} | `{benchmark}` | {unit} | {cost / units[unit]:.2f} |")
    if with_functions:
        for name, cost in sorted(costs.items(), key=lambda item: -item[1])[:40]:
            print(f"{cost:14.0f}  {stage_of(name):28}  {name[:120]}", file=sys.stderr)


def add_options(add):
    add("--simd", default="AVX2", help="instruction set that kernels run on")
    add("--mesh", default="dragon_coarse")
    add("--method", default="mote4")
    add("--functions", action="store_true", help="which function went to which stage, on stderr")


def lines_of(options):
    frame = f"frame/{options.method}/{options.mesh}/1080p/threads:1"
    lines = [f"| kernel ({options.simd}) | benchmark | per | instructions |", "|---|---|---|--:|"]
    with tempfile.TemporaryDirectory() as folder:
        counter = Counter(options.program, options.simd, folder)
        lines += filter_lines(counter)
        lines += frame_lines(counter, frame, options.functions)
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(run_script(__doc__, "instructions", add_options, lines_of))
