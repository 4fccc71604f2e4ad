"""Triangles of the GLB files that `inkbench export` writes."""

import json
import struct

import numpy

TYPES = {5126: numpy.float32, 5125: numpy.uint32}
WIDTHS = {"SCALAR": 1, "VEC3": 3}


def read_chunks(path):
    """The JSON of a GLB and its bytes."""
    data = path.read_bytes()
    json_bytes, = struct.unpack_from("<I", data, 12)
    start = 20 + json_bytes
    bin_bytes, = struct.unpack_from("<I", data, start)
    return json.loads(data[20:start]), data[start + 8:start + 8 + bin_bytes]


def read_accessor(gltf, data, index):
    accessor = gltf["accessors"][index]
    place = gltf["bufferViews"][accessor["bufferView"]]
    width = WIDTHS[accessor["type"]]
    values = numpy.frombuffer(data, TYPES[accessor["componentType"]], accessor["count"] * width,
                              place.get("byteOffset", 0))
    return values.reshape(-1, width)


def world_triangles(path):
    """World-space corners of all triangles, three rows a triangle, in double."""
    gltf, data = read_chunks(path)
    parts = [numpy.empty((0, 3))]
    for node in gltf["nodes"]:
        if "mesh" not in node:  # a camera
            continue
        matrix = numpy.array(node["matrix"]).reshape(4, 4).T
        for primitive in gltf["meshes"][node["mesh"]]["primitives"]:
            p = read_accessor(gltf, data, primitive["attributes"]["POSITION"]).astype(float)
            corners = p[read_accessor(gltf, data, primitive["indices"]).ravel()]
            parts.append(corners @ matrix[:3, :3].T + matrix[:3, 3])
    return numpy.concatenate(parts)
