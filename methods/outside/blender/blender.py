"""Blender as a child process: what its two adapters call."""

import re
import subprocess
import tempfile
from pathlib import Path

import numpy
from entrant import Failed, find_program

VERSION = "3.4"


def call(adapter, script, view, out, is_mask):
    """Runs `script` in Blender on a view; what it writes is in `out`. Returns its milliseconds.

    Raises Absent without Blender, Failed if the script or Blender fails.
    """
    program = find_program("blender", adapter)
    done = subprocess.run(
        [program, "-b", "--factory-startup", "--python-exit-code", "1", "-P", str(script), "--",
         str(view.path), str(view.file("obj")), str(out), "mask" if is_mask else "lines"],
        capture_output=True, text=True, check=False)
    said = re.findall(r"^failed: (.*)$", done.stdout, re.M)
    if done.returncode != 0 or not Path(out).exists():
        how = f"crashed (signal {-done.returncode})" if done.returncode < 0 else "failed"
        last = (done.stdout + done.stderr).strip().splitlines()[-1:]
        raise Failed(f"Blender {how}: {(said or last or ['it does not say why'])[0]}")
    return float(re.findall(r"^draw_ms (\S+)$", done.stdout, re.M)[-1])


def read_gray(path):
    from PIL import Image

    return numpy.asarray(Image.open(path).convert("L"))


def render(adapter, script, view, is_mask):
    """The image that `script` renders, and its milliseconds."""
    with tempfile.TemporaryDirectory(prefix="inkbench-blender-") as folder:
        out = Path(folder) / "out.png"
        draw_ms = call(adapter, script, view, out, is_mask)
        return read_gray(out), draw_ms
