"""Readers of OBJ, PLY and STL files: places and triangles, nothing else."""

import re

import numpy as np

from mesh import Mesh, Part, rounded


def _fans(polygons):
    """Triangles of polygons, each a fan from its first corner."""
    return [(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)]


def _used(name, points, faces):
    """A part with those points alone that its triangles use."""
    used, faces = np.unique(np.asarray(faces), return_inverse=True)
    return Part(name, points[used], faces.reshape(-1, 3))


def read_obj(path):
    """A part for each `o` or `g` that has faces. Places are the file's: `# origin` is added to them."""
    points, groups, now, origin = [], {}, "all", (0, 0, 0)
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[:2] == ["#", "origin"]:
                origin = [float(w.rstrip(":")) for w in words[2:5]]
            elif words[0] == "v":
                points.append([float(w) + o for w, o in zip(words[1:4], origin)])
            elif words[0] in "og":
                now = " ".join(words[1:]) or "all"
            elif words[0] == "f":
                corners = [int(w.split("/")[0]) for w in words[1:]]
                corners = [c - 1 if c > 0 else len(points) + c for c in corners]
                groups.setdefault(now, []).append(corners)
    points = rounded(points)
    return Mesh([_used(f"part{i}", points, _fans(polygons))
                 for i, polygons in enumerate(groups.values())])


PLY_TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
             "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4",
             "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}


def _ply_elements(header):
    """(name, count, [(property, type)]) of each; a list's type is (count type, entry type)."""
    elements = []
    for line in header.splitlines():
        words = line.split()
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1][2].append((words[4], (PLY_TYPES[words[2]], PLY_TYPES[words[3]])))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[2], PLY_TYPES[words[1]]))
    return elements


def read_ply(path):
    """One part; text or binary, vertices x, y, z and faces as lists of indices."""
    with open(path, "rb") as file:
        data = file.read()
    end = re.search(rb"end_header\r?\n", data)
    header = data[:end.start()].decode("ascii")
    is_text = "format ascii" in header
    order = ">" if "big_endian" in header else "<"
    words = iter(data[end.end():].split()) if is_text else None
    at = end.end()

    def take(kind, count=1):
        nonlocal at
        if is_text:
            return np.array([float(next(words)) for _ in range(count)]).astype(kind)
        values = np.frombuffer(data, order + kind, count, at)
        at += values.nbytes
        return values

    points, polygons = None, []
    for name, count, properties in _ply_elements(header):
        if name == "vertex" and not is_text:
            layout = np.dtype([(p, order + kind) for p, kind in properties])
            rows = np.frombuffer(data, layout, count, at)
            at += rows.nbytes
            points = np.stack([rows[axis] for axis in "xyz"], -1)
            continue
        rows = []
        for _ in range(count):
            row = {}
            for prop, kind in properties:
                if isinstance(kind, tuple):
                    row[prop] = take(kind[1], int(take(kind[0])[0]))
                else:
                    row[prop] = take(kind)[0]
            rows.append(row)
        if name == "vertex":
            points = np.array([[row[axis] for axis in "xyz"] for row in rows])
        elif name == "face":
            key = next(p for p, kind in properties if isinstance(kind, tuple))
            polygons = [row[key].astype(int).tolist() for row in rows]
    return Mesh([_used("all", rounded(points), _fans(polygons))])


def read_stl(path):
    """One part; text or binary."""
    with open(path, "rb") as file:
        data = file.read()
    count = int.from_bytes(data[80:84], "little")
    if len(data) == 84 + 50 * count:
        layout = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
        corners = np.frombuffer(data, layout, count, 84)["corners"]
    else:
        corners = np.array([[float(w) for w in m.split()] for m in
                            re.findall(r"vertex\s+(\S+\s+\S+\s+\S+)", data.decode("latin-1"))])
    points, faces = np.unique(rounded(corners.reshape(-1, 3)), axis=0, return_inverse=True)
    return Mesh([Part("all", points, faces.reshape(-1, 3))])


READERS = {".obj": read_obj, ".ply": read_ply, ".stl": read_stl}


def read_model(path):
    """The mesh in a file, by its name's ending."""
    return READERS[path.suffix](path)
