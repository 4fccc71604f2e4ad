"""The rules of the house. They read text, not a compiler's mind: an include inside `#if 0` counts.

    house_test.py [ROOT]     prints "path:line: what" for each breach of a checkout, then plants a
                             breach of every rule in made-up files and expects it to be found
"""

import posixpath
import re
import sys
from collections import defaultdict
from pathlib import Path

MADE = {".git", "build", "inkbench-out", "bootstrap.log"}  # no part of the sources, as in .gitignore
MOST_FILES, MOST_LINES, MOST_FLOORS = 60, 4300, 10
MOST_README_WORDS, MOST_NOTE_WORDS, MOST_WORDS, MOST_TASK_LINES = 450, 600, 50_000, 12
GENERATED = "experiments/columns.md"
DRAWERS = {"util", "utils", "common", "helper", "helpers", "misc"}

# A library: what its includes begin with, the folders in which any file may, and how many others may.
LIBRARIES = {
    "Embree": ("embree", ("bench/",), 1),
    "OpenImageIO": ("OpenImageIO/", (), 1),
    "Draco": ("draco/", ("tests/import/",), 1),
    "meshoptimizer": ("meshoptimizer", ("tests/import/",), 2),
    "OpenCV": ("opencv2/", ("src/score/", "src/inspect/", "methods/", "tests/", "bench/"), 0),
    "CLI11": ("CLI/", ("src/cli/",), 0),
    "pybind11": ("pybind11/", ("src/python/",), 0),
    "xxHash": ("xxhash.h", (), 1),
    "NLopt": ("nlopt", ("src/search/",), 0),
    "toml++": ("toml++/", (), 1),
}

# Flags that would change images, and words that a newcomer reads twice, with what to write instead.
FLAGS = r"-m(arch|tune|cpu)=native|-f(fast-math|associative-math)|-Ofast"
HABITS = {
    "knobs?": "parameter",
    "witness(es)?": "cross-check",
    "foretold|foretells?": "predicted",
    "ledgers?": "scene statistics",
    "(hang|hangs|hung) on": "depends on",
    "(is|are|was|be) (said|told)": "the subject that says it",
    "held against": "compared with",
    "from which on": "at least",
    "unless said": "the default",
    "reckon(s|ed|ing)?": "estimate, or rule",
    "worth": "what is gained",
    "nobody|whoever": "no method, or a noun",
    "who": "that, or a noun: methods are things",
}


def read_tree(root):
    """{path: text} of every file below a folder; one with a zero byte is no text and has none."""
    tree = {}
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        if name.split("/")[0] in MADE or not path.is_file():
            continue
        data = path.read_bytes()
        tree[name] = "" if b"\0" in data else data.decode("utf-8", "replace")
    return tree


def is_code(path):
    return path.endswith((".h", ".cpp", ".h.in"))


def folders_of(tree):
    return {"/".join(path.split("/")[:i]) for path in tree for i in range(1, path.count("/") + 1)}


def matches(tree, pattern, is_meant):
    """(path, line, text) wherever a file that is meant matches."""
    for path, text in tree.items():
        if is_meant(path):
            for match in re.finditer(pattern, text, re.M):
                yield path, text.count("\n", 0, match.start(1)) + 1, match.group(1)


def includes(tree, is_meant=is_code):
    return matches(tree, r'^[ \t]*#[ \t]*include[ \t]*([<"][^>"\n]+)[>"]', is_meant)


# ---- Rooms ----------------------------------------------------------------------------------


def rooms_of(tree):
    """{room: what it may include}, from the table of src/README.md; rooms, and headers by path.

    "all of the above" and "all" are the rooms of the rows before; "all that measure" those up to
    statistics, where the sentence below the table has them end.
    """
    rows = re.findall(r"^\| `(?:\.\./)?(\w+)` \| (.*?) \|", tree.get("src/README.md", ""), re.M)
    names = [name for name, _ in rows]
    measuring = names[:names.index("statistics") + 1] if "statistics" in names else []
    table = {}
    for i, (name, may) in enumerate(rows):
        allowed = set(re.findall(r"[a-z_]+/[\w/]+\.h|\b[a-z_]+\b", may))
        if "all that measure" in may:
            allowed |= set(measuring)
        elif re.match(r"all\b", may):
            allowed |= set(names[:i])
        table[name] = allowed
    return table


