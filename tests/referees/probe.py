"""Rays in double precision against every triangle that a place of the image can meet.

On the image, a triangle's three edges and its 1/w are affine functions of (x, y), so what a ray
meets is decided by signs, and how nearly it misses is a distance in px. Nothing is clipped: a
triangle that passes the eye has such functions too.
"""

import numpy as np

TILE_PX = 16


class Probe:
    """The triangles of a welded mesh as one camera sees them."""

    def __init__(self, welded, camera):
        self.welded, self.camera = welded, camera
        corners = welded.points[welded.faces] - camera.eye
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        normals = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], 1)
        volume = (a * normals[:, 0]).sum(1)
        sign = np.where(volume < 0, -1.0, 1.0)
        # (face, edge, coefficient of x, y and 1)
        edges = normals @ camera.ray_matrix() * sign[:, None, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            self.inverse_w = edges.sum(1) / np.abs(volume)[:, None]
            steep = np.linalg.norm(edges[..., :2], axis=2, keepdims=True)
            self.edges = np.where(steep > 0, edges / steep, edges)
        # Edge-on to within rounding: no place of the image meets it.
        self.is_seen = np.abs(volume) > 1e-12 * np.prod(np.linalg.norm(corners, axis=2), axis=1)
        self._tiles = self._sort_into_tiles(corners)

    def _sort_into_tiles(self, corners):
        camera = self.camera
        across = -(-camera.width_px // TILE_PX)
        down = -(-camera.height_px // TILE_PX)
        clip = camera.to_clip(corners + camera.eye)
        tiles = [[] for _ in range(across * down)]
        with np.errstate(divide="ignore", invalid="ignore"):
            places = clip[..., :2] / clip[..., 2:]
        low, high = places.min(1) - 1, places.max(1) + 1
        passes_eye = (clip[..., 2] <= 1e-9).any(1)
        behind = (clip[..., 2] <= 0).all(1)
        low[passes_eye], high[passes_eye] = 0, (camera.width_px, camera.height_px)
        low = np.clip(np.floor(np.nan_to_num(low, nan=0) / TILE_PX), 0, (across, down)).astype(int)
        high = np.clip(np.floor(np.nan_to_num(high, nan=1e9) / TILE_PX), -1,
                       (across - 1, down - 1)).astype(int)
        for face in np.flatnonzero(self.is_seen & ~behind):
            for y in range(low[face, 1], high[face, 1] + 1):
                for x in range(low[face, 0], high[face, 0] + 1):
                    tiles[y * across + x].append(face)
        self._across, self._down = across, down
        return [np.array(t, int) for t in tiles]

    def hits(self, places, slack_px=0.0):
        """What the rays through `places` ((n, 2) px) meet, or pass by less than `slack_px`.

        Returns arrays, one entry a hit: the place's index (ascending), the face, 1/w there, and the
        distance in px from the place to the nearest of the triangle's edges, negative outside.
        """
        places = np.asarray(places, float)
        tile = np.clip(np.floor(places / TILE_PX).astype(int), 0,
                       (self._across - 1, self._down - 1)) @ (1, self._across)
        order = np.argsort(tile, kind="stable")
        found = [[], [], [], []]
        starts = np.flatnonzero(np.r_[True, np.diff(tile[order]) != 0]) if len(order) else []
        for begin, end in zip(starts, np.r_[starts[1:], len(order)] if len(order) else []):
            faces = self._tiles[tile[order[begin]]]
            if len(faces) == 0:
                continue
            chunk = max(1, 4_000_000 // len(faces))
            for first in range(begin, end, chunk):
                mine = order[first:min(end, first + chunk)]
                at = np.concatenate([places[mine], np.ones((len(mine), 1))], 1)
                inverse_w = at @ self.inverse_w[faces].T
                inside = np.minimum.reduce([at @ self.edges[faces, k].T for k in range(3)])
                i, j = np.nonzero((inside >= -slack_px) & (inverse_w > 0))
                for values, new in zip(found, (mine[i], faces[j], inverse_w[i, j], inside[i, j])):
                    values.append(new)
        index, face, inverse_w, inside = (np.concatenate(v) if v else np.zeros(0) for v in found)
        order = np.argsort(index, kind="stable")
        return (index[order].astype(int), face[order].astype(int), inverse_w[order], inside[order])

    def seen_objects(self, places, tie):
        """A set of objects for each place: those within the share `tie` of the nearest hit.

        Also those whose edge the ray passes by less than 1e-6 px. Empty before the sky.
        """
        index, face, inverse_w, _ = self.hits(places, slack_px=1e-6)
        nearest = np.zeros(len(places))
        np.maximum.at(nearest, index, inverse_w)
        seen = [set() for _ in places]
        is_near = inverse_w >= nearest[index] * (1 - tie)
        for i, f in zip(index[is_near], face[is_near]):
            seen[i].add(int(self.welded.objects[f]))
        return seen
