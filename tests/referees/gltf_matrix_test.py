"""Every kind of number in glTF 2.0 gives the triangles that the specification demands.

    gltf_matrix_test.py [--keep FOLDER]

Makes a file for each combination of component type, normalisation, sparse storage, mode, skin,
morph targets, animation and interpolation, works out its triangles by arithmetic of its own, and
compares them with what `inkbench export` writes. Files that must be refused are, by name.
"""

import argparse
import itertools
import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from gltf_files import Glb, animated, meant, moved, place_matrix, stored, triangles, unit
from model_files import read_obj
from program import DESK, inkbench

TIME_S = 0.65
TIMES_S = [0.0, 0.4, 1.0, 1.5]
INTERPOLATIONS = ("LINEAR", "STEP", "CUBICSPLINE")
# Half a unit in the last place of floats, some operations and the digits of an OBJ.
TOLERANCE = 4e-6

# A bent strip of eight vertices: in order it is a strip, a fan or triangles of its own.
SHAPE = np.array([[0, 0, 0], [5, 0, 1], [0, 4, 2], [6, 3, 0], [1, 7, 3], [7, 8, 1], [2, 9, 5],
                  [9, 6, 7]], float) / 10
INDICES = {4: [0, 1, 2, 2, 1, 3, 4, 2, 3, 4, 3, 5, 6, 4, 5, 5, 7, 6], 5: [0, 1, 2, 3, 4, 5, 6, 7],
           6: [3, 0, 1, 5, 7, 6, 2]}
ROTATION = unit(np.array([0.1, 0.7, -0.3, 0.5]))
PLACE = {"translation": [3, -2, 0.5], "rotation": ROTATION.tolist(), "scale": [1.5, 0.75, 2]}


@dataclass
class Made:
    """A file and the triangles (n, 3, 3) that must come of it."""

    name: str
    soup: np.ndarray
    moves: bool = False


FOLDER = Path(DESK.name) / "gltf"
MADE = []


def finish(glb, name, soup, **more):
    more.setdefault("scenes", [{"nodes": [0]}])
    glb.write(FOLDER / f"{name}.glb", **more)
    MADE.append(Made(name, soup, "animations" in glb.lists))


def shape(kind, normalised):
    """SHAPE as a component type can hold it."""
    return stored(SHAPE if kind == "f4" or normalised else SHAPE * 10, kind, normalised)


def plain_primitive(glb, kind="f4", normalised=False):
    """An indexed primitive of SHAPE, and its points as they are meant."""
    raw = shape(kind, normalised)
    primitive = {"attributes": {"POSITION": glb.accessor(raw, normalised, aligned=True)},
                 "indices": glb.accessor(np.array(INDICES[4], "u1").reshape(-1, 1))}
    return primitive, meant(raw, normalised)


def put_mesh(glb, primitive, **node):
    """A mesh of one primitive, and a node that has it."""
    glb.put("meshes", {"primitives": [primitive]})
    glb.put("nodes", {"mesh": 0, **PLACE, **node})


def of_indices(points, mode=4):
    return points[triangles(INDICES[mode], mode)]


# ---- Positions -------------------------------------------------------------------------------

POSITION_KINDS = [("f4", False)] + [(k, n) for k in ("i1", "u1", "i2", "u2") for n in (False, True)]


def make_positions():
    """Component types x normalised x sparse x mode x how it is indexed."""
    matrix = place_matrix(**PLACE)
    modes = [(4, "u1"), (4, "u2"), (4, "u4"), (4, ""), (5, "u2"), (5, ""), (6, "u1")]
    for (kind, normalised), sparse, (mode, index) in itertools.product(
            POSITION_KINDS, ("", "base", "zeros"), modes):
        glb = Glb()
        raw = shape(kind, normalised)
        corners = INDICES[mode]
        if not index:
            raw, corners = raw[corners], range(len(corners))
        primitive = {"attributes": {
            "POSITION": glb.accessor(raw, normalised, sparse, aligned=True)}, "mode": mode}
        if index:
            primitive["indices"] = glb.accessor(np.array(corners, index).reshape(-1, 1))
        if mode == 4 and index == "u2":
            del primitive["mode"]
        put_mesh(glb, primitive)
        points = moved(meant(raw, normalised), matrix)
        name = f"pos_{kind}{'n' * normalised}_{sparse or 'plain'}_{mode}{index or 'none'}"
        finish(glb, name, points[triangles(corners, mode)],
               **required(kind, "KHR_mesh_quantization"))


def required(kind, extension):
    if kind == "f4":
        return {}
    return {"extensionsUsed": [extension], "extensionsRequired": [extension]}


# ---- Skins -----------------------------------------------------------------------------------


