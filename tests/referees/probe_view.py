"""One truth judged by rays: what it draws is there, and what is there it draws.

Three questions. `drawn`: is each place of a drawn line visible, and on an edge of its class?
`missing`: has each visible place of an edge that is a line one drawn? `passed`: is there a line
wherever two neighbouring pixel centres see different objects, or one the sky?
"""

from dataclasses import dataclass, field

import numpy as np

from crossings import find_crossings
from feature_edges import INTERSECTION, classify
from mesh import weld
from outline import CLASSES, distances_px, make_outline
from probe import Probe

ON_LINE_PX = 0.01  # a drawn place and its line: the SVG rounds to 1/1000 px
CLEAR_PX = 0.02  # what hides a place covers it by this much: truth ends lines within 1/512 px
TIE = 1e-6  # two surfaces whose 1/w differ by a smaller share lie on each other


@dataclass
class Verdict:
    """Places looked at and places that failed: (x_px, y_px, why) each."""

    asked: int = 0
    failed: list = field(default_factory=list)
    undecided: int = 0  # of those looked at: what lies there is a tie within rounding

    @property
    def agreement(self):
        return 1 - len(self.failed) / self.asked if self.asked else 1.0

    def add(self, other):
        self.asked += other.asked
        self.failed += other.failed
        self.undecided += other.undecided

    def judge_drawn(self, places, is_hidden, is_tie, distances_px, names):
        """Adds one place of a line per entry of the five sequences: it fails if it is in plain
        view, is no tie within rounding, and no line of the truth is near (distance infinite)."""
        for place, hidden, tie, distance, name in zip(places, is_hidden, is_tie, distances_px,
                                                      names):
            if hidden:
                continue
            self.asked += 1
            if np.isfinite(distance):
                continue
            if tie:
                self.undecided += 1
            else:
                self.failed.append((*place, f"{name}: not drawn"))

    def __str__(self):
        return (f"{self.asked} places, {len(self.failed)} failed, {self.undecided} undecided: "
                f"{100 * self.agreement:.3f} %")