def room_of(path):
    top, *rest = path.split("/")
    return "methods" if top == "methods" else rest[0] if top == "src" and len(rest) > 1 else ""


def check_arrows(tree):
    """Rooms include what the table allows, by path from src/ or the root; no method another."""
    table = rooms_of(tree)
    if not table:
        yield "src/README.md: no table of rooms"
    for path, line, found in includes(tree, lambda p: is_code(p) and room_of(p) in table):
        target, room, why = found[1:], room_of(path), ""
        to = target.split("/")[0]
        if ".." in target or (found[0] == '"' and "/" not in target):
            why = "is not by path from src/ or the root"
        elif to in ("src", "tests", "bench"):
            why = "is none of the rooms' includes"
        elif room == to == "methods":
            # What several methods share has a folder, and is no method.
            shared = target.count("/") < 2 or target.split("/")[1] in (
                "grey_lines", "mesh_lookup", "surface_codes")
            own = target.split("/")[1] == path.split("/")[1]
            why = "" if shared or own else "is another method"
        elif to != room and to in table and not {to, target} & table[room]:
            why = f"is not allowed in {room}"
        if why:
            yield f"{path}:{line}: {target} {why}"


def check_floors(tree):
    """No room is its own foundation, and the tower of rooms is not too high."""
    floors = {}

    def floor_of(table, room, above):
        if room in above:
            raise RecursionError(f"{room} is below itself, by {', '.join(above)}")
        if room not in floors:
            below = {may.split("/")[0] for may in table[room]} & table.keys() - {room}
            floors[room] = 1 + max((floor_of(table, b, [*above, room]) for b in below), default=0)
        return floors[room]

    table = rooms_of(tree)
    try:
        top = max(table, key=lambda room: floor_of(table, room, []), default="")
    except RecursionError as error:
        yield f"src/README.md: {error}"
        return
    if floors.get(top, 0) > MOST_FLOORS:
        yield f"src/README.md: {top} is on floor {floors[top]}, of {MOST_FLOORS} at most"


def check_libraries(tree):
    """Each library is included where it serves."""
    for name, (prefix, folders, most) in LIBRARIES.items():
        files = {path for path, _, found in includes(tree)
                 if found[1:].startswith(prefix) and not path.startswith(folders)}
        if len(files) > most:
            yield f"{', '.join(sorted(files))}: {name}, which at most {most} file(s) here may include"


def check_folders(tree):
    """Folders of src/ are the rooms of the table, each with its CMakeLists.txt; no drawers."""
    table = rooms_of(tree)
    folders = folders_of(tree)
    for folder in sorted(folders):
        if folder.split("/")[-1] in DRAWERS:
            yield f"{folder}: a drawer, not a room"
    here = {f for f in folders if re.fullmatch(r"src/\w+", f)}
    there = {room if room == "methods" else f"src/{room}" for room in table}
    for folder in sorted(here - there):
        yield f"{folder}: no room of this name"
    for folder in sorted(there - folders):
        yield f"{folder}: this room is missing"
    for folder in sorted((here | {"methods", "tests", "bench"}) & folders):
        if f"{folder}/CMakeLists.txt" not in tree:
            yield f"{folder}: no CMakeLists.txt"


def check_sizes(tree):
    """No folder of a room is too large: that is two rooms, or one with folders in it."""
    files, lines = defaultdict(int), defaultdict(int)
    for path, text in tree.items():
        if room_of(path) and (is_code(path) or path.endswith(".inl")):
            folder = path.rpartition("/")[0]
            files[folder] += 1
            lines[folder] += text.count("\n")
    for folder in sorted(files):
        if files[folder] > MOST_FILES:
            yield f"{folder}: {files[folder]} files"
        if lines[folder] > MOST_LINES:
            yield f"{folder}: {lines[folder]} lines"


def check_tests(tree):
    """A test that no CMakeLists.txt names is never run."""
    built = " ".join(text for path, text in tree.items() if path.endswith("CMakeLists.txt"))
    for path in sorted(tree):
        if path.startswith("tests/") and path.endswith("_test.cpp") and path.rpartition("/")[2] not in built:
            yield f"{path}: no CMakeLists.txt builds it"