def skin_weights(sets):
    """Joints (vertices, 4 * sets) and weights that sum up to 1."""
    random = np.random.default_rng(5 + sets)
    joints = random.integers(0, 3, (len(SHAPE), 4 * sets))
    weights = random.integers(0, 4, (len(SHAPE), 4 * sets)).astype(float)
    weights[:, 0] += 1
    return joints, weights / weights.sum(axis=1, keepdims=True)


def whole_weights(weights, kind):
    """Weights in a component type whose stored numbers sum up to its 1."""
    raw = stored(weights, kind, True)
    if kind != "f4":
        raw = raw.astype(int)
        raw[:, 0] += np.iinfo(kind).max - raw.sum(axis=1)
        raw = raw.astype(kind)
    return raw


def add_skin(glb, primitive, joint_kind, weight_kind, binds, sets):
    """Nodes 1, 2, 3 as joints of a skin; returns what it makes of points."""
    joints, weights = skin_weights(sets)
    raw = whole_weights(weights, weight_kind)
    for s in range(sets):
        part = slice(4 * s, 4 * s + 4)
        primitive["attributes"][f"JOINTS_{s}"] = glb.accessor(
            joints[:, part].astype(joint_kind), aligned=True)
        primitive["attributes"][f"WEIGHTS_{s}"] = glb.accessor(raw[:, part], True, aligned=True)
    places = [{"translation": [1, 0, 0]},
              {"translation": [0, 2, 0], "rotation": ROTATION.tolist()},
              {"translation": [0, 0, 3], "scale": [2, 1, 0.5]}]
    world = [place_matrix(**p) for p in places]
    world[1] = world[0] @ world[1]  # node 2 is a child of node 1
    glb.put("nodes", {**places[0], "children": [2]})
    glb.put("nodes", places[1])
    glb.put("nodes", places[2])
    skin = {"joints": [1, 2, 3]}
    bound = [np.eye(4)] * 3
    if binds:
        bound = [place_matrix(translation=(-1, 0.5, 0)), place_matrix(rotation=unit(
            np.array([0, 0.5, 0.25, 1]))), place_matrix(scale=(1, 3, 1))]
        columns = stored([m.T.reshape(16) for m in bound], "f4")
        bound = [c.astype(float).reshape(4, 4).T for c in columns]
        skin["inverseBindMatrices"] = glb.accessor(columns)
    glb.put("skins", skin)
    shares = meant(raw, True)
    shares = shares / shares.sum(axis=1, keepdims=True)

    def skinned(points):
        out = np.zeros_like(points)
        for v, point in enumerate(points):
            sum_ = sum(w * (world[j] @ bound[j]) for j, w in zip(joints[v], shares[v]))
            out[v] = moved(point[None], sum_)[0]
        return out

    return skinned


def make_skins():
    """Joints x weights x bind matrices x sets x positions."""
    for joint_kind, weight_kind, binds, sets, kind in itertools.product(
            ("u1", "u2"), ("f4", "u1", "u2"), (True, False), (1, 2), ("f4", "i2")):
        glb = Glb()
        primitive, points = plain_primitive(glb, kind, kind != "f4")
        put_mesh(glb, primitive, skin=0)
        skinned = add_skin(glb, primitive, joint_kind, weight_kind, binds, sets)
        finish(glb, f"skin_{joint_kind}_{weight_kind}_{'bound' if binds else 'unbound'}_{sets}_"
               f"{kind}", of_indices(skinned(points)), scenes=[{"nodes": [0, 1, 3]}],
               **required(kind, "KHR_mesh_quantization"))


# ---- Morph targets ---------------------------------------------------------------------------

DELTAS = [np.array([[0, 0, 0], [2, 1, 0], [0, 0, 0], [-1, 3, 2], [4, 0, -2], [0, 0, 0], [1, 1, 1],
                    [-3, 2, 0]], float) / 10,
          np.array([[1, 0, 0], [0, 0, 0], [0, -4, 1], [0, 0, 0], [0, 0, 5], [2, 2, 2], [0, 0, 0],
                    [0, 0, 0]], float) / 10]


def add_targets(glb, primitive, kind, normalised, sparse):
    """Two targets; returns what they add as it is meant."""
    raws = [stored(d if kind == "f4" or normalised else d * 10, kind, normalised) for d in DELTAS]
    primitive["targets"] = [
        {"POSITION": glb.accessor(raw, normalised, sparse, aligned=True)} for raw in raws]
    return [meant(raw, normalised) for raw in raws]


