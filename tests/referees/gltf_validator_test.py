"""What `inkbench bake` writes has no error or warning, by Khronos' validator, that its file had not.

Files are a part of those of gltf_matrix_test.py, scenes as `inkbench export` writes them, and those
of experiments/models/fetch that are here. Each is baked in every way, and once more: the second run
must change nothing. Copied vertices may be as bad as the vertices were, so kinds count, not numbers.

The validator is an npm package (methods/outside/install gltf_validator); without it, or without
Node, the test skips.
"""

import json
import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

from program import DESK, MODELS, ROOT, inkbench, skip

HERE = Path(__file__).resolve().parent
NAME = "gltf-validator"
INSTALL = "methods/outside/install gltf_validator"
WAYS = [("--codes", "surface8"), ("--codes", "label8", "--channel", "texcoord1"), ("--edges",),
        ("--codes", "surface8", "--channel", "texcoord2", "--edges")]
SCENES = ["cube", "teapot", "blocks"]
EVERY = 9  # of the matrix's files, which differ little from one to the next
WORST = 1  # errors are 0, warnings 1


def package_folder():
    """Where the package is; skips if it is not."""
    with open(ROOT / "methods" / "outside" / "engines.toml", "rb") as file:
        entry, = [e for e in tomllib.load(file)["package"] if e["name"] == NAME]
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(cache) / "inkbench" / "outside" / f"{NAME}-{entry['version']}"
    if not (folder / "package.json").exists():
        skip(f"{NAME} {entry['version']} is not here ({INSTALL})")
    return folder


def made_files():
    """Models of all kinds in the desk's folder."""
    folder = Path(DESK.name)
    matrix = subprocess.run([sys.executable, "-B", HERE / "gltf_matrix_test.py", "--keep",
                             folder / "matrix"], capture_output=True, text=True, check=False)
    if matrix.returncode != 0:
        raise RuntimeError(matrix.stdout + matrix.stderr)
    files = sorted((folder / "matrix").rglob("*.gl*"))[::EVERY]
    inkbench("export", *SCENES, "--size", "64x36", "--views", "1", "-o", "exported",
             "--truth", "none")
    files += sorted((folder / "exported").rglob("*.glb"))
    return files + sorted(MODELS.glob("*.gl*"))


def bake(file, number, way):
    """The file that is baked, or None if the program refuses the model itself."""
    once, again = (Path(DESK.name) / f"baked{number}{part}.glb" for part in ("", "_again"))
    try:
        inkbench("bake", file, "-o", once, *way)
    except RuntimeError as error:
        print(f"{file.name}: {str(error).splitlines()[-1]}")
        return None
    inkbench("bake", once, "-o", again, *way)
    if once.read_bytes() != again.read_bytes():
        raise RuntimeError(f"{file.name}: a second run changes something ({' '.join(way)})")
    again.unlink()
    return once


def kinds(found):
    """What errors and warnings there are, with the first of each."""
    return {code: issues[0] for code, issues in found.items() if issues[0][0] <= WORST}


def main():
    if shutil.which("node") is None:
        skip("there is no node here (Debian: nodejs)")
    package = package_folder()
    files = made_files()
    jobs = [(file, way, bake(file, i, way))
            for i, (file, way) in enumerate((f, w) for f in files for w in WAYS)]
    jobs = [job for job in jobs if job[2] is not None]
    paths = [*map(str, files), *(str(baked) for _, _, baked in jobs)]
    done = subprocess.run(["node", HERE / "gltf_validator.js", package], input="\n".join(paths),
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    found = dict(zip(paths, map(json.loads, done.stdout.splitlines()), strict=True))
    faults = 0
    for file, way, baked in jobs:
        before, after = kinds(found[str(file)]), kinds(found[str(baked)])
        for code in sorted(after.keys() - before.keys()):
            faults += 1
            print(f"{file.name} {' '.join(way)}: {code} at {after[code][1]}: {after[code][2]}")
    print(f"{len(files)} files baked in {len(WAYS)} ways, {len(jobs)} validated: {faults} new kinds "
          "of errors or warnings")
    return 1 if faults or len(jobs) < len(files) * len(WAYS) else 0


if __name__ == "__main__":
    sys.exit(main())
