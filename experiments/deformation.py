#!/usr/bin/python3
"""Prints the table of take_home.md on models that bend: codes of the rest pose beside codes of the pose.

    experiments/deformation.py build/release/inkbench [--out FOLDER] [--poses N] [MODEL ...]

It needs a program whose methods keep the codes of the animation's start with --time, as version 0.2.0 did up to
commit ea1e6c9a; now codes are of the pose that is drawn. A model is drawn at evenly spaced moments of each of its
animations, and once more from a still copy of that pose, whose codes are its own. Of an animation the first pose is
printed, and the one at which `surface8` loses most. Beside F stands how far the pose bends: the change of the
dihedral angle that 5 % of the length of all edges exceed, the same for the stretch of edges, and the share of edges, by
length, that the pose makes a crease of.
`elbow` is made here, and printed whole: a tube of 2 x 48 x 96 triangles that one joint bends by 150 degrees.
Runs stay in FOLDER and are not made again.
"""

import argparse
import base64
import json
import math
import re
import struct
import subprocess
import sys
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy
import pandas

METHODS = ("surface8", "surface8_depth", "label8", "ids", "surface_lookup", "edge_hash")
CODES = ("surface8", "surface8_depth", "label8")  # what a pose may have codes of its own for
MODELS = [f"inkbench-out/models/{name}" for name in
          ("bull.glb", "dancer.glb", "arm.glb", "gargoyle_legs.md3", "morph_cube.gltf")]
CREASE_DEG = 40
ELBOW_DEG = 150
AROUND, ALONG = 48, 96


def call(*words, may_fail=False):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode != 0 and not may_fail:
        sys.exit(f"{' '.join(map(str, words))}: {(done.stderr or done.stdout).strip()}")
    return done.stdout + done.stderr


def elbow_gltf():
    """A tube along y whose upper half follows a joint that turns by ELBOW_DEG within a second."""
    rings = numpy.linspace(-2, 2, ALONG + 1)
    turns = numpy.arange(AROUND) * 2 * math.pi / AROUND
    positions = numpy.array([[0.5 * math.sin(a), y, 0.5 * math.cos(a)] for y in rings for a in turns])
    share = numpy.clip(0.5 + positions[:, 1], 0, 1)  # of the upper bone; blended over a unit
    share = share * share * (3 - 2 * share)
    triangles = []
    for ring in range(ALONG):
        for k in range(AROUND):
            a, b = ring * AROUND + k, ring * AROUND + (k + 1) % AROUND
            triangles += [[a, b, b + AROUND], [a, b + AROUND, a + AROUND]]
    joints = numpy.tile(numpy.array([0, 1, 0, 0], "uint8"), (len(positions), 1))
    weights = numpy.column_stack([1 - share, share, 0 * share, 0 * share])
    keys = numpy.linspace(0, 1, 16)
    half = numpy.radians(ELBOW_DEG) * keys / 2
    turns_of_joint = numpy.column_stack([0 * half, 0 * half, numpy.sin(half), numpy.cos(half)])
    body, views, accessors = b"", [], []
    for values, kind, component, shape in (
            (positions, "f4", 5126, "VEC3"), (triangles, "u4", 5125, "SCALAR"), (joints, "u1", 5121, "VEC4"),
            (weights, "f4", 5126, "VEC4"), (keys, "f4", 5126, "SCALAR"), (turns_of_joint, "f4", 5126, "VEC4")):
        data = numpy.ascontiguousarray(values, "<" + kind)
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": data.nbytes})
        rows = data.reshape(-1, {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[shape])
        accessors.append({"bufferView": len(accessors), "componentType": component, "type": shape,
                          "count": len(rows), "min": rows.min(0).tolist(), "max": rows.max(0).tolist()})
        body += data.tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"name": "tube", "mesh": 0, "skin": 0}, {"name": "lower", "children": [2]}, {"name": "upper"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3}, "indices": 1}]}],
        "skins": [{"joints": [1, 2]}],
        "animations": [{"name": "bend", "samplers": [{"input": 4, "output": 5}],
                        "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}]}],
        "buffers": [{"uri": uri, "byteLength": len(body)}], "bufferViews": views, "accessors": accessors})


def read_obj(path):
    """Positions as the file has them, and triangles."""
    points, triangles, origin = [], [], (0, 0, 0)
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:2] == ["#", "origin"]:
            origin = [float(x.rstrip(":")) for x in words[2:5]]
        elif words[:1] == ["v"]:
            points.append([float(x) + o for x, o in zip(words[1:4], origin)])
        elif words[:1] == ["f"]:
            triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return numpy.array(points), numpy.array(triangles)


def welded(points, triangles):
    """The triangles over places instead of vertices."""
    _, place = numpy.unique(points, axis=0, return_inverse=True)
    return place.ravel()[triangles]


def inner_edges(triangles):
    """Edges of two triangles: their ends, and the two."""
    of_edge = defaultdict(list)
    for number, (a, b, c) in enumerate(triangles.tolist()):
        for one, other in ((a, b), (b, c), (c, a)):
            if one != other:
                of_edge[min(one, other), max(one, other)].append(number)
    pairs = [(edge, faces) for edge, faces in of_edge.items() if len(faces) == 2]
    return numpy.array([edge for edge, _ in pairs]), numpy.array([faces for _, faces in pairs])


def dihedral_deg(points, triangles, faces):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    normals = numpy.cross(b - a, c - a)
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    one, other = normals[faces[:, 0]], normals[faces[:, 1]]
    return numpy.degrees(numpy.arctan2(numpy.linalg.norm(numpy.cross(one, other), axis=1),
                                       (one * other).sum(1)))