def make_morphs():
    """Component types of targets x sparse x where the weights stand."""
    kinds = [("f4", False), ("i1", False), ("i1", True), ("i2", False), ("i2", True)]
    for (kind, normalised), sparse, where in itertools.product(
            kinds, ("", "base", "zeros"), ("mesh", "node", "both", "none")):
        glb = Glb()
        primitive, points = plain_primitive(glb)
        deltas = add_targets(glb, primitive, kind, normalised, sparse)
        mesh, node = {"primitives": [primitive]}, {"mesh": 0, **PLACE}
        weights = [0, 0]
        if where in ("mesh", "both"):
            mesh["weights"] = weights = [0.5, -0.25]
        if where in ("node", "both"):
            node["weights"] = weights = [0.75, 2]
        glb.put("meshes", mesh)
        glb.put("nodes", node)
        points = points + weights[0] * deltas[0] + weights[1] * deltas[1]
        finish(glb, f"morph_{kind}{'n' * normalised}_{sparse or 'plain'}_{where}",
               of_indices(moved(points, place_matrix(**PLACE))),
               **required(kind, "KHR_mesh_quantization"))


# ---- Animations ------------------------------------------------------------------------------

KEYS = {"translation": [[0, 0, 0], [1, -2, 3], [2, 0, 1], [0, 1, 0]],
        "rotation": [unit(np.array(q, float)).tolist() for q in
                     ([0, 0, 0, 1], [0.5, 0.1, 0, 0.8], [-0.2, 0.6, -0.4, -0.3], [0, 1, 0, 0.2])],
        "scale": [[1, 1, 1], [2, 0.5, 1], [1, 3, 0.25], [1, 1, 1]],
        "weights": [[0, 1], [0.5, 0.25], [1, 0], [0.25, 0.75]]}


def add_sampler(glb, path, kind, interpolation):
    """A sampler of KEYS; its number, and its value at TIME_S."""
    values = np.array(KEYS[path], float)
    if interpolation == "CUBICSPLINE":
        slopes = np.roll(values, 1, axis=0) * 0.5
        values = np.stack([slopes, values, -0.5 * slopes], axis=1)
    raw = stored(values, kind, True)
    width = 1 if path == "weights" else raw.shape[-1]
    output = glb.accessor(raw.reshape(-1, width), True)
    times = stored(TIMES_S, "f4")
    sampler = glb.put("samplers_", {"input": glb.accessor(times.reshape(-1, 1)), "output": output,
                                    "interpolation": interpolation})
    return sampler, animated(times.astype(float), meant(raw, True), interpolation, path, TIME_S)


def add_animation(glb, channels):
    """An animation of {path: sampler} of node 0."""
    glb.put("animations", {"samplers": glb.lists.pop("samplers_"), "channels": [
        {"sampler": s, "target": {"node": 0, "path": path}} for path, s in channels.items()]})


def make_animations():
    """Paths x component types x interpolation."""
    kinds = {"translation": ["f4"], "scale": ["f4"], "rotation": ["f4", "i1", "i2"],
             "weights": ["f4", "i1", "u1", "i2", "u2"]}
    for path, interpolation in itertools.product(kinds, INTERPOLATIONS):
        for kind in kinds[path]:
            glb = Glb()
            primitive, points = plain_primitive(glb)
            place = dict(PLACE)
            deltas = add_targets(glb, primitive, "f4", False, "zeros")
            sampler, value = add_sampler(glb, path, kind, interpolation)
            if path == "weights":
                points = points + value[0] * deltas[0] + value[1] * deltas[1]
            else:
                place[path] = value
            add_animation(glb, {path: sampler})
            put_mesh(glb, primitive)
            finish(glb, f"anim_{path}_{kind}_{interpolation}",
                   of_indices(moved(points, place_matrix(**place))))