class View:
    """A mesh seen by a camera, ready to judge any truth of it."""

    def __init__(self, mesh, camera, crease_deg=40):
        self.welded, self.camera = weld(mesh), camera
        self.probe = Probe(self.welded, camera)
        self.edges = classify(self.welded, np.asarray(camera.eye, float), crease_deg)
        self.neighbours = [set(f) for f in self.welded.edge_faces]
        clip = camera.to_clip(self.welded.points[self.welded.edges])  # (edge, end, 3)
        self.is_ahead = (clip[..., 2] > 0).all(1)
        with np.errstate(divide="ignore", invalid="ignore"):
            self.ends_px = clip[..., :2] / clip[..., 2:]
            self.ends_inverse_w = 1 / clip[..., 2]

    # ---- What rays meet at places of edges ---------------------------------------------------

    def edge_places(self, edges, shares):
        """Of each place of an edge: is it hidden, is it nearly hidden, does another surface touch
        it. `shares` is how far along the edge on the image, 0..1."""
        a, b = self.ends_px[edges, 0], self.ends_px[edges, 1]
        places = a + shares[:, None] * (b - a)
        inverse_w = (self.ends_inverse_w[edges, 0] * (1 - shares)
                     + self.ends_inverse_w[edges, 1] * shares)
        return self._hidden(places, inverse_w, lambda i, face: face in self.neighbours[edges[i]])

    def _edges_near(self, place, edges):
        """Of `edges` those within ON_LINE_PX of a place, and how far along them, 0..1."""
        a, b = self.ends_px[edges, 0], self.ends_px[edges, 1]
        along = b - a
        t = ((place - a) * along).sum(1) / np.maximum((along * along).sum(1), 1e-30)
        t = np.clip(t, 0, 1)
        near = np.hypot(*(a + t[:, None] * along - place).T) <= ON_LINE_PX
        return edges[near], t[near]

    def _inside(self, places):
        """Which places lie in the frame, half a pixel from its borders."""
        size = np.array([self.camera.width_px, self.camera.height_px])
        return ((places > 0.5) & (places < size - 0.5)).all(1)

    def _hidden(self, places, inverse_w, is_own):
        """Of each place at this 1/w: does anything but its own faces hide it by CLEAR_PX or more,
        does anything come within .05 px of hiding it, does another surface touch it.

        `is_own(i, face)` says whether a face is the i-th place's own.
        """
        index, face, hit, inside = self.probe.hits(places, slack_px=0.05)
        foreign = ~np.array([is_own(i, f) for i, f in zip(index, face)], bool)
        before = foreign & (hit > inverse_w[index] * (1 + TIE))
        touching = foreign & (np.abs(hit / inverse_w[index] - 1) <= TIE)
        answers = np.zeros((3, len(places)), bool)
        for answer, found in zip(answers, (before & (inside > CLEAR_PX), before, touching)):
            answer[index[found]] = True
        return answers

    # ---- What is drawn is there --------------------------------------------------------------

    def judge_drawn(self, outline, count, random):
        """Looks at `count` random places of the drawn lines, their ends left out."""
        verdict = Verdict()
        long_enough = np.flatnonzero(outline.lengths_px() > 0.2)
        if len(long_enough) == 0:
            return verdict
        weights = outline.lengths_px()[long_enough]
        pieces = random.choice(long_enough, count, p=weights / weights.sum())
        share = 0.08 / outline.lengths_px()[pieces]
        t = (share + random.random(count) * (1 - 2 * share))[:, None]
        places = outline.pieces[pieces, 0] * (1 - t) + outline.pieces[pieces, 1] * t
        candidates = np.flatnonzero(self.is_ahead)
        rows = []  # (place, edge, share along it)
        for i, place in enumerate(places):
            edges, along = self._edges_near(place, candidates)
            rows += [(i, e, s) for e, s in zip(edges, along)]
        best = ["no edge here"] * count
        if rows:
            which = np.array([r[0] for r in rows])
            edges = np.array([r[1] for r in rows])
            hidden, _, touched = self.edge_places(edges, np.array([r[2] for r in rows]))
            for i, edge, is_hidden, is_touched in zip(which, edges, hidden, touched):
                wanted = outline.classes[pieces[i]]
                why = ("" if self.edges.classes[edge] == wanted else
                       f"an edge of class {CLASSES[self.edges.classes[edge]]}")
                if is_hidden:
                    why = "hidden"
                elif why and (is_touched or self.edges.is_edge_on[edge]):
                    why = "tie"
                rank = ("", "tie").index(why) if why in ("", "tie") else 2
                now = ("", "tie").index(best[i]) if best[i] in ("", "tie") else 3
                if rank < now:
                    best[i] = why
        for i in np.flatnonzero([b not in ("",) for b in best]):
            if outline.classes[pieces[i]] == INTERSECTION and self._is_crossing(places[i]):
                best[i] = ""
        for i, why in enumerate(best):
            verdict.asked += 1
            verdict.undecided += why == "tie"
            if why not in ("", "tie"):
                name = CLASSES[outline.classes[pieces[i]]]
                verdict.failed.append((*places[i], f"{name}: {why}"))
        return verdict

    def _is_crossing(self, place):
        """Whether two triangles cross at this place of the image, before all others."""
        _, face, hit, inside = self.probe.hits(place[None], slack_px=CLEAR_PX)
        solid = hit[inside > CLEAR_PX]
        for i in range(len(face)):
            for j in range(i):
                shared = np.intersect1d(self.welded.faces[face[i]], self.welded.faces[face[j]])
                difference = self.probe.inverse_w[face[i]] - self.probe.inverse_w[face[j]]
                steep = np.hypot(*difference[:2])
                is_on = abs(hit[i] - hit[j]) <= ON_LINE_PX * steep
                if len(shared) < 2 and is_on and (solid <= max(hit[i], hit[j]) * (1 + TIE)).all():
                    return True
        return False

    # ---- What is there is drawn --------------------------------------------------------------

    def line_places(self, step_px):
        """Places every `step_px` along the edges that are lines here, inside the frame: (n, 2) px,
        the edge and the share along it of each."""
        lines = np.flatnonzero((self.edges.classes > 0) & self.is_ahead)
        ends = make_outline([(1, self.ends_px[e]) for e in lines])
        places, piece, _ = ends.samples(step_px)
        kept = self._inside(places)
        places, edges = places[kept], lines[piece[kept]]
        a, b = self.ends_px[edges, 0], self.ends_px[edges, 1]
        length = np.linalg.norm(b - a, axis=1)
        return places, edges, np.linalg.norm(places - a, axis=1) / np.maximum(length, 1e-30)

    def judge_missing(self, outline, count, random, step_px=1.0):
        """Looks at up to `count` places of edges that are lines and in plain view."""
        verdict = Verdict()
        places, edges, shares = self.line_places(step_px)
        chosen = random.permutation(len(places))[:count]
        places, edges, shares = places[chosen], edges[chosen], shares[chosen]
        if len(places) == 0:
            return verdict
        _, nearly, touched = self.edge_places(edges, shares)
        distance, _ = distances_px(places, outline, 0.05)
        names = [CLASSES[c] for c in self.edges.classes[edges]]
        verdict.judge_drawn(places, nearly, touched, distance, names)
        return verdict

    def judge_crossings(self, outline, step_px=2.0):
        """Looks at every place, `step_px` apart, in plain view where two triangles pierce each
        other. By brute force: for small meshes."""
        verdict = Verdict()
        segments, faces = find_crossings(self.welded)
        clip = self.camera.to_clip(segments)
        # A face that is seen edge-on covers nothing, so its crossings are no lines.
        kept = (clip[..., 2] > 0).all(1) & self.probe.is_seen[faces].all(1)
        clip, faces = clip[kept], faces[kept]
        ends = clip[..., :2] / clip[..., 2:]
        places, piece, _ = make_outline((INTERSECTION, e) for e in ends).samples(step_px)
        kept = self._inside(places)
        places, piece = places[kept], piece[kept]
        inverse_w = np.einsum("ij,ij->i", np.concatenate([places, np.ones((len(places), 1))], 1),
                              self.probe.inverse_w[faces[piece, 0]])
        _, nearly, touched = self._hidden(places, inverse_w,
                                          lambda i, face: face in faces[piece[i]])
        near, _ = distances_px(places, outline, 0.05)
        verdict.judge_drawn(places, nearly, touched, near, ["intersection"] * len(places))
        return verdict

    def judge_passed(self, outline, step=1):
        """Looks at the steps along every `step`-th row and column of pixel centres; counts those
        from one object to another, or to the sky."""
        verdict = Verdict()
        width, height = self.camera.width_px, self.camera.height_px
        for along in (0, 1):
            fixed = np.arange((height, width)[along])[::step] + 0.5
            moving = np.arange((width, height)[along]) + 0.5
            grid = np.stack(np.meshgrid(fixed, moving, indexing="ij"), -1)
            places = grid[..., ::-1] if along == 0 else grid
            seen = self.probe.seen_objects(places.reshape(-1, 2), TIE)
            row = len(moving)
            pairs = [i for i in range(len(seen) - 1)
                     if (i + 1) % row and seen[i] != seen[i + 1] and not seen[i] & seen[i + 1]]
            verdict.asked += len(pairs)
            flat = places.reshape(-1, 2)
            for i in pairs:
                if not crosses(flat[i], flat[i + 1], outline):
                    verdict.failed.append((*flat[i], f"objects {sorted(seen[i])} and "
                                           f"{sorted(seen[i + 1])}, no line between"))
        return verdict

    # ---- What another program draws ----------------------------------------------------------

    def are_flat(self, places, along, crease_deg, aside_px=0.3):
        """Whether the surface goes on across each place: to either side of a line that runs
        `along`, rays meet one object, in faces that join there and bend by less than a crease."""
        across = np.stack([-along[:, 1], along[:, 0]], 1)
        across = across * aside_px / np.maximum(np.linalg.norm(across, axis=1), 1e-30)[:, None]
        first, second = (self._front(places + s * across) for s in (-1, 1))
        flat = np.zeros(len(places), bool)
        for i, (f, g) in enumerate(zip(first, second)):
            if f < 0 or g < 0 or self.welded.objects[f] != self.welded.objects[g]:
                continue
            difference = self.probe.inverse_w[f] - self.probe.inverse_w[g]
            steep = np.linalg.norm(self.probe.inverse_w[[f, g], :2], axis=1).max()
            joins = abs(difference @ (*places[i], 1)) <= 2 * aside_px * steep
            normals = [self._facing_normal(face) for face in (f, g)]
            bend_deg = np.degrees(np.arccos(np.clip(normals[0] @ normals[1], -1, 1)))
            flat[i] = f == g or (joins and bend_deg < crease_deg)
        return flat

    def _front(self, places):
        """The nearest face at each place, -1 before the sky."""
        index, face, inverse_w, _ = self.probe.hits(places, slack_px=1e-6)
        front = np.full(len(places), -1)
        order = np.lexsort((inverse_w, index))
        front[index[order]] = face[order]  # the last one written is the nearest
        return front

    def _facing_normal(self, face):
        """Unit, on the side of the eye."""
        a, b, c = self.welded.points[self.welded.faces[face]]
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal)
        return normal if normal @ (self.camera.eye - a) > 0 else -normal


def crosses(a, b, outline, slack_px=ON_LINE_PX):
    """Whether a line passes between two places a pixel apart, or within `slack_px` of that."""
    p, q = outline.pieces[:, 0], outline.pieces[:, 1]
    low = np.minimum(a, b) - slack_px
    high = np.maximum(a, b) + slack_px
    near = ((np.minimum(p, q) <= high) & (np.maximum(p, q) >= low)).all(1)
    p, q = p[near], q[near]
    # The pair is parallel to an axis: clip the piece to the thin box round it.
    along = q - p
    begin, end = np.zeros(len(p)), np.ones(len(p))
    for k in range(2):
        with np.errstate(divide="ignore", invalid="ignore"):
            t0, t1 = (low[k] - p[:, k]) / along[:, k], (high[k] - p[:, k]) / along[:, k]
        moves = along[:, k] != 0
        begin = np.where(moves, np.maximum(begin, np.minimum(t0, t1)), begin)
        end = np.where(moves, np.minimum(end, np.maximum(t0, t1)), end)
    return bool((begin <= end).any())
