#!/usr/bin/python3 -B
"""Entrants in three.js: ADAPTER view.json out.png, where ADAPTER is a link to this file beside the pass.js that draws.

The clock holds all passes on software GL, up to reading back a pixel; the median of five.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import browser  # noqa: E402
from entrant import Absent, find_program, run_adapter, store  # noqa: E402

ADAPTER = Path(sys.argv[0])
THREE = "three-0.160.0"


def draw(view, is_mask):
    chromium = find_program("chromium", ADAPTER.name)
    three = store() / THREE
    if not (three / "build" / "three.module.js").exists():
        raise Absent(f"{THREE} is not in {three} (methods/outside/install {ADAPTER.name})")
    address = f"adapter/page.html?what={'mask' if is_mask else 'lines'}&pass=pass.js"
    page = (address, {"three": three, "adapter": HERE, "pass": ADAPTER.parent}, {"view/mesh.glb": view.file("glb")})
    return browser.drawn_by_page("three.js", chromium, page, view, browser.SOFTWARE_GL)


if __name__ == "__main__":
    run_adapter(draw)
