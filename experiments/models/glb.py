"""Corners of a binary glTF that belong in one place."""

import itertools
import json
import math
import struct

_HEADERS = 20  # bytes: of the file and of its JSON


class _Places:
    """Places seen so far, found by any that lies within reach of them."""

    def __init__(self, reach):
        self.reach = reach
        self.cells = {}

    def nearby(self, place):
        """The first place within reach, or the place itself, which is then known."""
        cell = tuple(math.floor(c / self.reach) for c in place)
        for step in itertools.product((-1, 0, 1), repeat=3):
            for known in self.cells.get(tuple(map(sum, zip(cell, step))), ()):
                if max(abs(a - b) for a, b in zip(place, known)) <= self.reach:
                    return known
        self.cells.setdefault(cell, []).append(place)
        return place


def join_corners(data, share):
    """The file with corners of a mesh in one place that lie within that share of its diagonal."""
    (json_size,) = struct.unpack_from("<I", data, 12)
    gltf = json.loads(data[_HEADERS:_HEADERS + json_size])
    blob = bytearray(data)
    for number in sorted({primitive["attributes"]["POSITION"]
                          for mesh in gltf["meshes"] for primitive in mesh["primitives"]}):
        accessor = gltf["accessors"][number]
        view = gltf["bufferViews"][accessor["bufferView"]]
        begin = _HEADERS + json_size + 8 + view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        offsets = [begin + i * view.get("byteStride", 12) for i in range(accessor["count"])]
        positions = [struct.unpack_from("<3f", blob, offset) for offset in offsets]
        diagonal = math.hypot(*(max(axis) - min(axis) for axis in zip(*positions)))
        if diagonal == 0:
            continue
        places = _Places(share * diagonal)
        for offset, position in zip(offsets, positions):
            struct.pack_into("<3f", blob, offset, *places.nearby(position))
    return bytes(blob)
