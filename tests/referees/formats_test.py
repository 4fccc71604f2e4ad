"""PLY, STL, OFF, OBJ and FBX as the referees write them come out as they were meant, or are refused by name."""

import subprocess
import tempfile
import unittest
from collections import Counter
from pathlib import Path

import numpy as np

from format_writers import all_cases
from program import PROGRAM


def export(files, folder):
    """(exit code, message) of `inkbench export` of files into a folder."""
    done = subprocess.run([PROGRAM, "export", *map(str, files), "-o", str(folder), "--size", "64x64"],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


def written(case, number, folder):
    """The file of a case; no two have one name before the dot, by which their folders are called."""
    path = Path(folder) / f"{number:03}_{case.name}"
    path.write_bytes(case.data)
    return path


def soup_of(folder):
    """(triangles as (m, 3, 3), count of objects) of an exported file."""
    mesh = next(folder.rglob("mesh.obj"))
    points, triangles, objects, origin = [], [], 0, (0, 0, 0)
    for line in mesh.read_text().splitlines():
        words = line.split()
        if words[:2] == ["#", "origin"]:
            origin = [float(w.rstrip(":")) for w in words[2:5]]
        elif words[:1] == ["v"]:
            points.append([float(w) + o for w, o in zip(words[1:4], origin)])
        elif words[:1] == ["f"]:
            triangles.append([points[int(w.split("/")[0]) - 1] for w in words[1:4]])
        elif words[:1] == ["o"]:
            objects += 1
    return np.array(triangles), objects


def key(triangle):
    """The triangle, whichever corner it begins with."""
    corners = [tuple(corner) for corner in triangle]
    first = corners.index(min(corners))
    return tuple(corners[first:] + corners[:first])


def area(triangle):
    return np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) / 2


def uncovered(case, soup):
    """What is wrong with the soup: triangles that are not there, not asked for, or do not cover their polygon."""
    points = np.array(case.points, float)
    left = Counter(map(key, soup))
    faults = []
    for polygon in case.polygons:
        corners = {tuple(points[c]) for c in polygon}
        mine = [t for t in left if corners.issuperset(t)]
        for triangle in mine:
            left[triangle] -= 1
        if len(polygon) == 3:
            if mine != [key(points[list(polygon)])]:
                faults.append(f"{polygon}: {mine}")
            continue
        whole = sum(area(points[[polygon[0], polygon[i], polygon[i + 1]]]) for i in range(1, len(polygon) - 1))
        parts = [area(np.array(t)) for t in mine]
        # All turned alike, none without area, and their sum the whole: they cover it once.
        is_right = len(parts) == len(polygon) - 2 and all(p @ whole > 0 for p in parts)
        if not is_right or np.abs(sum(parts) - whole).max() > 1e-9:
            faults.append(f"{polygon}: {mine}")
    return faults + [f"not asked for: {t}" for t, count in left.items() if count > 0]


class FormatsTest(unittest.TestCase):
    def test_all(self):
        with tempfile.TemporaryDirectory() as folder:
            cases = [(case, written(case, i, folder)) for i, case in enumerate(all_cases())]
            for case, path in cases:
                if not case.refusal:
                    continue
                with self.subTest(case.name):
                    code, message = export([path], Path(folder) / "refused")
                    self.assertEqual(code, 2, message)
                    self.assertIn(case.refusal, message)
                    self.assertEqual(message.count("\n"), 1, message)
            good = [(case, path) for case, path in cases if not case.refusal]
            out = Path(folder) / "out"
            code, message = export([path for _, path in good], out)
            self.assertEqual(code, 0, message)  # the first that was not read is named
            for case, path in good:
                with self.subTest(case.name):
                    soup, objects = soup_of(out / path.stem)
                    self.assertEqual(uncovered(case, soup), [])
                    self.assertEqual(objects, case.objects)
            print(f"{len(cases)} files: {len(good)} read as they were meant, the others refused by name")


if __name__ == "__main__":
    unittest.main(verbosity=2)
