"""A view of a scene of whole numbers from an eye of whole numbers: what hides a place of an edge is
decided by integers alone, so that an eye in the very plane of a face or of two edges is no tie.
"""

import numpy as np

from probe_view import View

STEPS = 1 << 14  # an edge's places: a + (b - a) i / STEPS
BESIDE_PX = 0.05  # within so much of a change a place says nothing: lines end within 1/512 px


def whole(values):
    """As int64; ValueError if they are no whole numbers."""
    numbers = np.asarray(values, float)
    if (numbers != np.rint(numbers)).any():
        raise ValueError(f"{numbers[numbers != np.rint(numbers)][0]} is no whole number")
    return numbers.astype(np.int64)


class ExactView(View):
    """As View, of a mesh and an eye on the lattice.

    A closed triangle hides what lies behind its plane, unless the plane holds the eye. Of the faces
    round a place, those that hold the whole edge counted, the nearest to either side is seen.
    """

    def __init__(self, mesh, camera, crease_deg=40):
        super().__init__(mesh, camera, crease_deg)
        self._p = whole(self.welded.points) - whole(camera.eye)
        a, b, c = (self._p[self.welded.faces[:, k]] for k in range(3))
        self._sides = np.stack([np.cross(a, b), np.cross(b, c), np.cross(c, a)], 1)  # (face, 3, 3)
        self._normals = np.cross(b - a, c - a)
        self._offsets = (self._normals * a).sum(1)
        self._facing = -np.sign(self._offsets)

    def edge_places(self, edges, shares):
        """Of each place of an edge: is it hidden, is it that or next to what is, does another
        surface touch it so that this alone does not say what is drawn."""
        edges, shares = np.asarray(edges, int), np.asarray(shares, float)
        lengths = np.linalg.norm(self.ends_px[edges, 1] - self.ends_px[edges, 0], axis=1)
        beside = BESIDE_PX / np.maximum(lengths, 1e-9)
        answers = [self._hidden_exactly(edges, np.clip(shares + step * beside, 0, 1))
                   for step in (-1, 0, 1)]
        hidden = np.logical_and.reduce([a[0] for a in answers])
        nearly = np.logical_or.reduce([a[0] for a in answers])
        touched = np.logical_or.reduce([a[1] for a in answers])
        return hidden, nearly, touched

    def _steps_of(self, edges, shares):
        """The whole step of an edge nearest to a share of its way on the image."""
        w = 1 / self.ends_inverse_w[edges]
        along = shares * w[:, 0] / ((1 - shares) * w[:, 1] + shares * w[:, 0])
        return np.clip(np.rint(along * STEPS), 1, STEPS - 1).astype(np.int64)

    def _hidden_exactly(self, edges, shares):
        """Hidden, and touched, of each place."""
        step = self._steps_of(edges, shares)[:, None]
        a, b = self._p[self.welded.edges[edges, 0]], self._p[self.welded.edges[edges, 1]]
        places = a * (STEPS - step) + b * step  # times STEPS, from the eye
        sides = np.sign(np.einsum("pk,fsk->pfs", places, self._sides))
        is_met = ((sides >= 0).all(2) | (sides <= 0).all(2)) & (self._facing != 0)
        heights = np.sign(places @ self._normals.T - STEPS * self._offsets)
        holds_edge = (a @ self._normals.T == self._offsets) & (b @ self._normals.T == self._offsets)
        is_own = np.zeros(is_met.shape, bool)
        for i, edge in enumerate(edges):
            is_own[i, self.welded.edge_faces[edge]] = True
        hidden = (is_met & ~is_own & (heights * self._facing < 0)).any(1)
        touching = is_met & ~is_own & holds_edge
        touched = touching.any(1)
        for i in np.flatnonzero(touched & ~hidden):
            seen = self._seen_sheets(edges[i], np.flatnonzero(touching[i]))
            hidden[i] = not any(is_own[i, f] for f in seen)
            touched[i] = not all(is_own[i, f] for f in seen)
        return hidden, touched

    def _seen_sheets(self, edge, touching):
        """Of the edge's own faces and those that hold it, the nearest to the eye on each side: a
        list of none, one or two."""
        ends = self.welded.edges[edge]
        a, b = self._p[ends[0]], self._p[ends[1]]
        best = {}
        for face in [*self.welded.edge_faces[edge], *touching]:
            if self._facing[face] == 0:
                continue
            for v in self.welded.faces[face]:
                side = int(np.sign(np.cross(a, b) @ self._p[v]))
                if v in ends or side == 0:
                    continue
                if side not in best or self._is_before((face, v), best[side], a, b):
                    best[side] = (face, v)
        return [face for face, _ in best.values()]

    def _is_before(self, sheet, other, a, b):
        """Whether a sheet hides another on the same side; of level ones the lower face does."""
        normal = np.cross(b - a, self._p[sheet[1]] - a)
        to_other, to_eye = normal @ (self._p[other[1]] - a), -normal @ a
        return sheet[0] < other[0] if to_other == 0 else to_other * to_eye < 0
