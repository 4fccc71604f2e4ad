"""The gate: what not every change must pass is cut into parts, and every part has its turn.

    gate_test.py ROOT BUILD     ROOT is the checkout, BUILD a build tree whose tests are looked at
"""

import hashlib
import json
import re
import subprocess
import sys
import unittest
from collections import Counter
from pathlib import Path

ROOT, BUILD = (Path(word) for word in sys.argv[1:3])
NIGHT = ROOT / ".ci" / "night"
COMMITS = 200
START_PROGRAMS = {"program", "bench"}  # the sanitizers see what these start in a part of its own


def night(*words, code=0):
    done = subprocess.run([NIGHT, *words], capture_output=True, text=True, check=False)
    assert done.returncode == code, f"night {words}: exit code {done.returncode}\n{done.stderr}"
    return done.stderr if code else done.stdout


PARTS = [line.split()[0] for line in night("--list").splitlines()]


def commits():
    """The last hashes of this history; made-up ones for those that a shallow clone, or none, lacks."""
    done = subprocess.run(["git", "-C", ROOT, "rev-list", f"-{COMMITS}", "HEAD"], capture_output=True, text=True, check=False)
    known = done.stdout.split() if done.returncode == 0 else []
    return known + [hashlib.sha1(str(i).encode()).hexdigest() for i in range(COMMITS - len(known))]


class Gate(unittest.TestCase):
    def test_every_part_has_its_turn(self):
        drawn = Counter(night("--of", commit).strip() for commit in commits())
        self.assertEqual(set(drawn), set(PARTS))
        self.assertLess(max(drawn.values()), 3 * COMMITS / len(PARTS), drawn)
        self.assertIn("12ab", night("--of", "12ab", code=2))

    def test_a_part_is_one_of_the_list(self):
        said = night("nonsense", code=2)
        self.assertEqual(len(said.splitlines()), 1)
        for name in ("nonsense", *PARTS):
            self.assertIn(name, said)

    def test_minutes_stand_beside_each_part(self):
        for line in night("--list").splitlines():
            building, all_of_it = map(int, line.split()[1:3])
            self.assertLessEqual(all_of_it - building, 10, line)

    def test_every_nightly_test_is_of_a_part(self):
        done = subprocess.run(["ctest", "--show-only=json-v1"], cwd=BUILD, capture_output=True, text=True, check=True)
        labels = {label for test in json.loads(done.stdout)["tests"] for one in test["properties"]
                  if one["name"] == "LABELS" for label in one["value"] if label.startswith("nightly")}
        self.assertGreater(len(labels), 3)
        text = NIGHT.read_text(encoding="utf-8")
        for label in labels:
            self.assertIn(label.removeprefix("nightly-"), PARTS)
            name = label.removeprefix("nightly-")
            self.assertRegex(text, rf"nightly {name}\n|\b{name}\b[^\n]*\) nightly \"\$1\"")

    def test_the_sanitizers_see_every_room_once(self):
        rooms = Counter()
        for line in re.findall(r"tests/sanitizers/run asan ([a-z][^;\n]*)", NIGHT.read_text(encoding="utf-8")):
            rooms.update(line.split())
        tested = {name for path in (ROOT / "tests").glob("*/CMakeLists.txt")
                  for name in re.findall(r"^ink_test\((\w+)", path.read_text(encoding="utf-8"), re.M)}
        self.assertEqual(rooms, Counter(tested - START_PROGRAMS))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
