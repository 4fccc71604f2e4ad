"""What the fuzzer of glTF begins with (make_corpus): small files of every kind of number and packing."""

import json
import struct

IDENTITY = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)


def pack(layout, *values):
    return struct.pack("<" + layout, *values)


def gltf(parts, **more):
    """JSON, a zero byte, and a buffer that holds `parts`, one bufferView each."""
    binary, views = b"", []
    for part in parts:
        binary += bytes(-len(binary) % 4)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(part)})
        binary += part
    views += more.pop("bufferViews", [])
    whole = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "bufferViews": views,
             "buffers": [{"byteLength": len(binary)}, {"byteLength": 999}], **more}
    return json.dumps(whole, separators=(",", ":")).encode() + b"\0" + binary


def accessor(view, component, count, kind, **more):
    return {"bufferView": view, "componentType": component, "count": count, "type": kind, **more}


SQUARE = pack("12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0)
PAIR = pack("6H", 0, 1, 2, 2, 1, 3)


def gltf_moving():
    """A strip with a morph target and bones that moves by cubic keys; sparse and normalised numbers."""
    joints, weights = bytes([0, 1, 0, 0] * 4), bytes([200, 55, 0, 0] * 4)
    times, shares = pack("3f", 0, 1, 2), bytes([0, 100, 200])
    turns = b"".join(pack("4h", *q) for q in ((0, 0, 0, 32767), (0, 0, 23170, 23170), (0, 0, 32767, 0)))
    places = pack("27f", *range(27))
    parts = [SQUARE, joints, weights, times, shares, turns, places, bytes([1, 3]), pack("6f", 0, 0, 1, 0, 0, 2),
             pack("16f", *IDENTITY) * 2]
    unit = {"normalized": True}
    sparse = {"count": 2, "indices": {"bufferView": 7, "componentType": 5121}, "values": {"bufferView": 8}}
    accessors = [accessor(0, 5126, 4, "VEC3"), accessor(1, 5121, 4, "VEC4"), accessor(2, 5121, 4, "VEC4", **unit),
                 accessor(3, 5126, 3, "SCALAR"), accessor(4, 5121, 3, "SCALAR", **unit),
                 accessor(5, 5122, 3, "VEC4", **unit), accessor(6, 5126, 9, "VEC3"),
                 {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": sparse}, accessor(9, 5126, 2, "MAT4")]
    mesh = {"weights": [0.5], "primitives": [{
        "mode": 5, "attributes": {"POSITION": 0, "NORMAL": 0, "JOINTS_0": 1, "WEIGHTS_0": 2},
        "targets": [{"POSITION": 7}]}]}
    nodes = [{"mesh": 0, "skin": 0, "children": [1]}, {"translation": [0, 1, 0], "children": [2, 3]},
             {"rotation": [0, 0, 0, 1], "camera": 0}, {"mesh": 0, "weights": [1], "scale": [2, 1, 1]}]
    samplers = [{"input": 3, "output": 4, "interpolation": "STEP"}, {"input": 3, "output": 5},
                {"input": 3, "output": 6, "interpolation": "CUBICSPLINE"}]
    channels = [{"sampler": i, "target": {"node": node, "path": path}}
                for i, node, path in ((0, 0, "weights"), (1, 1, "rotation"), (2, 2, "translation"))]
    return gltf(parts, accessors=accessors, meshes=[mesh], nodes=nodes,
                skins=[{"joints": [1, 2], "inverseBindMatrices": 8}],
                animations=[{"name": "wave", "samplers": samplers, "channels": channels}],
                cameras=[{"type": "perspective", "perspective": {"yfov": 0.7}}])


def gltf_placed():
    """Quantised copies by instancing, a hidden node, a matrix, materials, a data URI."""
    name = "EXT_mesh_gpu_instancing"
    parts = [bytes([0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0, 100, 100, 0, 0]), PAIR, pack("6f", 0, 0, 0, 3, 0, 0)]
    nodes = [{"children": [1, 2]}, {"mesh": 0, "extensions": {name: {"attributes": {"TRANSLATION": 2}}}},
             {"mesh": 0, "matrix": list(IDENTITY), "extensions": {"KHR_node_visibility": {"visible": False}}}]
    primitives = [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}, {"attributes": {"POSITION": 0}, "mode": 6}]
    whole = gltf(parts, nodes=nodes, meshes=[{"primitives": primitives}], materials=[{"alphaMode": "BLEND"}],
                 extensionsRequired=[name, "KHR_mesh_quantization"], extensionsUsed=["KHR_materials_ior"],
                 accessors=[accessor(0, 5120, 4, "VEC3"), accessor(1, 5123, 6, "SCALAR"), accessor(2, 5126, 2, "VEC3")])
    return whole.replace(b'"byteLength":4}', b'"byteStride":4,"byteLength":4}')


def gltf_meshopt():
    packed = [bytes.fromhex("a00000013f000000ffffff013f0000007e7d7e0000010c000000ff010c0000007e" + "00" * 36),
              bytes.fromhex("e0f010007687566778a9866589689801690000")]
    how = [{"mode": "ATTRIBUTES", "count": 4, "byteStride": 12}, {"mode": "TRIANGLES", "count": 6, "byteStride": 2}]
    views = [{"buffer": 1, "byteLength": size, "extensions": {"EXT_meshopt_compression": {
        "buffer": 0, "byteOffset": at, "byteLength": len(stream), **what}}}
             for size, at, stream, what in zip((48, 12), (0, 72), packed, how)]
    return gltf(packed, bufferViews=views, nodes=[{"mesh": 0}],
                meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                accessors=[accessor(2, 5126, 4, "VEC3"), accessor(3, 5123, 6, "SCALAR")])


def gltf_draco(stream):
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, "extensions": {
        "KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}}
    return gltf([bytes.fromhex(stream)], nodes=[{"mesh": 0}], meshes=[{"primitives": [primitive]}],
                accessors=[{"componentType": 5126, "count": 4, "type": "VEC3"},
                           {"componentType": 5123, "count": 6, "type": "SCALAR"}])


# The square as Draco packs it, by edgebreaker and in sequence.
DRACO = ("445241434f02020101000000040200020000011fff011101ff000101000903000000000000000000803f000000000000803f"
         "00000000000000000000803f0000803f00000000000000000000000000000000",
         "445241434f02020100000002040100010202010301010009030000000000000000000000000000000000803f000000000000"
         "0000000000000000803f000000000000803f0000803f00000000")


def gltf_files():
    yield "gltf/moving", gltf_moving()
    yield "gltf/placed", gltf_placed()
    yield "gltf/meshopt", gltf_meshopt()
    for name, stream in zip(("edgebreaker", "sequence"), DRACO):
        yield f"gltf/draco_{name}", gltf_draco(stream)
