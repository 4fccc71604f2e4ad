"""What every adapter needs: the view that it is asked for, the image that it gives back, its errors.

An adapter is called as `ADAPTER view.json out.png`, as every entrant is (methods/README.md). With
`--mask` as a third word it draws the objects white on black instead of their lines: tests compare
that with the object ids of the view.
"""

import json
import os
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path

BAD_INPUT = 2
ABSENT = 3  # the engine is not installed
FAILED = 1


class Absent(Exception):
    """The engine is not on this machine: which part, in a sentence."""


class Failed(Exception):
    """The engine did not draw: why, in a sentence."""


@dataclass
class View:
    """A view as view.json has it."""

    path: Path
    asked: dict

    @property
    def size_px(self):
        return self.asked["width_px"], self.asked["height_px"]

    def file(self, kind):
        """The path of one of its files: obj, glb, buffers or ids."""
        return (self.path.parent / self.asked["files"][kind]).resolve()


def read_view(path):
    """Exits with 2 if there is no view in the file."""
    try:
        asked = json.loads(Path(path).read_text(encoding="utf-8"))
        for key in ("width_px", "height_px", "view_from_world", "clip_from_view", "files"):
            asked[key]  # noqa: B018
    except (OSError, ValueError, KeyError) as error:
        refuse(f"{path}: {error} (accepted: a view as inkbench export writes it)")
    return View(Path(path), asked)


def refuse(message):
    print(message, file=sys.stderr)
    sys.exit(BAD_INPUT)


def store():
    """Where `install` puts npm packages."""
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(cache) / "inkbench" / "outside"


def find_program(name, adapter):
    """The path of a program on this machine. Raises Absent."""
    found = shutil.which(name)
    if found is None:
        raise Absent(f"{name} is not installed (methods/outside/install {adapter})")
    return found


def write_image(values, path):
    """Writes an array of (height, width) bytes, row 0 uppermost, as PNG."""
    from PIL import Image

    Image.fromarray(values, mode="L").save(path)


def run_adapter(draw):
    """Calls `draw(view, is_mask)`, writes the image that it returns and prints its time.

    `draw` returns (height, width) bytes, lines white, and the milliseconds of the engine's own
    clock. Ends with exit code 3 where the engine is missing, 1 where it failed, 2 for bad words.
    """
    words = sys.argv[1:]
    if len(words) not in (2, 3) or words[2:] not in ([], ["--mask"]):
        refuse(f"usage: {Path(sys.argv[0]).name} view.json out.png [--mask]")
    view = read_view(words[0])
    try:
        image, draw_ms = draw(view, words[2:] == ["--mask"])
        write_image(image, words[1])
    except Absent as reason:
        print(reason, file=sys.stderr)
        sys.exit(ABSENT)
    except Failed as reason:
        print(reason, file=sys.stderr)
        sys.exit(FAILED)
    except ModuleNotFoundError as error:
        print(f"{error.name} is not installed for {sys.executable}", file=sys.stderr)
        sys.exit(ABSENT)
    print(f"draw_ms {draw_ms:.4f}")