def make_mixed():
    """Morph targets below a skin, all paths at once, copies, hidden nodes."""
    for interpolation, weight_kind in itertools.product(INTERPOLATIONS, ("f4", "u1")):
        glb = Glb()
        primitive, points = plain_primitive(glb, "i2", True)
        deltas = add_targets(glb, primitive, "i2", True, "base")
        glb.put("meshes", {"primitives": [primitive], "weights": [1, 1]})
        glb.put("nodes", {"mesh": 0, "skin": 0, **PLACE})
        skinned = add_skin(glb, primitive, "u1", weight_kind, True, 1)
        sampler, value = add_sampler(glb, "weights", weight_kind, interpolation)
        add_animation(glb, {"weights": sampler})
        points = points + value[0] * deltas[0] + value[1] * deltas[1]
        finish(glb, f"mixed_skin_{interpolation}_{weight_kind}", of_indices(skinned(points)),
               scenes=[{"nodes": [0, 1, 3]}], **required("i2", "KHR_mesh_quantization"))
    for interpolation in INTERPOLATIONS:
        glb = Glb()
        primitive, points = plain_primitive(glb)
        deltas = add_targets(glb, primitive, "f4", False, "")
        channels, values = {}, {}
        for path in KEYS:
            channels[path], values[path] = add_sampler(glb, path, "f4", interpolation)
        add_animation(glb, channels)
        put_mesh(glb, primitive)
        weights = values.pop("weights")
        points = points + weights[0] * deltas[0] + weights[1] * deltas[1]
        finish(glb, f"mixed_all_{interpolation}",
               of_indices(moved(points, place_matrix(**values))))
    for kind in ("f4", "i1", "i2"):
        glb = Glb()
        primitive, points = plain_primitive(glb)
        turns = stored(KEYS["rotation"][:3], kind, True)
        attributes = {
            "TRANSLATION": glb.accessor(stored(KEYS["translation"][:3], "f4")),
            "ROTATION": glb.accessor(turns, True),
            "SCALE": glb.accessor(stored(KEYS["scale"][1:], "f4"))}
        put_mesh(glb, primitive, extensions={"EXT_mesh_gpu_instancing": {"attributes": attributes}})
        soups = [of_indices(moved(points, place_matrix(**PLACE) @ place_matrix(
            KEYS["translation"][i], unit(meant(turns, True)[i]), KEYS["scale"][i + 1])))
                 for i in range(3)]
        finish(glb, f"copies_{kind}", np.concatenate(soups),
               **required("", "EXT_mesh_gpu_instancing"))
    for hidden in (True, False):
        glb = Glb()
        primitive, points = plain_primitive(glb)
        glb.put("meshes", {"primitives": [primitive]})
        glb.put("nodes", {"children": [1], "extensions": {
            "KHR_node_visibility": {"visible": not hidden}}})
        glb.put("nodes", {"mesh": 0, **PLACE})
        glb.put("nodes", {"mesh": 0})
        shown = [of_indices(points)]
        if not hidden:
            shown.append(of_indices(moved(points, place_matrix(**PLACE))))
        finish(glb, f"hidden_{hidden}", np.concatenate(shown), scenes=[{"nodes": [0, 2]}],
               **required("", "KHR_node_visibility"))


def make_refused():
    """Files that must be refused, and a word of the message."""
    refused = {}
    for extension in ("EXT_unheard_of", "KHR_gaussian_splatting", "CESIUM_RTC"):
        glb = Glb()
        primitive, points = plain_primitive(glb)
        glb.put("meshes", {"primitives": [primitive]})
        glb.put("nodes", {"mesh": 0})
        glb.write(FOLDER / f"refused_{extension}.glb", scenes=[{"nodes": [0]}],
                  extensionsUsed=[extension], extensionsRequired=[extension])
        refused[f"refused_{extension}"] = extension
    return refused


# ---- Comparison ------------------------------------------------------------------------------


def farthest(expected, found):
    """How far a triangle is from the one that stands for it, at most; infinite if none is left."""
    if len(expected) != len(found):
        return np.inf
    # A mirrored node's triangles are written the other way round.
    orders = ([0, 1, 2], [1, 2, 0], [2, 0, 1])
    left, most = found, 0.0
    for triangle in expected:
        gaps = np.min([np.abs(left[:, o] - triangle).max(axis=(1, 2)) for o in orders], axis=0)
        nearest = int(gaps.argmin())
        most = max(most, float(gaps[nearest]))
        left = np.delete(left, nearest, axis=0)
    return most


def compare(made, out):
    """The names of those whose triangles are others, with how far off they are."""
    wrong = []
    for one in made:
        suffix = f".{TIME_S}s" if one.moves else ""
        mesh = read_obj(out / f"{one.name}{suffix}" / "mesh.obj")
        gap = farthest(one.soup, mesh.corners())
        if gap > TOLERANCE * np.abs(one.soup).max():
            wrong.append(f"{one.name}: {gap:g}")
    return wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--keep", help="copy the files there")
    args = parser.parse_args()
    FOLDER.mkdir()
    for make in (make_positions, make_skins, make_morphs, make_animations, make_mixed):
        make()
    refused = make_refused()
    if args.keep:
        shutil.copytree(FOLDER, args.keep, dirs_exist_ok=True)
    out, wrong = Path(DESK.name) / "out", []
    for moves in (False, True):
        group = [one for one in MADE if one.moves == moves]
        inkbench("export", *(FOLDER / f"{one.name}.glb" for one in group), "-o", out, "--truth",
                 "none", "--size", "32x32", "--views", "1", *(["--time", TIME_S] if moves else []))
        wrong += compare(group, out)
    for name, word in refused.items():
        try:
            inkbench("export", FOLDER / f"{name}.glb", "-o", out)
            wrong.append(f"{name}: was read")
        except RuntimeError as error:
            if "exit 2" not in str(error) or word not in str(error):
                wrong.append(f"{name}: {error}")
    print(f"{len(MADE) + len(refused)} files made: {len(MADE) - len(wrong)} equal, "
          f"{len(refused)} refused by name, {len(wrong)} wrong")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main())
