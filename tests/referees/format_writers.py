"""Writers of PLY, STL, OFF, OBJ and FBX over all that these formats allow, and what must come out of each file.

No writer shares anything with the program. Every number is one that a float holds, so the soup that comes out
must be the soup that was meant, bit for bit.
"""

import itertools
import struct
import zlib
from dataclasses import dataclass, field

# A box, a pit with a dent in its floor plan, and a bent strip, one beside the other.
BOX = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 4)]
BOX_FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
PLAN = [(10, 0), (13, 0), (13, 3), (12, 1), (11, 2), (10, 3)]
PIT = [(x, y, z) for z in (0, 5) for x, y in PLAN]
PIT_FACES = [tuple(range(6)), tuple(range(11, 5, -1))] + [
    (i, i + 6, (i + 1) % 6 + 6, (i + 1) % 6) for i in range(6)]
SHEET = [(20 + i // 2, i % 2, (0, 1, 3, 2)[i // 2]) for i in range(8)]


@dataclass
class Case:
    """A file, and what is demanded of it."""

    name: str
    data: bytes
    points: list = field(default_factory=lambda: BOX + PIT)
    polygons: list = field(default_factory=lambda: solids())
    objects: int = 1
    refusal: str = ""  # words of the message, if it must not be read


def solids(first=0):
    """Polygons of the box and the pit."""
    return [tuple(c + first for c in f) for f in BOX_FACES] + [
        tuple(c + first + len(BOX) for c in f) for f in PIT_FACES]


def strip_triangles(strip):
    """As OpenGL draws a strip: every second triangle turned; -1 begins anew."""
    triangles, run = [], []
    for corner in strip:
        if corner == -1:
            run = []
            continue
        run.append(corner)
        if len(run) >= 3:
            a, b, c = run[-3:]
            triangles.append((a, b, c) if len(run) % 2 else (b, a, c))
    return triangles


def number(value):
    return repr(value) if isinstance(value, float) else str(value)


def line_ends(text):
    for name, end in (("lf", "\n"), ("crlf", "\r\n"), ("cr", "\r")):
        yield name, text.replace("\n", end).encode()


# ---- PLY ----------------------------------------------------------------------------------------

PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f",
             "double": "d"}
NEW_NAMES = dict(zip(PLY_TYPES, ("int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64")))
WHOLE = [t for t in PLY_TYPES if t not in ("float", "double")]
FORMATS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass
class Ply:
    """How a PLY file is written; each field is something that the format leaves open."""

    format: str = "ascii"
    position: str = "float"
    count: str = "uchar"
    index: str = "int"
    list_name: str = "vertex_indices"
    new_names: bool = False
    end: str = "\n"
    remarks: bool = False
    faces_first: bool = False
    extras: bool = False
    normals: bool = False
    strip: tuple = ()
    points: tuple = tuple(BOX + PIT)
    mark: bool = False
    after: bytes = b""

    def type_name(self, name):
        return NEW_NAMES[name] if self.new_names else name

    def elements(self):
        """(name, properties, rows): a property is (name, type) or (name, count type, type)."""
        vertex = [(axis, self.position) for axis in "xyz"]
        rows = [list(p) for p in self.points]
        if self.normals:
            vertex += [("n" + axis, "float") for axis in "xyz"]
            rows = [row + [0.0, 0.0, 1.0] for row in rows]
        if self.extras:
            vertex = [("red", "uchar")] + vertex[::-1] + [("flags", "ushort", "double")]
            rows = [[200] + row[::-1] + [[0.5] * (i % 3)] for i, row in enumerate(rows)]
        faces = ("face", [(self.list_name, self.count, self.index)], [[list(f)] for f in solids()])
        if self.extras:
            faces = ("face", [("texcoord", "uchar", "float")] + faces[1] + [("area", "double")],
                     [[[0.25] * 6] + row + [1.5] for row in faces[2]])
        if self.strip:
            faces = ("tristrips", [(self.list_name, self.count, self.index)], [[list(self.strip)]])
        elements = [("vertex", vertex, rows), faces]
        if self.extras:
            elements.insert(1, ("camera", [("view", "float"), ("ids", "int", "char")], [[1.5, [1, 2, 3]]]))
        return elements[::-1] if self.faces_first else elements

    def value(self, kind, value):
        if self.format == "ascii":
            return (number(float(value) if kind in ("float", "double") else value) + " ").encode()
        return struct.pack(FORMATS[self.format] + PLY_TYPES[kind], value)

    def row(self, properties, row):
        data = b""
        for prop, value in zip(properties, row):
            if len(prop) == 2:
                data += self.value(prop[1], value)
            else:
                data += self.value(prop[1], len(value)) + b"".join(self.value(prop[2], v) for v in value)
        return data.strip() + self.end.encode() if self.format == "ascii" else data

    def data(self):
        head, body = ["ply", f"format {self.format} 1.0"], b""
        for name, properties, rows in self.elements():
            if self.remarks:
                head += ["comment element vertex 99", "obj_info by a referee"]
            head.append(f"element {name} {len(rows)}")
            for prop in properties:
                kind = " ".join((["list"] if len(prop) == 3 else []) + [self.type_name(t) for t in prop[1:]])
                head.append(f"property {kind} {prop[0]}")
            body += b"".join(self.row(properties, row) for row in rows)
        mark = b"\xef\xbb\xbf" if self.mark else b""
        return mark + (self.end.join(head + ["end_header"]) + self.end).encode() + body + self.after

    def case(self, name):
        if self.strip:
            return Case(f"{name}.ply", self.data(), list(self.points), strip_triangles(self.strip))
        return Case(f"{name}.ply", self.data(), list(self.points))


def ply_cases():
    for form in FORMATS:
        short = form.replace("binary_", "").replace("_endian", "")
        for position in PLY_TYPES:
            yield Ply(form, position=position, new_names=position in WHOLE[::2]).case(f"{short}_at_{position}")
        for count in WHOLE:
            yield Ply(form, count=count, index=WHOLE[(WHOLE.index(count) + 3) % 6],
                      list_name="vertex_index").case(f"{short}_list_{count}")
        for end_name, end in (("crlf", "\r\n"), ("cr", "\r")):
            yield Ply(form, end=end, remarks=True).case(f"{short}_{end_name}")
        yield Ply(form, faces_first=True, extras=True).case(f"{short}_any_order")
        yield Ply(form, normals=True, extras=True, new_names=True).case(f"{short}_normals")
        for index in ("char", "short", "int"):
            yield Ply(form, strip=(0, 1, 2, 3, 4, 5, -1, 7, 6, 5, 4), index=index, points=tuple(SHEET),
                      count="int").case(f"{short}_strip_{index}")
        yield Ply(form, after=b"\n1 2 3 rest").case(f"{short}_after")
        if form != "ascii":
            # The body begins with the byte of a line feed.
            points = tuple((x + 10, y, z) for x, y, z in BOX) + tuple((x + 20, y, z) for x, y, z in PIT)
            for end_name, end in (("lf", "\n"), ("crlf", "\r\n"), ("cr", "\r")):
                yield Ply(form, position="uchar", points=points, end=end).case(f"{short}_first_0a_{end_name}")
    yield Ply(mark=True).case("ascii_mark")
    whole = Ply("binary_little_endian").data()
    yield Case("cut.ply", whole[:-5], refusal="cut short")
    yield Case("index.ply", Ply().data().replace(b"4 1 5 7 3", b"4 1 5 77 3"), refusal="a face has the vertex 77")
    yield Case("type.ply", Ply(position="double").data().replace(b"double z", b"half z"), refusal='the type is "half"')


# ---- STL ----------------------------------------------------------------------------------------

def facets(points, polygons):
    """Triangles of fans from each corner whose fan has no dent: the pit's plan is cut by hand."""
    plan = [(0, 1, 3), (1, 2, 3), (0, 3, 4), (0, 4, 5)]
    for polygon in polygons:
        cuts = plan if len(polygon) == 6 and polygon[0] < polygon[1] else (
            [tuple(5 - c for c in cut)[::-1] for cut in plan] if len(polygon) == 6 else
            [(0, i, i + 1) for i in range(1, len(polygon) - 1)])
        for cut in cuts:
            yield tuple(polygon[c] for c in cut)


def stl_text(name="a solid", normal="0 0 0", triangles=None):
    lines = [f"solid {name}"]
    for triangle in triangles or facets(BOX + PIT, solids()):
        lines += [f"  facet normal {normal}", "    outer loop"]
        lines += ["      vertex " + " ".join(str(float(v)) for v in (BOX + PIT)[c]) for c in triangle]
        lines += ["    endloop", "  endfacet"]
    return "\n".join(lines + [f"endsolid {name}", ""])


def stl_binary(head, after=b""):
    triangles = list(facets(BOX + PIT, solids()))
    data = head.ljust(80, b"\0") + struct.pack("<I", len(triangles))
    for triangle in triangles:
        corners = [float(v) for c in triangle for v in (BOX + PIT)[c]]
        data += struct.pack("<12fH", 0, 0, 0, *corners, 5)
    return data + after


def stl_cases():
    triangles = list(facets(BOX + PIT, solids()))

    def case(name, data):
        return Case(f"{name}.stl", data, BOX + PIT, triangles)

    for name, data in line_ends(stl_text()):
        yield case(f"text_{name}", data)
    text = stl_text()
    yield case("text_upper", text.upper().encode())
    yield case("text_nameless", stl_text("").encode())
    yield case("text_blank_lines_first", b"\n  \n" + text.encode())
    yield case("text_mark", b"\xef\xbb\xbf" + text.encode())
    yield case("text_mark_upper", b"\xef\xbb\xbf\r\n" + text.upper().encode())
    yield case("text_tabs", text.replace("  ", "\t").encode())
    yield case("text_one_line_a_facet", text.replace("\n    ", " ").replace("\n  endfacet", " endfacet").encode())
    yield case("text_dos_end", text.encode() + b"\x1a")
    yield case("text_zeros_after", text.encode() + bytes(6))
    yield case("text_no_normals", stl_text(normal="-nan(ind) 1.#QNAN nan").encode())
    yield case("text_empty_first", b"solid none\nendsolid none\n" + text.encode())
    yield case("text_empty_last", text.encode() + b"solid\nendsolid\n")
    half = len(triangles) // 2
    yield case("text_two_solids", (stl_text("a", triangles=triangles[:half])
                                   + stl_text("b", triangles=triangles[half:])).encode())
    for name, head in (("", b"made by a referee"), ("_solid", b"solid but binary"), ("_zeros", b""),
                       ("_facet", b"solid x facet normal"), ("_spaces", b" " * 80)):
        yield case(f"binary{name}", stl_binary(head))
        yield case(f"binary{name}_after", stl_binary(head, b"10 bytes.."))
    yield Case("cut_text.stl", text[:text.rindex("  facet")].encode(), refusal="cut short")
    yield Case("cut_binary.stl", stl_binary(b"")[:-20], refusal="cut short")
    yield Case("wide.stl", text.encode("utf-16"), refusal="UTF-16")


# ---- OFF ----------------------------------------------------------------------------------------

def off_text(word, vertex_rest, face_rest="", comments=False, one_line=False):
    points, polygons = BOX + PIT, solids()
    note = " # note" if comments else ""
    between = "\n# a line between\n\n" if comments else ""
    lines = ["# first"] if comments else []
    counts = f"{len(points)} {len(polygons)} 0"
    lines += [f"{word} {counts}{note}"] if one_line else [word + note, counts + note] if word else [counts]
    lines += [" ".join(map(str, p)) + vertex_rest + note + between for p in points]
    lines += [" ".join(map(str, (len(f),) + f)) + face_rest + note + between for f in polygons]
    return "\n".join(lines) + "\n"


def off_cases():
    kinds = {"OFF": "", "COFF": " 255 0 0 255", "NOFF": " 0 0 1", "CNOFF": " 0 0 1 .5 .5 .5 1", "NCOFF": " 0 0 1 9 9 9",
             "STOFF": " .5 .25", "STCNOFF": " 0 0 1 1 1 1 1 .5 .25", "": ""}
    for (word, rest), comments in itertools.product(kinds.items(), (False, True)):
        name = f"{word or 'wordless'}{'_comments' if comments else ''}"
        yield Case(f"{name}.off", off_text(word, rest, " 255 0 0" if comments else "", comments).encode())
    for name, data in line_ends(off_text("OFF", "", comments=True, one_line=True)):
        yield Case(f"one_line_{name}.off", data)
    yield Case("mark.off", b"\xef\xbb\xbf" + off_text("OFF", "").encode())
    yield Case("four.off", off_text("4OFF", " 1").encode(), refusal='of the kind "4OFF"')
    yield Case("binary.off", b"OFF BINARY\n" + bytes(40), refusal="OFF BINARY")
    yield Case("cut.off", "\n".join(off_text("OFF", "").split("\n")[:-2]).encode(), refusal="cut short")
    yield Case("wide.off", off_text("OFF", "").encode("utf-16-le"), refusal="UTF-16")


# ---- OBJ ----------------------------------------------------------------------------------------

OBJ_CORNERS = {"v": "{v}", "v_vt": "{v}/1", "v_vn": "{v}//{n}", "v_vt_vn": "{v}/1/{n}"}


def obj_text(corner="{v}", negative=False, vertex_rest="", parts=None, head="", exponents=False):
    """`parts`: what stands before each polygon, by its number."""
    points, polygons = BOX + PIT, solids()
    show = (lambda v: f"+{v * 10.0}E-01") if exponents else str
    lines = [head + "# a referee"] + ["v " + " ".join(map(show, p)) + vertex_rest for p in points]
    lines += ["vt 0 0", "vn 0 0 1", "vn 0 1 0"]
    for i, polygon in enumerate(polygons):
        lines += (parts or {}).get(i, [])
        first, normals = (-len(points), -2) if negative else (1, 1)
        shown = [corner.format(v=c + first, n=normals + c % 2) for c in polygon]
        lines.append("f " + " ".join(shown))
    return "\n".join(lines) + "\n"


def obj_cases():
    for (name, corner), negative in itertools.product(OBJ_CORNERS.items(), (False, True)):
        if negative:
            corner = corner.replace("/1", "/-1")
        yield Case(f"{name}{'_negative' if negative else ''}.obj", obj_text(corner, negative).encode())
    for name, data in line_ends(obj_text()):
        yield Case(f"{name}.obj", data)
    for name, rest in (("weights", " 1.0"), ("colours", " .5 .25 1"), ("both", " 1 .5 .25 1")):
        yield Case(f"{name}.obj", obj_text(vertex_rest=rest).encode())
    text = obj_text("{v}/1/{n}")
    body = text[text.index("\n") + 1:]
    yield Case("continued.obj", body.replace(" ", " \\\n").encode())
    yield Case("continued_crlf.obj", body.replace(" ", " \\\r\n\t").encode())
    yield Case("comments.obj", text.replace("\n", " # note\n#\n\n").encode())
    yield Case("exponents.obj", obj_text(exponents=True).encode())
    yield Case("no_last_line_end.obj", text.encode()[:-1])
    yield Case("mark.obj", b"\xef\xbb\xbf" + body.encode())
    faces = "\n".join(line for line in text.split("\n") if line.startswith("f "))
    rest = "\n".join(line for line in text.split("\n") if not line.startswith("f "))
    yield Case("faces_first.obj", (faces + "\n" + rest).encode())
    groups = {i: [f"g part{i}", f"usemtl m{i % 3}", f"s {i}"] for i in range(14)}
    yield Case("groups_and_materials.obj", obj_text(parts=groups, head="mtllib none.mtl\n").encode())
    two = {0: ["o box", "usemtl a"], 3: ["usemtl b"], 6: ["o pit"]}
    yield Case("objects.obj", obj_text(parts=two).encode(), objects=2)
    again = {0: ["o box"], 3: ["o pit"], 6: ["o box"], 8: ["o none", "o 平面"]}
    yield Case("objects_again.obj", obj_text(parts=again).encode(), objects=3)
    others = "l 1 2 3\np 4\nf 1 2\ncstype bezier\ndeg 2\ncurv 0 1 1 2 3\nparm u 0 1\nend\nvp 0 1\n"
    yield Case("lines_points_curves.obj", (text + others).encode())
    yield Case("surface.obj", (text + "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nend\n").encode(), refusal='"surf"')
    yield Case("index.obj", (text + "f 1 2 99\n").encode(), refusal="a corner has the vertex 99")
    yield Case("zero.obj", (text + "f 1 2 0\n").encode(), refusal="a corner has the number 0")
    yield Case("wide.obj", text.encode("utf-16-be"), refusal="UTF-16")


# ---- FBX ----------------------------------------------------------------------------------------


def fbx_elements(properties=(), shift=(0, 0, 0), shapes=0):
    """(name, values, children) of each element of a file with one model; what its points lack, `shapes` at 50 % give."""
    numbers = [float(c + d) for p in BOX + PIT for c, d in zip(p, shift)]
    corners = [c if i + 1 < len(f) else -1 - c for f in solids() for i, c in enumerate(f)]
    objects = [("Model", [1, "Model::m", "Mesh"], [("Properties70", [], [
        ("P", [name, "", "", "A", *values], []) for name, *values in properties])]),
        ("Geometry", [2, "Geometry::g", "Mesh"], [("Vertices", [numbers], []), ("PolygonVertexIndex", [corners], [])])]
    links = [(1, 0), (2, 1)]
    if shapes:
        whole = [-2.0 * d for _ in BOX + PIT for d in shift]
        objects += [("Deformer", [3, "Deformer::b", "BlendShape"], []),
                    ("Deformer", [4, "SubDeformer::c", "BlendShapeChannel"], [("DeformPercent", [50.0], [])]),
                    ("Geometry", [5, "Geometry::s", "Shape"], [
                        ("Indexes", [list(range(len(BOX + PIT)))], []), ("Vertices", [whole], [])])]
        links += [(3, 2), (4, 3), (5, 4)]
    return [("FBXHeaderExtension", [], [("FBXVersion", [7400], [])]), ("Objects", [], objects),
            ("Connections", [], [("C", ["OO", *link], []) for link in links])]


def fbx_text(element):
    name, values, children = element
    words = [f'"{v}"' if isinstance(v, str) else f"*{len(v)} {{\n a: {','.join(map(str, v))}\n}}" if isinstance(v, list)
             else str(v) for v in values]
    inner = " {\n" + "".join(map(fbx_text, children)) + "}" if children else ""
    return f"{name}: {', '.join(words)}{inner}\n"


def fbx_value(value, packed):
    if isinstance(value, str):
        kind, _, rest = value.partition("::")
        text = f"{rest}\0\1{kind}".encode() if rest else value.encode()
        return b"S" + struct.pack("<I", len(text)) + text
    if isinstance(value, list):
        kind = "d" if isinstance(value[0], float) else "i"
        data = struct.pack(f"<{len(value)}{kind}", *value)
        data = zlib.compress(data) if packed else data
        return kind.encode() + struct.pack("<3I", len(value), packed, len(data)) + data
    return struct.pack("<cd", b"D", value) if isinstance(value, float) else struct.pack("<cq", b"L", value)


def fbx_bytes(element, begin, place, packed):
    name, values, children = element
    data = b"".join(fbx_value(value, packed) for value in values)
    rest = struct.pack("B", len(name)) + name.encode() + data
    head = 3 * struct.calcsize(place)
    for child in children:
        rest += fbx_bytes(child, begin + head + len(rest), place, packed)
    rest += bytes(head + 1) if children else b""
    return struct.pack("<3" + place, begin + head + len(rest), len(values), len(data)) + rest


def fbx_file(elements, version=7400, packed=False):
    file = b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", version)
    place = "Q" if version >= 7500 else "I"
    for element in elements:
        file += fbx_bytes(element, len(file), place, packed)
    return file + bytes(3 * struct.calcsize(place) + 1)


def fbx_cases():
    text = "; FBX 7.4.0 project file\n" + "".join(map(fbx_text, fbx_elements()))
    for name, data in line_ends(text):
        yield Case(f"text_{name}.fbx", data)
    yield Case("mark.fbx", b"\xef\xbb\xbf" + text.encode())
    for version, packed in itertools.product((7400, 7500), (False, True)):
        yield Case(f"binary_{version}{'_packed' if packed else ''}.fbx", fbx_file(fbx_elements(), version, packed))
    moved = fbx_elements([("Lcl Translation", 8.0, 4.0, 2.0)], (-8, -4, -2))
    yield Case("moved.fbx", fbx_file(moved))
    pivot = [("Lcl Scaling", 2.0, 2.0, 2.0), ("ScalingPivot", 1.0, 2.0, 3.0), ("GeometricScaling", .5, .5, .5),
             ("ScalingOffset", 1.0, 2.0, 3.0)]
    yield Case("pivot.fbx", fbx_file(fbx_elements(pivot)))
    yield Case("shape.fbx", fbx_file(fbx_elements((), (0, 1, 5), 1)))
    yield Case("cut.fbx", fbx_file(moved)[:-20], refusal="is damaged")
    yield Case("old.fbx", text.replace("7400", "6100").encode(), refusal="of version 6100")
    yield Case("hidden.fbx", fbx_file(fbx_elements([("Visibility", 0.0)])), refusal="hidden")


def all_cases():
    for cases in (ply_cases, stl_cases, off_cases, obj_cases, fbx_cases):
        yield from cases()
