#!/usr/bin/python3 -B
"""Shaders of methods in WebGL 2 as entrants: webgl_NAME view.json out.png, where webgl_NAME is a link to this file.

The page of `inkbench page` draws the view's mesh in a headless Chromium. Its clock holds the mesh and the lines of a frame,
by many frames in a row on software GL, up to reading back a pixel.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import browser  # noqa: E402
from entrant import Absent, Failed, find_program, run_adapter  # noqa: E402

ADAPTER = Path(sys.argv[0]).name
# Mesa's llvmpipe snaps vertices to 1/256 px, as GPUs do and the testbed does; SwiftShader, which Chromium
# brings along, snaps them to 1/16 px.
MESA_GL = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]


def find_inkbench():
    """The program: $INKBENCH, or that of this checkout, or the installed one. Raises Absent."""
    built = HERE.parents[2] / "build" / "release" / "inkbench"
    for found in (os.environ.get("INKBENCH"), built, shutil.which("inkbench")):
        if found and Path(found).exists():
            return str(found)
    raise Absent(f"inkbench is not built in {built.parent}, and INKBENCH names no other")


def draw(view, is_mask):
    """The lines of the method at a view, and the milliseconds of a frame by the page's clock."""
    chromium = find_program("chromium", ADAPTER)
    inkbench = find_inkbench()
    with tempfile.TemporaryDirectory(prefix="inkbench-webgl-") as folder:
        made = Path(folder) / "page.html"
        done = subprocess.run([inkbench, "page", str(view.file("glb")), "-o", str(made)],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"inkbench page: {done.stderr.strip()[:180]}")
        address = f"adapter/draw.html?method={'' if is_mask else ADAPTER.removeprefix('webgl_')}"
        page = (address, {"adapter": HERE}, {"made/page.html": made})
        return browser.drawn_by_page("the page", chromium, page, view, MESA_GL)


if __name__ == "__main__":
    run_adapter(draw)