def check_methods(tree):
    """A method has .cpp, .toml, page, an entry in the registry and a line of CMake; a preset, whose
    .toml begins with its name, runs another's code, and has .toml and page."""
    registry, cmake = tree.get("methods/registry.cpp"), tree.get("methods/CMakeLists.txt")
    if registry is None or cmake is None:
        yield "methods: registry.cpp or CMakeLists.txt is missing"
        return
    for folder in sorted(folders_of(tree)):
        # One that begins with _ is a template; `outside` has programs that drive others' methods,
        # `grey_lines`, `mesh_lookup` and `surface_codes` what several methods share.
        match = re.fullmatch(r"methods/(?!_|outside|grey_lines|mesh_lookup|surface_codes)(\w+)", folder)
        if match is None:
            continue
        name = match.group(1)
        stem = f"{folder}/{name}"
        is_preset = tree.get(f"{stem}.toml", "").startswith("name = ")
        for ending in (".md", ".toml") if is_preset else (".md", ".cpp", ".toml"):
            if stem + ending not in tree:
                yield f"{stem}{ending}: missing"
        if is_preset and f"{stem}.cpp" in tree:
            yield f"{stem}.cpp: a preset has no code"
        if not is_preset and f"X({name})" not in registry:
            yield f"methods/registry.cpp: no line for {name}"
        if not re.search(rf"\n +{name}[)\n]", cmake):
            yield f"methods/CMakeLists.txt: no line for {name}"


# ---- Text -----------------------------------------------------------------------------------


def check_headers(tree):
    """Headers begin with `#pragma once`, before any code."""
    for path, text in tree.items():
        if path.endswith((".h", ".h.in")):
            code = [line for line in text.splitlines() if line and not line.startswith("//")]
            if code[:1] != ["#pragma once"]:
                yield f"{path}: code before #pragma once, or none"


def check_flags(tree):
    """No build file asks for the machine's own instructions or for loose arithmetic."""
    def is_meant(path):
        return (path.endswith(("CMakeLists.txt", ".cmake")) or path.startswith(".ci/")
                or path in ("CMakePresets.json", "bootstrap"))
    for path, line, found in matches(tree, f"({FLAGS})", is_meant):
        yield f"{path}:{line}: {found}"


def check_readme(tree):
    """README.md is short: its commands count; tables, comments and the targets of links do not."""
    text = re.sub(r"\]\([^)]*\)", "]", re.sub(r"^\|.*|<!--[^>]*-->", "", tree.get("README.md", ""), flags=re.M))
    count = sum(any(c.isalnum() for c in word) for word in text.split())
    if not 0 < count <= MOST_README_WORDS:
        yield f"README.md: {count} words, of {MOST_README_WORDS} at most"


def without_code(text):
    """A page in small letters with its code blanked out; every line keeps its number."""
    lines, is_in_block = [], False
    for line in text.lower().split("\n"):
        is_fence = line.startswith("```")
        is_in_block ^= is_fence
        is_blank = is_fence or is_in_block or line.startswith("    ")
        lines.append("" if is_blank else re.sub(r"`[^`]*`", "`", line))
    return "\n".join(lines)


def check_prose(tree):
    """Pages have no word of the list, and no fraction without its leading zero."""
    pages = {path: without_code(text) for path, text in tree.items() if path.endswith(".md")}
    rules = {rf"\b({words})\b".replace(" ", r"\s+"): instead for words, instead in HABITS.items()}
    rules[r"(?:^|[\s(\[|+-])(\.[0-9]+)(?![0-9a-z])"] = "its leading zero"
    for pattern, instead in rules.items():
        for path, line, found in matches(pages, pattern, lambda path: True):
            yield f"{path}:{line}: '{found}': write {instead}"


def check_words(tree):
    """Pages are short together, and so is each note."""
    words = {path: len(text.split()) for path, text in tree.items()
             if path.endswith(".md") and path != GENERATED}
    if sum(words.values()) > MOST_WORDS:
        yield f"all pages: {sum(words.values())} words, of {MOST_WORDS} at most"
    for path, count in words.items():
        if path.startswith("experiments/notes/") and count > MOST_NOTE_WORDS:
            yield f"{path}: {count} words, of {MOST_NOTE_WORDS} at most"