def exceeded(values, weights, share=0.05):
    """The value that `share` of the weight exceeds."""
    order = numpy.argsort(-values)
    return values[order][numpy.searchsorted(numpy.cumsum(weights[order]), share * weights.sum())]


def bend_of(rest, posed):
    """How far a pose bends: degrees, stretch, share of edges that became creases."""
    (p_rest, triangles), (p_posed, _) = rest, posed
    edges, faces = inner_edges(welded(p_rest, triangles))
    of_place = {}
    for place, vertex in zip(welded(p_rest, triangles).ravel().tolist(), triangles.ravel().tolist()):
        of_place.setdefault(place, vertex)
    ends = numpy.array([[of_place[a], of_place[b]] for a, b in edges.tolist()])
    length = [numpy.linalg.norm(p[ends[:, 0]] - p[ends[:, 1]], axis=1) for p in (p_rest, p_posed)]
    angle = [dihedral_deg(p, triangles, faces) for p in (p_rest, p_posed)]
    whole = numpy.minimum(*length) > 1e-9 * max(length[0].max(), 1e-30)
    stretch = numpy.exp(numpy.abs(numpy.log(length[1][whole] / length[0][whole])))
    new = (angle[0] < CREASE_DEG) & (angle[1] >= CREASE_DEG)
    return (exceeded(numpy.abs(angle[1] - angle[0]), length[1]), exceeded(stretch, length[1][whole]),
            length[1][new].sum() / length[1].sum())


class Study:
    """Runs of one program, kept in a folder."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def counts(self, out, model, methods, *options):
        """k, drawn and true pixels of each method over all views."""
        if not (out / "rows.csv").exists():
            call(self.program, "compare", model, "--no-sweep", "--no-times", "--quiet", "--methods",
                 ",".join(methods), "--out", out, *options)
        rows = pandas.read_csv(out / "rows.csv")
        rows = rows[rows.method.isin(methods) & (rows.status == "ok")]
        return rows.groupby("method")[["k_2px", "n_pred", "n_truth"]].sum()

    def still(self, out, model, *options):
        """A folder with the mesh of a pose."""
        if not out.exists():
            call(self.program, "export", model, "--views", "1", "-o", out, *options)
        return next(out.glob("*/mesh.glb")).parent

    def animations(self, model):
        """(number, seconds) of each."""
        text = call(self.program, "explain", model)
        numbers = re.findall(r"^animation (\d+):", text, re.M) or ["0"]
        for number in numbers:
            which = [] if model.suffix == ".md3" else ["--animation", number]
            refused = call(self.program, "draw", model, "--time", "1e6", *which, "-o",
                           self.folder / "none.png", may_fail=True)
            found = re.search(r"accepted: 0\.\.([\d.]+)", refused)
            if found and float(found.group(1)) > 0:
                yield which, float(found.group(1))


def pooled_f(counts):
    return 2 * counts.k_2px / (counts.n_pred + counts.n_truth)


@dataclass
class Pose:
    """What a moment of an animation did to F."""

    key: str
    time_s: float
    bend: tuple
    of_rest: pandas.Series
    of_pose: pandas.Series

    @property
    def loss(self):
        return self.of_pose["surface8"] - self.of_rest["surface8"]

    def line(self):
        f = []
        for name in METHODS:
            f += [f"{counts[name]:.3f}" for counts in (self.of_rest, self.of_pose) if name in counts]
        deg, stretch, new = self.bend
        return (f"| {self.key} | {self.time_s:.2f} s | {deg:.0f} | {stretch:.2f} | {100 * new:.1f} % | "
                + " | ".join(f) + " |")


def poses_of(study, model, which, seconds, count):
    """The poses of an animation, the first at rest."""
    key = f"{model.stem} {''.join(which[1:])}".strip()
    rest = None
    for number in range(count + 1):
        time_s = 0.999 * seconds * number / count  # the end is told rounded
        options = [*which, "--time", f"{time_s:.6g}"]
        folder = study.still(study.folder / f"{key}.{number}.still", model, *options)
        mesh = read_obj(folder / "mesh.obj")
        rest = rest or mesh
        yield Pose(key, time_s, bend_of(rest, mesh),
                   pooled_f(study.counts(study.folder / f"{key}.{number}.rest", model, METHODS, *options)),
                   pooled_f(study.counts(study.folder / f"{key}.{number}.own", folder / "mesh.glb", CODES)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("--out", type=Path, default=Path("inkbench-out/deformation"))
    parser.add_argument("--poses", type=int, default=6, help="of each animation (default: 6)")
    parser.add_argument("--all", action="store_true", help="all poses, not the first and the worst")
    parser.add_argument("models", nargs="*", type=Path)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    study = Study(args.program.resolve(), args.out)
    elbow = args.out / "elbow.gltf"
    elbow.write_text(elbow_gltf())
    columns = ["model", "pose", "bend, deg", "stretch", "new creases"]
    for name in METHODS:
        columns += [f"`{name}`"] + ["its pose's"] * (name in CODES)
    print(f"| {' | '.join(columns)} |\n|---|{'--:|' * (len(columns) - 1)}")
    for model in args.models or [*map(Path, MODELS), elbow]:
        for which, seconds in study.animations(model):
            poses = list(poses_of(study, model, which, seconds, args.poses))
            shown = poses if args.all or model == elbow else [poses[0], max(poses[1:], key=lambda p: p.loss)]
            for pose in shown:
                print(pose.line(), flush=True)


if __name__ == "__main__":
    main()
