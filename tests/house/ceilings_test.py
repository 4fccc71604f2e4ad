"""Code lines, as cloc counts them, stay below the ceilings of src/README.md: of each room, and of each language.

    ceilings_test.py            counts this checkout
    ceilings_test.py --counts   prints what is counted, as the table has it
"""

import json
import re
import shutil
import subprocess
import sys
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CPP = {"C++", "C/C++ Header"}
ROW = re.compile(r"^\| `?([\w/ +]+?)`? \| (\d+) \|", re.M)
SKIPPED = 77


def counts_of(files):
    """{row of the table: lines} of {path: (language, lines)}."""
    counts = Counter()
    for path, (language, lines) in files.items():
        top, *rest = path.split("/")
        if language not in CPP:
            counts[language] += lines
        elif top == "tests":
            counts["C++ of tests"] += lines
        elif top in ("src", "methods", "bench"):
            counts[f"src/{rest[0]}" if top == "src" and len(rest) > 1 else top] += lines
            counts["C++ in all"] += lines
    return {name: lines for name, lines in counts.items()
            if "/" in name or name.startswith("C++") or name in ("methods", "bench", "JavaScript", "Python", "GLSL")}


def breaches(counts, table):
    """A line for each count above its ceiling, without one, or with a ceiling and nothing below it."""
    for name in sorted(counts.keys() | table.keys()):
        if name not in table:
            yield f"{name}: {counts[name]} lines and no ceiling in src/README.md"
        elif name not in counts:
            yield f"{name}: a ceiling in src/README.md for what is not there"
        elif counts[name] > table[name]:
            yield f"{name}: {counts[name]} lines, of {table[name]} at most"


def table_of(page):
    part = page.partition("## Ceilings")[2].partition("\n## ")[0]
    return {name: int(most) for name, most in ROW.findall(part)}


def count_checkout():
    done = subprocess.run(["cloc", "--json", "--by-file", "--quiet", "--exclude-dir=.git,build,inkbench-out", "."],
                          cwd=ROOT, capture_output=True, text=True, check=True)
    return counts_of({path.removeprefix("./"): (entry["language"], entry["code"])
                      for path, entry in json.loads(done.stdout).items() if path not in ("header", "SUM")})


class Ceilings(unittest.TestCase):
    def test_hold(self):
        table = table_of((ROOT / "src/README.md").read_text())
        self.assertTrue(table, "src/README.md has no ceilings")
        self.assertEqual(list(breaches(count_checkout(), table)), [])

    def test_find_what_is_above_them(self):
        counts = counts_of({"src/core/a.cpp": ("C++", 7), "src/core/b.h": ("C/C++ Header", 3), "methods/x/x.cpp": ("C++", 5),
                            "tests/a_test.cpp": ("C++", 2), "src/report/page/a.js": ("JavaScript", 4), "a.md": ("Markdown", 9)})
        self.assertEqual(counts, {"src/core": 10, "methods": 5, "C++ in all": 15, "C++ of tests": 2, "JavaScript": 4})
        table = table_of("| core | 1 |\n## Ceilings\n| room | lines |\n|---|--:|\n| `src/core` | 9 |\n| methods | 5 |\n"
                         "| C++ in all | 15 |\n| C++ of tests | 2 |\n| Python | 3 |\n\n## More\n| bench | 1 |\n")
        self.assertEqual(list(breaches(counts, table)), [
            "JavaScript: 4 lines and no ceiling in src/README.md",
            "Python: a ceiling in src/README.md for what is not there",
            "src/core: 10 lines, of 9 at most"])


if __name__ == "__main__":
    if shutil.which("cloc") is None:
        print("Skipped: cloc is not installed (./bootstrap install installs it).")
        sys.exit(SKIPPED)
    if sys.argv[1:] == ["--counts"]:
        for name, lines in sorted(count_checkout().items()):
            print(f"| {name} | {lines} |")
    else:
        unittest.main(verbosity=2)