def check_guide(tree):
    """A task of the guide fits into twelve lines, commands among them; tables do not count."""
    for task in re.split(r"^##+ ", tree.get("experiments/guide.md", ""), flags=re.M)[1:]:
        name, *lines = [line for line in task.split("\n") if line and not line.startswith(("|", "```", "<!--"))]
        if len(lines) > MOST_TASK_LINES:
            yield f"experiments/guide.md: '{name}' has {len(lines)} lines, of {MOST_TASK_LINES} at most"


def anchors_of(page):
    """What links may name behind a #: headings in small letters, without marks, blanks as hyphens."""
    headings = re.findall(r"^#+ +(.*)$", re.sub(r"^```.*?^```", "", page, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_links(tree):
    """What a page links to is there, the heading too."""
    folders = folders_of(tree)
    pages = {path: re.sub(r"`[^`\n]*`", "`", text) for path, text in tree.items() if path.endswith(".md")}
    for path, line, link in matches(pages, r"\]\(([^)\s]+)\)", lambda path: True):
        file, _, anchor = link.partition("#")
        if ":" in file:
            continue
        target = posixpath.normpath(posixpath.join(posixpath.dirname(path), file)) if file else path
        if target not in tree and target not in folders:
            yield f"{path}:{line}: there is no {target}"
        elif anchor and anchor not in anchors_of(tree.get(target, "")):
            yield f"{path}:{line}: {target} has no #{anchor}"


RULES = [check_arrows, check_floors, check_libraries, check_folders, check_sizes, check_tests, check_methods,
         check_headers, check_flags, check_readme, check_prose, check_words,
         check_guide, check_links]

# ---- Planted faults -------------------------------------------------------------------------

TABLE = ("| `core` | nothing of ours | |\n| `scene` | core | |\n| `../methods` | core, scene | |\n"
         "| `truth` | core | |\n| `statistics` | core, `truth/line.h` | |\n"
         "| `harness` | all of the above | |\n| `tune` | all that measure, harness | |\n")
SOUND = {"src/README.md": TABLE, "README.md": "word " * 450 + "\n| a table |", "bench/CMakeLists.txt": "",
         "tests/CMakeLists.txt": "-O3 -ffp-contract=off", "methods/CMakeLists.txt": "(\n    dots)\n",
         "methods/registry.cpp": "X(dots)\n", "methods/dots/dots.toml": "source = 1\n",
         "methods/dots/dots.cpp": '#include "scene/mesh.h"\n#include "methods/dots/dots.h"\n',
         "methods/dots/dots.md": "0.5, 1..255 and `.5`, `knob`\n```sh\nknob\n```\n",
         "src/tune/a.cpp": '#include "truth/truth.h"\n#include "harness/row.h"\n',
         "src/statistics/a.h": '// Why.\n\n#pragma once\n#include "truth/line.h"\n',
         **{f"src/{room}/CMakeLists.txt": "" for room in
            ("core", "scene", "truth", "statistics", "harness", "tune")}}
# A rule, the file that breaks it (None: it is gone), and what is found.
PLANTED = [
    (check_arrows, "src/core/a.h", '\n  #  include <scene/mesh.h>\n', "src/core/a.h:2: scene/mesh.h is not"),
    (check_arrows, "src/scene/a.cpp", '#include "truth/line.h"', "is not allowed in scene"),
    (check_arrows, "src/statistics/b.h", '#include "truth/truth.h"', "is not allowed in statistics"),
    (check_arrows, "src/harness/a.h", '#include "tune/tune.h"', "is not allowed in harness"),
    (check_arrows, "src/tune/b.h", '#include "../core/a.h"', "is not by path"),
    (check_arrows, "src/tune/b.h", '#include "tune.h"', "is not by path"),
    (check_arrows, "src/tune/b.h", '#include "tests/x.h"', "is none of the rooms' includes"),
    (check_arrows, "methods/lines/lines.cpp", '#include "methods/dots/dots.h"', "is another method"),
    (check_arrows, "src/README.md", "", "no table of rooms"),
    (check_floors, "src/README.md", TABLE.replace("nothing of ours", "tune"), "is below itself"),
    (check_floors, "src/README.md", "".join(f"| `{c}` | all of the above | |\n" for c in
                                            "abcdefghijklm"), "m is on floor 13, of 10"),
    (check_libraries, "src/scene/a.cpp", "#include <opencv2/core.hpp>", "src/scene/a.cpp: OpenCV"),
    (check_libraries, "src/scene/a.cpp", "#include <CLI/CLI.hpp>", "CLI11, which at most 0"),
    (check_folders, "src/video/CMakeLists.txt", "", "src/video: no room"),
    (check_folders, "src/tune/CMakeLists.txt", None, "src/tune: no CMakeLists.txt"),
    (check_folders, "src/core/utils/a.h", "#pragma once", "src/core/utils: a drawer"),
    (check_folders, "src/README.md", TABLE + "| `cli` | all | |\n", "src/cli: this room is missing"),
    (check_sizes, "src/core/a.inl", "\n" * 4301, "src/core: 4301 lines"),
    (check_tests, "tests/core/a_test.cpp", "", "tests/core/a_test.cpp: no CMakeLists.txt builds it"),
    (check_methods, "methods/dots/dots.md", None, "methods/dots/dots.md: missing"),
    (check_methods, "methods/registry.cpp", "", "registry.cpp: no line for dots"),
    (check_methods, "methods/CMakeLists.txt", "", "CMakeLists.txt: no line for dots"),
    (check_methods, "methods/dots/dots.toml", None, "methods/dots/dots.toml: missing"),
    (check_methods, "methods/fine/fine.toml", "name = 1", "methods/fine/fine.md: missing"),
    (check_headers, "src/core/a.h", "#include <vector>\n#pragma once\n", "code before"),
    (check_headers, "src/core/a.h", "", "src/core/a.h: code before #pragma once, or none"),
    (check_flags, "CMakePresets.json", "\nx -march=native", "CMakePresets.json:2: -march=native"),
    (check_flags, "cmake/a.cmake", "-Ofast", "-Ofast"),
    (check_readme, "README.md", "word " * 451, "451 words"),
    (check_prose, "a.md", "Time\nhangs\non it.", "a.md:2: 'hangs\non': write depends on"),
    (check_prose, "a.md", "F .918", "a.md:1: '.918': write its leading zero"),
    (check_words, "a.md", "word " * MOST_WORDS, "all pages: "),
    (check_words, "experiments/notes/a.md", "word " * 601, "experiments/notes/a.md: 601 words"),
    (check_guide, "experiments/guide.md", "## A\n" + "| a |\na\n" * 13, "'A' has 13 lines, of 12"),
    (check_links, "tests/a.md", "[a](b.md)", "tests/a.md:1: there is no tests/b.md"),
    (check_links, "tests/a.md", "# A b, `c`\n[a](#a-b-c) [b](#a)", "tests/a.md:2: tests/a.md has no #a"),
]


def missed_faults():
    """Every rule, and each planted fault, that does not find what it must."""
    for rule in RULES:
        for found in rule(SOUND):
            yield f"{rule.__name__} finds in sound files: {found}"
        if rule not in [planted for planted, *_ in PLANTED]:
            yield f"{rule.__name__}: no fault is planted"
    crowded = {**SOUND, **{f"src/core/{i}.cpp": "" for i in range(61)}}
    if list(check_sizes(crowded)) != ["src/core: 61 files"]:
        yield "check_sizes overlooks 61 files"
    three = [check_libraries({f"src/{room}/a.h": "#include <embree4/rtcore.h>" for room in rooms})
             for rooms in (("truth",), ("truth", "scene"))]
    if [len(list(found)) for found in three] != [0, 1]:
        yield "check_libraries does not count doors"
    for rule, path, text, expected in PLANTED:
        tree = {**SOUND, path: text}
        if text is None:
            del tree[path]
            tree[path.rpartition("/")[0] + "/left.txt"] = ""
        if not any(expected in found for found in rule(tree)):
            yield f"{rule.__name__} overlooks {path}: {expected}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
    tree = read_tree(root)
    findings = [found for rule in RULES for found in rule(tree)]
    findings += list(missed_faults())
    print("\n".join(findings) or f"house: {len(tree)} files keep {len(RULES)} rules")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
