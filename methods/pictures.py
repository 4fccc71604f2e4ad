#!/usr/bin/python3
"""Makes the pictures in the pages of methods again.

    methods/pictures.py [PAGE.md...] [--program PATH]

A page shows a picture and says how it is made:

    ![mote2 on gem: ...](mote2.png)
    ...
    Made by `inkbench figures gem --methods mote2 --only strips --format png`.

The command is run as it stands, in a folder of its own, and its strips.png becomes the picture. Without pages, all of
methods/*/*.md are looked at. Needs the built program. Exit code 2: a page or the program is not as it must be; no
picture is then half-written.
"""

import argparse
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

SHOWN = re.compile(r"!\[[^\]]*\]\((?P<picture>\w+\.png)\).*?Made by\s+`inkbench (?P<asked>figures [^`]*)`", re.DOTALL)


class BadPage(Exception):
    """What a page asks for cannot be had: where, what is wrong, what is accepted."""

    def __init__(self, where, what, accepted):
        super().__init__(f"{where}: {what} (accepted: {accepted})")


def make_picture(page, program):
    """Draws what a page asks for and puts it beside the page."""
    shown = SHOWN.search(page.read_text(encoding="utf-8"))
    if shown is None:
        raise BadPage(page, "it shows no picture that it says how to make",
                      "an image, and after it: Made by `inkbench figures ...`")
    with tempfile.TemporaryDirectory() as folder:
        words = [str(program), *shlex.split(shown["asked"]), "--quiet", "--out", folder]
        ran = subprocess.run(words, capture_output=True, text=True)
        drawn = Path(folder) / "strips.png"
        if ran.returncode != 0 or not drawn.exists():
            raise BadPage(page, ran.stderr.strip() or "the command drew no strips.png",
                          "a command that draws strips as PNG")
        shutil.copyfile(drawn, page.with_name(shown["picture"]))
    print(page.with_name(shown["picture"]).relative_to(ROOT), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*", type=Path, help="pages (default: all of methods/*/*.md)")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/inkbench",
                        help="the built program (default: build/release/inkbench)")
    args = parser.parse_args()
    try:
        if not args.program.exists():
            raise BadPage(args.program, "there is no such program", "a built inkbench")
        # A method's page has the name of its folder; those of methods/outside are not of methods.
        pages = [page for page in sorted(ROOT.glob("methods/*/*.md")) if page.stem == page.parent.name]
        for page in args.pages or pages:
            if not page.exists():
                raise BadPage(page, "there is no such page", "a page of a method")
            make_picture(page.resolve(), args.program.resolve())
    except BadPage as reason:
        print(reason, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
