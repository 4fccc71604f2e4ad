#!/usr/bin/python3
"""Keeps executed notebooks in the repository, small, and says of each cell which source drew its outputs.

    notebooks/keep.py EXECUTED.ipynb... [--into DIR]    default: this folder

A figure stays as a PNG, of a palette; its SVG goes. `stale(notebook)` names the cells that did not draw what stands
below them.
"""

import argparse
import base64
import hashlib
import io
import json
import sys
from pathlib import Path

COLOURS = 128
MARK = "source_sha256"


def hash_of(cell):
    return hashlib.sha256("".join(cell["source"]).encode()).hexdigest()


def code_cells(notebook):
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def stale(notebook):
    """The names of cells whose source is not the one that ran, or that never ran."""
    return [cell.get("id", "?") for cell in code_cells(notebook) if cell["metadata"].get(MARK) != hash_of(cell)]


def smaller(png):
    """The same picture in fewer bytes, in base64."""
    from PIL import Image
    picture = Image.open(io.BytesIO(base64.b64decode(png))).convert("RGB")
    file = io.BytesIO()
    picture.quantize(COLOURS, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(file, "PNG", optimize=True)
    return base64.b64encode(file.getvalue()).decode()


def kept(notebook):
    for cell in code_cells(notebook):
        cell["metadata"] = {MARK: hash_of(cell)}
        for output in cell["outputs"]:
            data = output.get("data", {})
            if "image/png" in data:
                output["data"] = {"image/png": smaller(data["image/png"])}
    return notebook


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("executed", nargs="+", type=Path)
    parser.add_argument("--into", type=Path, default=Path(__file__).parent, metavar="DIR")
    args = parser.parse_args()
    for path in args.executed:
        notebook = kept(json.loads(path.read_text(encoding="utf-8")))
        text = json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"
        (args.into / path.name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
