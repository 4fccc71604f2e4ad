"""Runs the program and reads what it wrote: all that the referees know of it."""

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from mesh import write_obj
from outline import read_outline

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("INKBENCH", str(ROOT / "build" / "release" / "inkbench"))
WRITE_SCENE = os.environ.get("INKBENCH_WRITE_SCENE", str(Path(PROGRAM).parent / "write_scene"))
MODELS = ROOT / "inkbench-out" / "models"  # of experiments/models/fetch
SKIPPED = 77
DESK = tempfile.TemporaryDirectory(prefix="inkbench-referees-")


def skip(what):
    """Ends the test as skipped, with a sentence."""
    print(f"Skipped: {what}.")
    sys.exit(SKIPPED)


def inkbench(*words):
    """What the program printed. Raises RuntimeError with its words if it failed."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True,
                          cwd=DESK.name, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"inkbench {' '.join(map(str, words))}: exit {done.returncode}\n"
                           f"{done.stdout}{done.stderr}")
    return done.stdout


@dataclass
class Traced:
    """A truth as the program wrote it."""

    labels: np.ndarray  # (height, width) uint8: 0 none, 1 contour, 2 boundary, 3 crease,
    #                     4 intersection, 5 seam, 7 ignore
    outline: object  # outline.Outline: the visible lines, sub-pixel


def numbers(values):
    """x,y,z with every digit that a double has."""
    return ",".join(repr(float(v)) for v in values)


def trace(mesh, camera, crease_deg=40, crosscheck=False):
    """The truth of one view of a mesh, or of the model file at a path.

    With `crosscheck` it must agree with its cross-check, else a RuntimeError says how they differ.
    """
    folder = Path(DESK.name)
    model = Path(mesh) if isinstance(mesh, (str, Path)) else folder / "model.obj"
    if model.parent == folder:
        write_obj(mesh, model)
    lens = (f"--parallel={camera.parallel_height!r}" if camera.parallel_height
            else f"--fov={camera.fov_deg!r}")
    # With "=": an option's value may begin with a minus.
    checked = ["--crosscheck", "--disagreement", folder / "disagreement.png"] if crosscheck else []
    inkbench("truth", model, f"--eye={numbers(camera.eye)}", f"--target={numbers(camera.target)}",
             f"--up={numbers(camera.up)}", lens,
             f"--size={camera.width_px}x{camera.height_px}", f"--crease={crease_deg}",
             "-o", folder / "truth.png", "--svg", folder / "truth.svg", "--no-cache", "--quiet",
             *checked)
    return Traced(np.asarray(Image.open(folder / "truth.png")), read_outline(folder / "truth.svg"))
