"""How a file of a package becomes a model that Inkbench reads."""

import base64
import gzip
import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import packages
import quake

_HERE = Path(__file__).resolve().parent


def obj_text(positions, triangles):
    """An OBJ file of points and of triples of indices that count from 0."""
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in positions]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    return ("\n".join(lines) + "\n").encode()


def _copy(data, _):
    return data


def _gunzip(data, _):
    return gzip.decompress(data)


def _json_mesh(data, _):
    text = data.decode("utf-8")
    lists = []
    for name in ("positions", "cells"):
        found = re.search(rf"\b{name}\s*=\s*(\[\[.*?\]\])", text, re.S)
        if found is None:
            raise ValueError(f"it has no list called {name}")
        lists.append(json.loads(found.group(1)))
    return obj_text(*lists)


def _q3_map(data, _):
    return obj_text(*quake.map_mesh(data))


def _md3_player(data, context):
    path = context.path
    others = [context.package.read(path.replace("lower.md3", name))
              for name in ("upper.md3", "head.md3")]
    return obj_text(*quake.player_mesh([data, *others]))


def _ez_tree(data, context):
    if shutil.which("node") is None:
        raise packages.Missing("node is not on this machine")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        modules = folder / "node_modules"
        context.package.unpack(modules / "@dgreenheck" / "ez-tree")
        for need in context.needs:
            other = packages.Package("npm", *need.rsplit("@", 1), context.downloads)
            other.unpack(modules / need.rsplit("@", 1)[0])
        (folder / "preset.json").write_bytes(data)
        done = subprocess.run(["node", str(_HERE / "tree.mjs"), "preset.json", "tree.obj"],
                              cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            reasons = [line for line in done.stderr.splitlines() if "Error" in line]
            raise packages.Missing(f"node could not make the tree: {(reasons or ['?'])[0].strip()}")
        return (folder / "tree.obj").read_bytes()


def _assimp(data, context):
    """A format that Inkbench refuses, as Assimp reads it: right or not, the same for everybody."""
    if shutil.which("assimp") is None:
        raise packages.Missing("assimp is not on this machine: apt-get install assimp-utils")
    with tempfile.TemporaryDirectory() as name:
        source = Path(name) / Path(context.path).name
        source.write_bytes(data)
        done = subprocess.run(["assimp", "export", source.name, "model.glb", "-fglb2"],
                              cwd=name, capture_output=True, text=True, check=False)
        model = Path(name) / "model.glb"
        if done.returncode != 0 or not model.exists():
            raise packages.Missing(f"assimp could not export {source.name}")
        return model.read_bytes()


def _gltf_with_buffer(data, context):
    """A .gltf whose one buffer is a file beside it, with that in it."""
    gltf = json.loads(data)
    (buffer,) = gltf["buffers"]
    folder = context.path.rsplit("/", 1)[0]
    body = base64.b64encode(context.package.read(f"{folder}/{buffer['uri']}")).decode()
    buffer["uri"] = f"data:application/octet-stream;base64,{body}"
    return json.dumps(gltf, indent=1).encode()


# By the name that models.toml uses. Each takes the file's bytes and its context: the package, the
# path in it, the packages it needs beside, and the folder of downloads.
CONVERTERS = {"copy": _copy, "gunzip": _gunzip, "json_mesh": _json_mesh, "md3_player": _md3_player,
              "q3_map": _q3_map, "ez_tree": _ez_tree, "assimp": _assimp,
              "gltf_with_buffer": _gltf_with_buffer}
