"""A reader of OBJ files: places and triangles, nothing else."""

import numpy as np

from mesh import Mesh, Part, rounded


def _fans(polygons):
    """Triangles of polygons, each a fan from its first corner."""
    return [(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)]


def _used(name, points, faces):
    """A part with those points alone that its triangles use."""
    used, faces = np.unique(np.asarray(faces), return_inverse=True)
    return Part(name, points[used], faces.reshape(-1, 3))


def read_obj(path):
    """A part for each `o` or `g` that has faces. Places are the file's: `# origin` is added to them."""
    points, groups, now, origin = [], {}, "all", (0, 0, 0)
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[:2] == ["#", "origin"]:
                origin = [float(w.rstrip(":")) for w in words[2:5]]
            elif words[0] == "v":
                points.append([float(w) + o for w, o in zip(words[1:4], origin)])
            elif words[0] in "og":
                now = " ".join(words[1:]) or "all"
            elif words[0] == "f":
                corners = [int(w.split("/")[0]) for w in words[1:]]
                corners = [c - 1 if c > 0 else len(points) + c for c in corners]
                groups.setdefault(now, []).append(corners)
    points = rounded(points)
    return Mesh([_used(f"part{i}", points, _fans(polygons))
                 for i, polygons in enumerate(groups.values())])
