#!/usr/bin/python3
"""Prints the table of drawings.md: our exact drawings of parallel views beside Open CASCADE's.

    experiments/drawings.py build/release/inkbench [--out FOLDER] [--seconds N] [SCENE | MODEL ...]

One line of Markdown per model, view and algorithm of Open CASCADE: seconds of either, which share of
the length of either drawing has a line of the other within 0.25 px, and px of lines that the other
drawing has as hidden. Drawings stay in FOLDER and are not made again. Needs python3-scipy.
"""

import argparse
import json
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy
from scipy.spatial import cKDTree

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "methods/outside"), str(ROOT / "methods/outside/open_cascade")]

import open_cascade  # noqa: E402
from entrant import Failed, read_view  # noqa: E402

VIEWS = ("front", "top", "iso")
ALGORITHMS = ("exact", "polygonal")
MODELS = ("bracket", "gear", "inkbench-out/models/human.glb", "inkbench-out/models/jeep.glb",
          "inkbench-out/models/house.glb")
NEAR_PX = 0.25
STEP_PX = 0.05  # between samples of a line that others are compared with
WIDTH_PX, HEIGHT_PX = 1280, 720
# Lines that Open CASCADE does not look for: where faces pass through each other, and smooth seams.
NOT_LOOKED_FOR = ("intersection", "seam")


@dataclass
class Ours:
    """Segments by class as (n, 2, 2) in px, and the seconds of the trace."""

    visible: dict
    hidden: dict
    seconds: float


