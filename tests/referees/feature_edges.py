"""The edges of a mesh that one eye sees as lines, by their definitions and in plain arithmetic."""

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

NONE, CONTOUR, BOUNDARY, CREASE, INTERSECTION, SEAM = range(6)
# cos^2 of the crease angles at which lattice faces meet exactly.
EXACT_SQUARES = {0: Fraction(1), 30: Fraction(3, 4), 45: Fraction(1, 2), 60: Fraction(1, 4),
                 90: Fraction(0)}


def exact_vector(p, q):
    return [Fraction(float(b)) - Fraction(float(a)) for a, b in zip(p, q)]


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def sides_of(points, eye):
    """The side of the plane through the eye and p0, p1 on which p2 lies, for points (n, 3, 3): the
    sign of a volume, exact."""
    a, b, c = (points[:, i] - eye for i in range(3))
    volume = (a * np.cross(b, c)).sum(1)
    size = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1) * np.linalg.norm(c, axis=1)
    sides = np.sign(volume).astype(int)
    for i in np.flatnonzero(np.abs(volume) <= 1e-13 * size):
        u, v, w = (exact_vector(eye, points[i, k]) for k in range(3))
        exact = dot(u, [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2],
                        v[0] * w[1] - v[1] * w[0]])
        sides[i] = (exact > 0) - (exact < 0)
    return sides


def is_crease(a, b, c0, c1, crease_deg):
    """Whether the faces (a, b, c0) and (a, b, c1) deviate from flat by at least the angle.

    With the components of c0 - a and c1 - a across the edge as u and v, the deviation's cosine is
    -u.v / |u||v|. Exact for the angles of EXACT_SQUARES, in doubles for others.
    """
    d, p, q = exact_vector(a, b), exact_vector(a, c0), exact_vector(a, c1)
    dd = dot(d, d)
    minus_cosine = dot(p, q) * dd - dot(p, d) * dot(q, d)
    squares = (dot(p, p) * dd - dot(p, d) ** 2) * (dot(q, q) * dd - dot(q, d) ** 2)
    if crease_deg in EXACT_SQUARES:
        # cos(deviation) <= cos(crease), and cos(crease) >= 0.
        return minus_cosine >= 0 or minus_cosine ** 2 <= EXACT_SQUARES[crease_deg] * squares
    cosine = -float(minus_cosine) / float(squares) ** 0.5
    return cosine <= np.cos(np.radians(crease_deg))


@dataclass
class Edges:
    """What the eye sees of each edge of a welded mesh."""

    classes: np.ndarray  # (k,)
    is_edge_on: np.ndarray  # (k,) all its faces lie in the line of sight


def _nearest_faces(welded, eye, a, b, faces):
    """The one of several faces on one side that is seen: no other lies before it."""
    def third(f):
        return next(v for v in welded.faces[f] if v not in (a, b))
    best = faces[0]
    for face in faces[1:]:
        # `face` is before `best` if the eye and best's third corner are on different sides of it.
        p = welded.points
        plane = np.array([[p[a], p[b], p[third(face)]]])
        to_eye = sides_of(plane, eye)[0]
        to_best = sides_of(plane, p[third(best)])[0]
        if to_eye * to_best < 0:
            best = face
    return best, third(best)


def classify(welded, eye, crease_deg):
    """The class of every edge for this eye."""
    counts = np.array([len(f) for f in welded.edge_faces])
    flat = np.concatenate([np.asarray(f, int) for f in welded.edge_faces])
    edge = np.repeat(np.arange(len(counts)), counts)
    corners = welded.faces[flat]
    ends = welded.edges[edge]
    is_third = (corners != ends[:, :1]) & (corners != ends[:, 1:])
    third = corners[np.arange(len(flat)), is_third.argmax(1)]
    sides = sides_of(welded.points[np.stack([ends[:, 0], ends[:, 1], third], 1)],
                     np.asarray(eye, float))
    starts = np.cumsum(counts) - counts
    classes = np.zeros(len(counts), int)
    edge_on = np.zeros(len(counts), bool)
    for i, (begin, count) in enumerate(zip(starts, counts)):
        mine, side = flat[begin:begin + count], sides[begin:begin + count]
        left, right = mine[side > 0], mine[side < 0]
        if len(left) == 0 and len(right) == 0:
            edge_on[i] = True
        elif len(left) == 0 or len(right) == 0:
            classes[i] = BOUNDARY if count == 1 else CONTOUR
        else:
            a, b = welded.edges[i]
            f0, c0 = _nearest_faces(welded, eye, a, b, left)
            f1, c1 = _nearest_faces(welded, eye, a, b, right)
            p = welded.points
            if is_crease(p[a], p[b], p[c0], p[c1], crease_deg):
                classes[i] = CREASE
            elif welded.objects[f0] != welded.objects[f1]:
                classes[i] = SEAM
    return Edges(classes, edge_on)
