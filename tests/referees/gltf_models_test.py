"""The glTF files of Debian's assimp-testmodels, against gltf-transform: boxes and triangle counts.

Skips without the models (apt: assimp-testmodels) or without gltf-transform (npm: README.md).
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

from model_files import read_obj
from program import DESK, inkbench, skip

MODELS = Path("/usr/share/assimp/models")
READER = Path(os.environ.get("INKBENCH_GLTF_TRANSFORM", Path(__file__).parent / "gltf_transform"))
# Files that are wrong on purpose, or lack a buffer in the package: what the message must say.
WRONG = {
    "AllIndicesOutOfRange.gltf": "index 0 is 65535",
    "BoxWithInfinites.glb": "is not finite",
    "IndexOutOfRange.gltf": "index 0 is 255",
    "RecursiveNodes.gltf": "is a child of node",
    "badArray.gltf": "primitives is an object",
    "sceneWrongType.gltf": 'scene is "hello"',
    "MissingBin/BoxTextured.gltf": "BoxTextured0.bin cannot be read",
    "TestNoRootNode/NoScene.gltf": "it holds no triangle",
    "glTF/BoxTextured-glTF-Binary/BoxTextured.glb": "is cut short",  # and of version 1
}
EMPTY = "it holds no triangle"
VERSION_1 = "glTF 1"


def theirs(files):
    """What gltf-transform says of each file."""
    done = subprocess.run(["node", "measure.js", *map(str, files)], cwd=READER, text=True,
                          capture_output=True, check=True)
    return {Path(line["file"]): line for line in map(json.loads, done.stdout.splitlines())}


def ours(file):
    """Triangle count, box; or None, and the complaint."""
    out = Path(DESK.name) / "out"
    shutil.rmtree(out, ignore_errors=True)
    try:
        inkbench("export", file, "-o", out, "--truth", "none", "--size", "16x16", "--views", "1")
    except RuntimeError as error:
        return None, str(error)
    corners = read_obj(next(out.glob("*/mesh.obj"))).corners()
    return (len(corners), corners.min(axis=(0, 1)), corners.max(axis=(0, 1))), ""


def expected_complaint(file, judged):
    """What our message must hold, or nothing where the file must be read."""
    for name, words in WRONG.items():
        if str(file).endswith("/" + name):
            return words
    if f"{MODELS}/glTF/" in str(file):
        return VERSION_1
    return EMPTY if judged.get("triangles") == 0 else ""


def fault(file, judged):
    """In what we are wrong about a file; empty if in nothing. And a word on how it went."""
    measured, complaint = ours(file)
    words = expected_complaint(file, judged)
    if words:
        is_good = measured is None and words in complaint and "exit 2" in complaint
        return "" if is_good else f"must be refused ({words}): {complaint}", "refused"
    if measured is None:
        return complaint, "refused"
    if "error" in judged:
        return "", "alone"  # gltf-transform cannot read it: an image or a buffer is missing
    # Rotations of six digits are made unit here, and taken as they are there.
    count, low, high = measured
    size = np.abs([judged["low"], judged["high"]]).max()
    gap = np.abs(np.array([low, high]) - [judged["low"], judged["high"]]).max()
    if count != judged["triangles"] or gap > 1e-5 * size:
        return f"{count} triangles of {judged['triangles']}, box off by {gap:g}", "wrong"
    return "", "equal"


def main():
    files = sorted(f for kind in ("gltf", "glb") for f in MODELS.glob(f"glTF*/**/*.{kind}"))
    if not files:
        skip("assimp-testmodels is not installed")
    if shutil.which("node") is None or not (READER / "node_modules").is_dir():
        skip("gltf-transform is not installed (tests/referees/README.md)")
    judged = theirs(files)
    counts, faults = {}, []
    for file in files:
        wrong, how = fault(file, judged[file])
        counts[how] = counts.get(how, 0) + 1
        if wrong:
            faults.append(f"{file}: {wrong}")
    print(f"{len(files)} files: " + ", ".join(f"{n} {how}" for how, n in sorted(counts.items())))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
