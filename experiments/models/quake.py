"""Quake III's maps and players as plain meshes: positions and triangles."""

import struct

# Lumps of a map (IBSP, version 46) by number, and the kinds of its faces.
_VERTICES, _INDICES, _FACES, _TEXTURES = 10, 11, 13, 1
_POLYGON, _PATCH, _MESH = 1, 2, 3
_SKY, _NO_DRAW = 0x4, 0x80
_CUTS = 6  # of a curved patch, along either side


def _rows(data, layout):
    size = struct.calcsize(layout)
    return [struct.unpack_from(layout, data, i * size) for i in range(len(data) // size)]


def _upright(p):
    """Quake's z points up; ours is y."""
    return (p[0], p[2], -p[1])


def _blend(a, b, c, t):
    u, v, w = (1 - t) ** 2, 2 * t * (1 - t), t * t
    return tuple(u * x + v * y + w * z for x, y, z in zip(a, b, c))


def _patch(points, width, height, mesh):
    """Adds quadratic patches of 3 x 3 control points, each cut into squares."""
    positions, triangles = mesh
    for j in range(0, height - 2, 2):
        for i in range(0, width - 2, 2):
            first = len(positions)
            control = [points[(j + k) * width + i:(j + k) * width + i + 3] for k in range(3)]
            for v in range(_CUTS + 1):
                rows = [_blend(*row, v / _CUTS) for row in zip(*control)]
                positions += [_blend(*rows, u / _CUTS) for u in range(_CUTS + 1)]
            for v in range(_CUTS):
                for u in range(_CUTS):
                    a = first + v * (_CUTS + 1) + u
                    c = a + _CUTS + 1
                    triangles += [(a, c, a + 1), (a + 1, c, c + 1)]


def map_mesh(data):
    """(positions, triangles) of a map: what is drawn of it, curved patches cut, the sky left out.

    Raises ValueError if `data` is no such map.
    """
    if data[:8] != struct.pack("<4si", b"IBSP", 46):
        raise ValueError("this is no map of Quake III")
    lumps = _rows(data[8:8 + 17 * 8], "<ii")
    lump = [data[at:at + size] for at, size in lumps]
    vertices = [_upright(v[:3]) for v in _rows(lump[_VERTICES], "<10f4B")]
    indices = [i for (i,) in _rows(lump[_INDICES], "<i")]
    flags = [t[1] for t in _rows(lump[_TEXTURES], "<64sii")]
    positions, triangles = list(vertices), []
    for face in _rows(lump[_FACES], "<12i12f2i"):
        texture, _, kind, first, count, first_index, index_count = face[:7]
        if flags[texture] & (_SKY | _NO_DRAW):
            continue
        if kind in (_POLYGON, _MESH):
            corners = [first + i for i in indices[first_index:first_index + index_count]]
            # Quake's triangles run clockwise seen from their front.
            triangles += [(a, c, b) for a, b, c in zip(*[iter(corners)] * 3)]
        elif kind == _PATCH:
            _patch(vertices[first:first + count], face[-2], face[-1], (positions, triangles))
    return positions, triangles


def _without_scale(frame):
    """A tag's frame with axes of length 1, as the game takes it; some files have longer ones."""
    axes = [frame[i:i + 3] for i in (3, 6, 9)]
    lengths = [sum(x * x for x in axis) ** 0.5 or 1 for axis in axes]
    return [*frame[:3], *(x / n for axis, n in zip(axes, lengths) for x in axis)]


def _part(data):
    """(positions, triangles, tags) of the first frame of an MD3 file."""
    magic, version = struct.unpack_from("<4si", data)
    if magic != b"IDP3" or version != 15:
        raise ValueError("this is no MD3 model")
    frames, tag_count, surface_count = struct.unpack_from("<3i", data, 76)
    tag_at, surface_at = struct.unpack_from("<2i", data, 96)
    del frames
    tags = {}
    for name, *numbers in _rows(data[tag_at:tag_at + 112 * tag_count], "<64s12f"):
        tags[name.split(b"\0")[0].decode("latin-1")] = _without_scale(numbers)
    positions, triangles = [], []
    for _ in range(surface_count):
        header = struct.unpack_from("<4s64s10i", data, surface_at)
        vertex_count, triangle_count, triangle_at = header[5], header[6], header[7]
        vertex_at, size = header[10], header[11]
        first = len(positions)
        at = surface_at + vertex_at
        positions += [(x / 64, y / 64, z / 64)
                      for x, y, z, _ in _rows(data[at:at + 8 * vertex_count], "<4h")]
        at = surface_at + triangle_at
        triangles += [(first + a, first + c, first + b)
                      for a, b, c in _rows(data[at:at + 12 * triangle_count], "<3i")]
        surface_at += size
    return positions, triangles, tags


def _placed(p, frame):
    """A point of a part in the frame of a tag: origin, then the images of the three axes."""
    return tuple(frame[i] + sum(p[k] * frame[3 + 3 * k + i] for k in range(3)) for i in range(3))


def player_mesh(parts):
    """(positions, triangles) of a player in his first frame: `parts` are the bytes of lower, upper
    and head, joined at tag_torso and tag_head.

    Raises ValueError if one of them is no MD3 model or lacks its tag.
    """
    positions, triangles = [], []
    frames = []
    for part, tag in zip(parts, ("tag_torso", "tag_head", None)):
        own, faces, tags = _part(part)
        for frame in reversed(frames):
            own = [_placed(p, frame) for p in own]
        first = len(positions)
        positions += [_upright(p) for p in own]
        triangles += [tuple(first + i for i in face) for face in faces]
        if tag is not None:
            if tag not in tags:
                raise ValueError(f"a part has no {tag}")
            frames.append(tags[tag])
    return positions, triangles
