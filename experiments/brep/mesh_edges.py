"""The edges of a model that experiments/brep/tessellate wrote, and rules that say which are creases."""

import json
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

FLAT_DEG = 1  # facets that bend by less are one
PARALLEL_COS = np.cos(np.radians(20))
HARD = 2


@dataclass
class MeshEdges:
    """The edges of two triangles of all objects, one line each."""

    length: np.ndarray  # share of the diagonal of the model's box
    bend_deg: np.ndarray  # by which the triangles deviate from flat
    is_marked: np.ndarray  # as hard
    beside_deg: np.ndarray  # (n, 2): the largest bend beyond the facet on either side, along the edge
    width: np.ndarray  # (n, 2): how wide those facets are, share of the diagonal

    def share(self, which, of):
        """Of the length of the edges `of`, that of `which`; 1 where there are none."""
        whole = self.length[of].sum()
        return self.length[of & which].sum() / whole if whole > 0 else 1.0


def read_objects(path):
    """Points, triangles and marks (a number of 0..3 a side) of each object of a .glb."""
    data = path.read_bytes()
    json_bytes = int.from_bytes(data[12:16], "little")
    gltf = json.loads(data[20:20 + json_bytes])
    binary = data[28 + json_bytes:]

    def numbers(accessor, kind):
        view = gltf["bufferViews"][gltf["accessors"][accessor]["bufferView"]]
        return np.frombuffer(binary, kind, offset=view["byteOffset"], count=view["byteLength"] // kind().itemsize)

    for mesh in gltf["meshes"]:
        primitive = mesh["primitives"][0]
        triangles = numbers(primitive["indices"], np.uint32).reshape(-1, 3)
        extension = primitive["extensions"]["EXT_mesh_primitive_edge_visibility"]
        packed = numbers(extension["visibility"], np.uint8)
        marks = (packed[:, None] >> np.arange(0, 8, 2) & 3).reshape(-1)[:triangles.size]
        points = numbers(primitive["attributes"]["POSITION"], np.float32).reshape(-1, 3).astype(float)
        yield points, triangles, marks.reshape(-1, 3)


def welded(points, triangles, marks):
    """The same with one vertex a place, without triangles that have no area."""
    points, number = np.unique(points, axis=0, return_inverse=True)
    triangles = number.reshape(-1)[triangles]
    a, b, c = points[triangles].transpose(1, 0, 2)
    has_area = np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0
    return points, triangles[has_area], marks[has_area]


def sides_of(triangles):
    """Of each side of each triangle: its ends, the lower first; and which edge it is of all."""
    ends = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    return np.unique(ends, axis=0, return_inverse=True)


def facets_of(count, pairs):
    """Per triangle the number of its facet: what pairs of triangles join."""
    joined = coo_matrix((np.ones(len(pairs), bool), (pairs[:, 0], pairs[:, 1])), (count, count))
    return connected_components(joined, directed=False)[1]


def look_beside(middle, along, bend_deg, facet):
    """What lies along each edge beyond the facets (n, 2) on either side: bend and distance of the nearest edge."""
    beside_deg = np.zeros(facet.shape)
    width = np.full(facet.shape, np.inf)
    place = np.argwhere(np.broadcast_to(bend_deg[:, None] >= FLAT_DEG, facet.shape))
    place = place[np.argsort(facet[tuple(place.T)], kind="stable")]
    numbers = facet[tuple(place.T)]
    for of in np.split(place, np.flatnonzero(np.diff(numbers)) + 1):
        if len(of) < 2:
            continue
        e, side = of.T
        off = middle[e][None] - middle[e][:, None]
        off -= along[e][:, None] * (off * along[e][:, None]).sum(axis=2, keepdims=True)
        distance = np.linalg.norm(off, axis=2)
        distance[np.abs(along[e] @ along[e].T) < PARALLEL_COS] = np.inf
        np.fill_diagonal(distance, np.inf)
        nearest = distance.argmin(axis=1)
        width[e, side] = distance[np.arange(len(e)), nearest]
        beside_deg[e, side] = np.where(np.isfinite(width[e, side]), bend_deg[e[nearest]], 0)
    return beside_deg, width


def edges_of_object(points, triangles, marks):
    points, triangles, marks = welded(points, triangles, marks)
    ends, edge_of_side = sides_of(triangles)
    edge_of_side = edge_of_side.reshape(-1)
    order = np.argsort(edge_of_side, kind="stable")
    first = np.searchsorted(edge_of_side[order], np.arange(len(ends)))
    count = np.bincount(edge_of_side, minlength=len(ends))
    marked = np.zeros(len(ends), bool)
    np.logical_or.at(marked, edge_of_side, marks.reshape(-1) >= HARD)

    two = np.flatnonzero(count == 2)
    side = np.stack([order[first[two]], order[first[two] + 1]], axis=1)
    face = side // 3
    opposite = triangles[face, (side + 2) % 3]
    a, b = points[ends[two]].transpose(1, 0, 2)
    along = b - a
    length = np.linalg.norm(along, axis=1)
    along /= length[:, None]
    inward = points[opposite] - a[:, None]
    inward -= along[:, None] * (inward * along[:, None]).sum(axis=2, keepdims=True)
    crossed = np.linalg.norm(np.cross(inward[:, 0], inward[:, 1]), axis=1)
    bend_deg = 180 - np.degrees(np.arctan2(crossed, (inward[:, 0] * inward[:, 1]).sum(axis=1)))

    facet = facets_of(len(triangles), face[bend_deg < FLAT_DEG])
    beside_deg, width = look_beside((a + b) / 2, along, bend_deg, facet[face])
    return length, bend_deg, marked[two], beside_deg, width


def read_edges(path):
    """The MeshEdges of a model."""
    objects = [each for each in read_objects(path)]
    points = np.concatenate([each[0] for each in objects])
    diagonal = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    parts = [np.concatenate(part) for part in zip(*(edges_of_object(*each) for each in objects))]
    length, bend_deg, is_marked, beside_deg, width = parts
    return MeshEdges(length / diagonal, bend_deg, is_marked, beside_deg, width / diagonal)
