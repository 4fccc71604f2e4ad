#!/usr/bin/python3
"""Prints the table of take_home.md on what codes and edges cost in a file.

    experiments/baked_models.py build/release/inkbench [MODEL ...]

For each model (by default all of inkbench-out/models, which experiments/models/fetch gets) its triangles and
vertices as glTF, how many vertices `surface8` and `label8` add, and the size of the file before (of glTF),
with codes of `surface8`, and with edges.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

MODELS = Path("inkbench-out/models")
KINDS = (".glb", ".gltf", ".obj", ".ply", ".stl", ".dae", ".ms3d", ".md3")


def bake(program, model, out, *options):
    done = subprocess.run([program, "bake", model, "-o", out, *options], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        sys.exit(done.stderr.strip())
    return done.stdout


def codes_of(text):
    """Triangles, vertices before, vertices added."""
    found = re.search(r"on (\d+) triangles: (\d+|no) vert\w+ (?:are|is) added to (\d+)", text)
    triangles, added, before = found.groups()
    return int(triangles), int(before), 0 if added == "no" else int(added)


def row(program, model, folder):
    glb = folder / "model.glb"
    coded = {}
    for method in ("label8", "surface8"):
        coded[method] = codes_of(bake(program, model, glb, "--codes", method))
    sizes = [glb.stat().st_size]
    bake(program, model, glb, "--edges")
    sizes.append(glb.stat().st_size)
    if model.suffix in (".glb", ".gltf"):
        sizes.insert(0, model.stat().st_size)
    triangles, before, _ = coded["surface8"]
    added = " | ".join(f"{100 * coded[method][2] / before:.0f} %" for method in ("surface8", "label8"))
    kb = " | ".join(["-"] * (3 - len(sizes)) + [f"{size / 1000:.0f}" for size in sizes])
    return f"| {model.stem} | {triangles} | {before} | {added} | {kb} |"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    models = [Path(word) for word in sys.argv[2:]] or sorted(
        path for path in MODELS.iterdir() if path.suffix in KINDS)
    print("| model | triangles | vertices | surface8 adds | label8 adds | kB | with codes | with edges |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        for model in models:
            print(row(sys.argv[1], model, Path(folder)), flush=True)


if __name__ == "__main__":
    main()
