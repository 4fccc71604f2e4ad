"""Writes .glb files of any component type, and says what numbers a reader must find in them."""

import json
import struct
from dataclasses import dataclass, field

import numpy as np

CODES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
LARGEST = {"i1": 127, "u1": 255, "i2": 32767, "u2": 65535}
TYPES = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def stored(values, kind, normalised=False):
    """Values as a file of component type `kind` has them: the integers or floats themselves."""
    values = np.asarray(values, np.float64)
    if kind == "f4":
        return values.astype(np.float32)
    if normalised:
        values = values * LARGEST[kind]
    return np.rint(values).astype(kind)


def meant(raw, normalised=False):
    """The numbers that stored ones stand for (glTF 2.0, section 3.6.2.2)."""
    numbers = raw.astype(np.float64)
    if not normalised or raw.dtype == np.float32:
        return numbers
    return np.maximum(numbers / LARGEST[raw.dtype.str[1:]], -1)


@dataclass
class Glb:
    """A file under construction: the JSON's lists, and one buffer."""

    lists: dict = field(default_factory=dict)
    data: bytearray = field(default_factory=bytearray)

    def put(self, kind, entry):
        """Appends an entry to a list of the JSON; its number."""
        self.lists.setdefault(kind, []).append(entry)
        return len(self.lists[kind]) - 1

    def _view(self, raw, stride=None):
        """The number of a bufferView that holds rows, `stride` bytes apart if that is given."""
        rows = [row.tobytes() for row in raw]
        width = len(rows[0])
        stride = stride or width
        while len(self.data) % 4:
            self.data.append(0)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": stride * len(rows)}
        if stride != width:
            view["byteStride"] = stride
        self.data += b"".join(row.ljust(stride, b"\xee") for row in rows)
        return self.put("bufferViews", view)

    def accessor(self, raw, normalised=False, sparse="", aligned=False):
        """An accessor of stored rows (n, width); its number.

        `sparse`: "base": every other row stands in a substitute, and wrong in the base; "zeros":
        all rows that are not zero are substitutes, and there is no base. `aligned`: rows begin at
        multiples of four bytes, as attributes must.
        """
        raw = np.ascontiguousarray(raw.reshape(len(raw), -1))
        width = raw.shape[1] * raw.dtype.itemsize
        stride = -(-width // 4) * 4 if aligned else None
        entry = {"componentType": CODES[raw.dtype.str[1:]], "count": len(raw),
                 "type": TYPES[raw.shape[1]]}
        if normalised and raw.dtype != np.float32:
            entry["normalized"] = True
        if not sparse:
            entry["bufferView"] = self._view(raw, stride)
            return self.put("accessors", entry)
        if sparse == "base":
            places = np.arange(0, len(raw), 2)
            base = raw.copy()
            base[places] = base[0] + 1
            entry["bufferView"] = self._view(base, stride)
        else:
            places = np.flatnonzero(raw.any(axis=1))
        kind = "u1" if len(raw) < 256 else "u4"
        entry["sparse"] = {
            "count": len(places),
            "indices": {"bufferView": self._view(places.astype(kind).reshape(-1, 1)),
                        "componentType": CODES[kind]},
            "values": {"bufferView": self._view(raw[places])}}
        return self.put("accessors", entry)

    def write(self, path, **more):
        """Writes the file; `more` are further members of the JSON."""
        self.lists["buffers"] = [{"byteLength": len(self.data)}]
        document = {"asset": {"version": "2.0"}, **self.lists, **more}
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self.data) + bytes(-len(self.data) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
        path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


# ---- What the specification makes of numbers ------------------------------------------------


def triangles(corners, mode):
    """Rows of three corners, of a list in order (section 3.7.2.1)."""
    v = list(corners)
    if mode == 4:
        return np.array(v[:len(v) // 3 * 3]).reshape(-1, 3)
    if mode == 5:
        return np.array([(v[i], v[i + (1 + i % 2)], v[i + (2 - i % 2)]) for i in range(len(v) - 2)])
    return np.array([(v[i + 1], v[i + 2], v[0]) for i in range(len(v) - 2)])


def rotation_matrix(q):
    """Of a unit quaternion x, y, z, w."""
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def place_matrix(translation=(0, 0, 0), rotation=(0, 0, 0, 1), scale=(1, 1, 1)):
    """T * R * S (section 3.5.3)."""
    m = np.eye(4)
    m[:3, :3] = rotation_matrix(np.asarray(rotation, float)) * np.asarray(scale, float)
    m[:3, 3] = translation
    return m


def moved(points, matrix):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def unit(q):
    return q / np.linalg.norm(q)


def animated(times, values, interpolation, path, t):
    """A sampler's value at time t (appendix C). `values`: (keys, width), or (keys, 3, width) of
    cubic ones: in-tangent, value, out-tangent."""
    is_cubic = interpolation == "CUBICSPLINE"
    k = int(np.searchsorted(times, t, side="right")) - 1
    key = (lambda i: values[i, 1]) if is_cubic else (lambda i: values[i])
    finish = unit if path == "rotation" else (lambda v: v)
    if k < 0:
        return finish(key(0))
    if k >= len(times) - 1 or interpolation == "STEP":
        return finish(key(min(k, len(times) - 1)))
    td = times[k + 1] - times[k]
    s = (t - times[k]) / td
    if is_cubic:
        return finish((2 * s**3 - 3 * s**2 + 1) * values[k, 1]
                      + td * (s**3 - 2 * s**2 + s) * values[k, 2]
                      + (-2 * s**3 + 3 * s**2) * values[k + 1, 1]
                      + td * (s**3 - s**2) * values[k + 1, 0])
    a, b = key(k), key(k + 1)
    if path != "rotation":
        return (1 - s) * a + s * b
    a, b = unit(a), unit(b)
    dot = a @ b
    angle = np.arccos(min(abs(dot), 1))
    if angle < 1e-9:
        return a
    return (np.sin(angle * (1 - s)) * a + np.sign(dot) * np.sin(angle * s) * b) / np.sin(angle)
