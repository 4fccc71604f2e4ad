"""Transforms that leave what is seen as it is: a scene and its camera, moved together.

Each takes (mesh, camera, random generator) and returns the same pair, changed. Points are rounded
to float32 as a model file would round them; the camera stays in doubles.
"""

import numpy as np

from mesh import Mesh, Part
from shapes import rotation


def _moved(mesh, camera, place, turn=lambda v: v):
    return mesh.moved(place), camera.moved(place, turn)


def rotate(mesh, camera, random):
    """By a random rotation about the origin."""
    axis = random.normal(size=3)
    matrix = rotation(axis, random.uniform(0.2, np.pi))
    return _moved(mesh, camera, lambda p: p @ matrix.T, lambda v: matrix @ v)


def scale(mesh, camera, random):
    """By a factor of .01 to 100."""
    factor = 10 ** random.uniform(-2, 2)
    return _moved(mesh, camera, lambda p: p * factor)


def scale_by_two(mesh, camera, _):
    """By a power of two: no bit of a significand changes."""
    return _moved(mesh, camera, lambda p: p * 8)


def move(mesh, camera, random):
    """By about the size of the scene."""
    low, high = mesh.box()
    shift = np.linalg.norm(high - low) * random.uniform(-1, 1, 3)
    return _moved(mesh, camera, lambda p: p + shift)


def assemble(mesh, camera, random):
    """Turned, scaled and moved, rounded each time: a part that went through three programs."""
    for pose in (rotate, scale, move):
        mesh, camera = pose(mesh, camera, random)
    return mesh, camera


def permute(mesh, camera, _):
    """x to y to z to x: a rotation that no number is rounded by."""
    return _moved(mesh, camera, lambda p: p[..., [2, 0, 1]], lambda v: v[[2, 0, 1]])


def shuffle(mesh, camera, random):
    """Triangles and vertices in another order within each part, and each triangle begun at another
    corner."""
    parts = []
    for p in mesh.parts:
        order = random.permutation(len(p.points))
        faces = np.argsort(order)[p.faces][random.permutation(len(p.faces))]
        faces = np.array([np.roll(f, random.integers(3)) for f in faces]).reshape(-1, 3)
        parts.append(Part(p.name, p.points[order], faces))
    return Mesh(parts), camera


def flip(mesh, camera, random):
    """The orientation of every other triangle, by chance."""
    parts = []
    for p in mesh.parts:
        is_flipped = random.random(len(p.faces)) < 0.5
        faces = np.where(is_flipped[:, None], p.faces[:, ::-1], p.faces)
        parts.append(Part(p.name, p.points, faces))
    return Mesh(parts), camera


def double(mesh, camera, _):
    """Every triangle twice, the second time with vertices of its own and turned over."""
    return Mesh([Part(p.name, np.concatenate([p.points, p.points]),
                      np.concatenate([p.faces, p.faces[:, ::-1] + len(p.points)]))
                 for p in mesh.parts]), camera


def mirror(mesh, camera, _):
    """In the plane x = 0: the image is mirrored too."""
    return _moved(mesh, camera, lambda p: p * [-1, 1, 1], lambda v: v * [-1, 1, 1])


POSES = {pose.__name__: pose for pose in (rotate, scale, scale_by_two, move, assemble, permute,
                                          shuffle, flip, double, mirror)}
