"""Open CASCADE's hidden-line algorithms on a view: builds hidden_lines.cpp once, calls it, reads its lines."""

import hashlib
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from entrant import Absent, Failed, find_program, refuse, store  # noqa: E402
from polylines import draw_polyline  # noqa: E402

SOURCE = HERE / "hidden_lines.cpp"
HEADERS = Path("/usr/include/opencascade")
LIBRARIES = "TKHLR TKMesh TKTopAlgo TKBRep TKGeomAlgo TKGeomBase TKG3d TKG2d TKMath TKernel".split()
LONGEST_S = 3600


@dataclass
class Drawing:
    """Segments as (n, 2, 2) in px, and the seconds of each part."""

    visible: numpy.ndarray
    hidden: numpy.ndarray
    seconds: dict


def built(name, files, libraries, adapter):
    """The program that sources (.cpp, and .h beside them) make with Open CASCADE, compiled on its
    first use. Raises Absent, Failed."""
    compiler = find_program("c++", adapter)
    if not (HEADERS / "Standard_Version.hxx").exists():
        raise Absent("Open CASCADE's headers are not installed (methods/outside/install "
                     f"{adapter})")
    made_of = b"".join(file.read_bytes() for file in [*files, HEADERS / "Standard_Version.hxx"])
    program = store() / f"{name}-{hashlib.sha256(made_of).hexdigest()[:16]}"
    if program.exists():
        return program
    store().mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=store()) as folder:
        part = Path(folder) / name
        sources = [file for file in files if file.suffix == ".cpp"]
        done = subprocess.run([compiler, "-std=c++20", "-O2", "-isystem", HEADERS, *sources, "-o", part,
                               *[f"-l{library}" for library in libraries]],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"{name} is not built: {last_line(done.stderr)}")
        part.rename(program)
    return program


def last_line(text):
    return (text.strip().splitlines() or ["it does not say why"])[-1]


def camera_numbers(view):
    """What hidden_lines reads; exits with 2 where the view is in perspective."""
    camera = view.asked["camera"]
    if camera["projection"] != "parallel":
        refuse(f"{view.path}: the camera is in perspective (accepted: a parallel one, as inkbench export "
               "--projection parallel writes it)")
    width, height = view.size_px
    rows = view.asked["view_from_world"][:3]
    return [width, height, height / camera["height"], *[number for row in rows for number in row]]


def call(name, method, view, seconds=LONGEST_S):
    """The lines of hidden_lines' file, and the seconds it prints by part. Raises Absent, Failed."""
    numbers = camera_numbers(view)
    with tempfile.TemporaryDirectory(prefix="inkbench-open-cascade-") as folder:
        out = Path(folder) / "lines.txt"
        try:
            done = subprocess.run([built("hidden_lines", [SOURCE], LIBRARIES, name),
                                   method, view.file("obj"), out], text=True,
                                  input=" ".join(map(str, numbers)), capture_output=True,
                                  check=False, timeout=seconds)
        except subprocess.TimeoutExpired:
            raise Failed(f"no result in {seconds} s") from None
        if done.returncode != 0:
            raise Failed(last_line(done.stderr) if done.returncode > 0
                         else f"Open CASCADE ended by signal {-done.returncode}")
        times = dict(line.split() for line in done.stdout.splitlines())
        return out.read_text().splitlines(), {key: float(value) for key, value in times.items()}


def drawing(name, method, view, seconds=LONGEST_S):
    """The Drawing of a view by `exact` or `polygonal`. Raises Absent, Failed."""
    lines, times = call(name, method, view, seconds)
    return Drawing(points(lines, "visible", 2), points(lines, "hidden", 2), times)


def points(lines, kind, corners):
    """All lines of a kind as (n, corners, 2)."""
    numbers = [line.replace(",", " ").split()[1:] for line in lines if line.startswith(kind + " ")]
    return numpy.array(numbers, float).reshape(-1, corners, 2)


def fill(triangle, image):
    """Every pixel whose centre a triangle covers."""
    first = numpy.maximum(numpy.floor(triangle.min(axis=0)), 0).astype(int)
    last = numpy.minimum(numpy.ceil(triangle.max(axis=0)), image.shape[::-1]).astype(int)
    y, x = numpy.mgrid[first[1]:last[1], first[0]:last[0]] + 0.5
    sides = [(b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
             for a, b in zip(triangle, numpy.roll(triangle, -1, axis=0))]
    is_inside = (numpy.min(sides, axis=0) >= 0) | (numpy.max(sides, axis=0) <= 0)
    image[first[1]:last[1], first[0]:last[0]][is_inside] = 255


def mask(name, view):
    """The mesh in white, as the projector of Open CASCADE places it."""
    width, height = view.size_px
    image = numpy.zeros((height, width), numpy.uint8)
    for triangle in points(call(name, "triangles", view)[0], "triangle", 3):
        fill(triangle, image)
    return image


def draw(name, method, view, is_mask):
    """What run_adapter calls: lines one pixel wide, and the time of the algorithm without sewing."""
    if is_mask:
        return mask(name, view), 1e-4
    width, height = view.size_px
    image = numpy.zeros((height, width), numpy.uint8)
    found = drawing(name, method, view)
    for segment in found.visible:
        draw_polyline(segment, image)
    return image, 1e3 * found.seconds["algorithm_s"]