def call(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def read_svg(text):
    """Segments by the name of their group."""
    groups = {}
    for name, lines in re.findall(r'<g id="([a-z-]+)"[^>]*>(.*?)</g>', text, re.S):
        segments = []
        for shape, points in re.findall(r'<(polyline|polygon) [^>]*points="([^"]*)"', lines):
            p = numpy.array(points.replace(",", " ").split(), float).reshape(-1, 2)
            if shape == "polygon":
                p = numpy.concatenate([p, p[:1]])
            segments.append(numpy.stack([p[:-1], p[1:]], axis=1))
        groups[name] = numpy.concatenate(segments) if segments else numpy.empty((0, 2, 2))
    return groups


def ours_of(program, model, view, folder):
    """Our drawing, 1 mm a pixel, with its hidden lines."""
    svg, log = folder / "ours.svg", folder / "ours.txt"
    words = [program, "truth", model, "--views", view, "--fit", "box", "--no-cache", "--quiet"]
    if not svg.exists():
        log.write_text(call(*words, "--svg", folder / "curves.svg"))
        call(*words, "--drawing", svg, "--hidden", "--sheet-width", WIDTH_PX)
    groups = read_svg(svg.read_text())
    hidden = {name.removeprefix("hidden-"): lines for name, lines in groups.items()
              if name.startswith("hidden-")}
    visible = {name: lines for name, lines in groups.items() if not name.startswith("hidden-")}
    seconds = re.search(r"^traced in ([\d.]+) s", log.read_text(), re.M)
    return Ours(visible, hidden, float(seconds.group(1)))


def theirs_of(algorithm, view, folder, seconds):
    """Open CASCADE's drawing, or in words why there is none."""
    kept = folder / f"{algorithm}.npz"
    if not kept.exists():
        try:
            made = open_cascade.drawing(f"occ_{algorithm}", algorithm, view, seconds)
            numpy.savez(kept, visible=made.visible, hidden=made.hidden, seconds=json.dumps(made.seconds))
        except Failed as reason:
            numpy.savez(kept, reason=str(reason))
    with numpy.load(kept) as data:
        if "reason" in data:
            return str(data["reason"])
        return open_cascade.Drawing(data["visible"], data["hidden"], json.loads(str(data["seconds"])))


def samples(segments, step_px=STEP_PX):
    """Points along segments, each in the middle of its piece, and the lengths of the pieces."""
    lengths = numpy.linalg.norm(segments[:, 1] - segments[:, 0], axis=1)
    counts = numpy.maximum(1, numpy.ceil(lengths / step_px)).astype(int)
    of = numpy.repeat(numpy.arange(len(segments)), counts)
    first = numpy.concatenate([[0], numpy.cumsum(counts)[:-1]]).astype(int)
    share = (numpy.arange(len(of)) - first[of] + 0.5) / counts[of]
    a, b = segments[of, 0], segments[of, 1]
    return a + share[:, None] * (b - a), (lengths / counts)[of]


def in_frame(points):
    return ((points >= 0) & (points <= (WIDTH_PX, HEIGHT_PX))).all(axis=1)


def near(points, segments):
    """Which points have one of the segments within NEAR_PX."""
    if len(segments) == 0 or len(points) == 0:
        return numpy.zeros(len(points), bool)
    distance, _ = cKDTree(samples(segments)[0]).query(points, distance_upper_bound=NEAR_PX)
    return numpy.isfinite(distance)


def joined(by_class, without=()):
    lines = [lines for name, lines in by_class.items() if name not in without]
    return numpy.concatenate([numpy.empty((0, 2, 2)), *lines])


def compare(ours, theirs):
    """Shares in per cent and lengths in px."""
    p, p_px = samples(joined(ours.visible, NOT_LOOKED_FOR))
    q, q_px = samples(theirs.visible)
    q, q_px = q[in_frame(q)], q_px[in_frame(q)]
    ours_found, theirs_found = near(p, theirs.visible), near(q, joined(ours.visible))
    return {
        "ours_found": 100 * p_px[ours_found].sum() / max(p_px.sum(), 1e-9),
        "theirs_found": 100 * q_px[theirs_found].sum() / max(q_px.sum(), 1e-9),
        "wrongly_shown_px": q_px[~theirs_found & near(q, joined(ours.hidden))].sum(),
        "wrongly_hidden_px": p_px[~ours_found & near(p, theirs.hidden)].sum(),
    }


def cells(ours, theirs):
    if isinstance(theirs, str):
        return [theirs, *["-"] * 4]
    found = compare(ours, theirs)
    made_s = theirs.seconds["sewing_s"] + theirs.seconds["meshing_s"]
    return [f"{made_s:.2f} + {theirs.seconds['algorithm_s']:.2f}",
            f"{found['ours_found']:.2f}", f"{found['theirs_found']:.2f}",
            f"{found['wrongly_shown_px']:.1f}", f"{found['wrongly_hidden_px']:.1f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("models", nargs="*", default=MODELS, metavar="SCENE | MODEL")
    parser.add_argument("--out", type=Path, default=Path("inkbench-out/drawings"))
    parser.add_argument("--seconds", type=int, default=300, help="longest time of a drawing (300)")
    options = parser.parse_args()
    print("| model | triangles | view | ours s | px | not looked for px | algorithm | sewing + lines s "
          "| of ours % | of theirs % | wrongly shown px | wrongly hidden px |")
    print("|---|--:|---|--:|--:|--:|---|--:|--:|--:|--:|--:|")
    for model in options.models:
        name = Path(model).stem
        if not (options.out / name / VIEWS[-1] / "camera.json").exists():
            call(options.program, "export", model, "--views", ",".join(VIEWS), "--fit", "box", "--truth",
                 "none", "--quiet", "-o", options.out)
        triangles = re.findall(r"^f", (options.out / name / "mesh.obj").read_text(), re.M)
        for view in VIEWS:
            folder = options.out / name / view
            ours = ours_of(options.program, model, view, folder)
            size = samples(joined(ours.visible))[1].sum()
            other = size - samples(joined(ours.visible, NOT_LOOKED_FOR))[1].sum()
            for algorithm in ALGORITHMS:
                theirs = theirs_of(algorithm, read_view(folder / "camera.json"), folder, options.seconds)
                print("|", " | ".join([name, str(len(triangles)), view, f"{ours.seconds:.2f}",
                                       f"{size:.0f}", f"{other:.0f}", algorithm,
                                       *cells(ours, theirs)]), "|", flush=True)


if __name__ == "__main__":
    main()
