"""Random scenes on a lattice of small integers: bends of exactly 30, 45, 60 and 90 degrees, faces
in one plane, edges that end on faces, eyes in the planes of faces.

All coordinates are integers, so that doubles decide everything exactly.
"""

import numpy as np

from camera import Camera
from mesh import Mesh, Part
from shapes import box, one_object, part

# Normals of two faces that meet at these angles.
BENDS = {30: [((1, 1, 0), (2, 1, 1)), ((0, 1, 1), (1, 1, 2))],
         45: [((1, 0, 0), (1, 1, 0)), ((0, 1, 0), (0, 1, 1)), ((0, 0, 1), (1, 0, 1))],
         60: [((1, 1, 0), (1, 0, 1)), ((0, 1, 1), (1, 1, 0)), ((1, 0, 1), (0, 1, 1))],
         90: [((1, 0, 0), (0, 1, 0)), ((1, 1, 0), (1, -1, 0)), ((1, 1, 1), (1, -1, 0))]}
CLUSTER = 16  # distance between the scenes that share one image
EYE_HEIGHTS = (-4, -2, 0, 1, 2, 3, 5, 9, 14)
FARTHEST = 12  # an eye in a plane, along each axis
NEAREST = 7  # along at least one: the scenes reach to 6 at most


def _random_box(random):
    low = random.integers(-3, 3, 3)
    return box("", low, low + random.integers(1, 4, 3))


def _bent_sheet(random, bend_deg):
    """Two triangles on one edge."""
    pairs = BENDS[bend_deg]
    normal, other = pairs[random.integers(len(pairs))]
    along = np.cross(normal, other)
    left, right = np.cross(along, normal), np.cross(other, along)
    scale = 1 if np.abs([along, left, right]).max() > 2 else 2
    at = random.integers(-1, 2, 3)
    points = at + scale * np.array([-along, along, left, right])
    return part("", points, [(0, 1, 2), (1, 0, 3)])


def _triangles(random, count):
    corners = random.integers(-3, 4, (count, 3, 3))
    area = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).sum(1)
    corners = corners[area > 0]
    return part("", corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def _cluster(random, bend_deg):
    """One small scene, of one to three objects."""
    parts = [_random_box(random) for _ in range(random.integers(1, 4))]
    parts += [_bent_sheet(random, bend_deg) for _ in range(random.integers(1, 3))]
    if random.random() < 0.5:
        parts.append(_triangles(random, random.integers(1, 6)))
    objects = random.integers(0, 3, len(parts))
    return [[p for p, o in zip(parts, objects) if o == k] for k in np.unique(objects)]


def lattice_scene(seed):
    """Four small scenes before one camera: (mesh, camera, crease angle in degrees)."""
    random = np.random.default_rng(seed)
    bend_deg = int(random.choice(list(BENDS)))
    parts = []
    for place in [(0, 0, 0), (CLUSTER, 0, 0), (0, 0, -CLUSTER), (CLUSTER, 0, -CLUSTER)]:
        for group in _cluster(random, bend_deg):
            whole = one_object(f"part{len(parts)}", group)
            parts.append(Part(whole.name, (whole.points + place).astype(np.float32), whole.faces))
    # Before them and level with planes of faces as often as not.
    eye = np.array([random.integers(-9, 28), random.choice(EYE_HEIGHTS), random.integers(11, 17)])
    target = np.array([CLUSTER / 2 + 0.137, 0.071, -CLUSTER / 2 + 0.113])
    return Mesh(parts), Camera(eye.astype(float), target, np.array([0.03, 1.0, 0.02]), 47.3, 320,
                               240), bend_deg


def _soup(random):
    """Triangles between a few points: edges of no face but one, of three faces and more."""
    points = random.integers(-2, 3, (random.integers(4, 9), 3))
    faces = random.integers(0, len(points), (random.integers(3, 15), 3))
    corners = points[faces]
    area = np.abs(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).sum(1)
    return part("", points, faces[area > 0]) if (area > 0).any() else _random_box(random)


def _volume(a, b, c, d):
    return int(np.dot(np.cross(b - a, c - a), d - a))


def _eye_in_a_plane(random, corners):
    """A lattice point in the plane of a face, or in that of an edge and a corner of another."""
    while True:
        eye = random.integers(-FARTHEST, FARTHEST + 1, 3)
        face, other = corners[random.integers(len(corners), size=2)]
        third = face[2] if random.random() < 0.5 else other[random.integers(3)]
        is_plane = np.cross(face[1] - face[0], third - face[0]).any()
        if is_plane and np.abs(eye).max() >= NEAREST and _volume(*face[:2], third, eye) == 0:
            return eye


def scene_in_a_plane(seed):
    """One small scene before an eye in the plane of a face or of two edges: (mesh, camera, crease
    angle in degrees)."""
    random = np.random.default_rng(seed)
    bend_deg = int(random.choice(list(BENDS)))
    groups = _cluster(random, bend_deg)
    if random.random() < 0.7:
        groups = groups[:1] + [[_soup(random)] for _ in range(random.integers(1, 3))]
    parts = [one_object(f"part{i}", group) for i, group in enumerate(groups)]
    mesh = Mesh(parts)
    eye = _eye_in_a_plane(random, mesh.corners().astype(int))
    target = random.integers(-1, 2, 3)
    up = np.eye(3)[np.abs(eye - target).argmin()]
    return mesh, Camera(eye.astype(float), target.astype(float), up, 50.0, 320, 240), bend_deg
