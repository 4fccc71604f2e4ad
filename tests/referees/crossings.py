"""Where triangles pierce each other, by brute force: for small meshes alone."""

import numpy as np

CHUNK = 200_000  # pairs at a time


def _planes(corners):
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return normal, (normal * corners[:, 0]).sum(1)


def _cut(corners, distances):
    """Where the sides of triangles (n, 3, 3) pass a plane from which their corners lie these
    distances, one corner alone on its side: (n, 2, 3)."""
    positive = distances > 0
    alone = np.where((positive.sum(1) == 1)[:, None], positive, ~positive).argmax(1)
    rows = np.arange(len(corners))
    ends = []
    for other in (1, 2):
        j = (alone + other) % 3
        t = distances[rows, alone] / (distances[rows, alone] - distances[rows, j])
        ends.append(corners[rows, alone] + t[:, None] * (corners[rows, j] - corners[rows, alone]))
    return np.stack(ends, 1)


def find_crossings(welded, clear=1e-6):
    """Segments (k, 2, 3) in which two triangles run through each other, and the faces (k, 2).

    Only where each has corners on both sides of the other's plane, further from it than the share
    `clear` of the mesh: what merely touches is left out.
    """
    corners = welded.points[welded.faces]
    size = np.ptp(welded.points, axis=0).max() * clear
    normal, offset = _planes(corners)
    low, high = corners.min(1), corners.max(1)
    count = len(corners)
    segments, pairs = [np.zeros((0, 2, 3))], [np.zeros((0, 2), int)]
    for first in range(0, count, max(1, CHUNK // count)):
        mine = np.arange(first, min(count, first + max(1, CHUNK // count)))
        meet = ((low[mine, None] <= high[None]) & (high[mine, None] >= low[None])).all(2)
        i, j = np.nonzero(meet & (mine[:, None] < np.arange(count)[None]))
        i = mine[i]
        to_j = (corners[i] * normal[j, None]).sum(2) - offset[j, None]
        to_i = (corners[j] * normal[i, None]).sum(2) - offset[i, None]
        pierce = np.ones(len(i), bool)
        for d in (to_i, to_j):
            pierce &= (np.abs(d) > size).all(1) & (d.min(1) < 0) & (d.max(1) > 0)
        i, j, to_i, to_j = i[pierce], j[pierce], to_i[pierce], to_j[pierce]
        if len(i) == 0:
            continue
        cuts = np.concatenate([_cut(corners[i], to_j), _cut(corners[j], to_i)], 1)
        along = np.cross(normal[i], normal[j])
        at = (cuts * along[:, None]).sum(2)
        # Two intervals on the common line: the middle two of their four ends bound what is common.
        begin = np.maximum(at[:, :2].min(1), at[:, 2:].min(1))
        end = np.minimum(at[:, :2].max(1), at[:, 2:].max(1))
        order = np.argsort(at, axis=1)
        rows = np.arange(len(i))
        common = np.stack([cuts[rows, order[:, 1]], cuts[rows, order[:, 2]]], 1)
        long_enough = end - begin > size * np.linalg.norm(along, axis=1)
        segments.append(common[long_enough])
        pairs.append(np.stack([i, j], 1)[long_enough])
    return np.concatenate(segments), np.concatenate(pairs)
