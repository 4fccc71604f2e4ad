"""experiments/models/fetch on made-up packages, without a network: `npm` and `apt-get` are scripts that
copy an archive, or fail."""

import gzip
import hashlib
import io
import os
import shutil
import struct
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import unittest
import zipfile
from collections import Counter
from pathlib import Path

SOURCE = Path(os.environ.get("INKBENCH_SOURCE", Path(__file__).resolve().parents[2]))
FETCH = SOURCE / "experiments" / "models" / "fetch"
sys.path.insert(0, str(FETCH.parent))
import quake  # noqa: E402

TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
JSON_MESH = b"exports.positions=[[0,0,0],[1,0,0],[0,1,0]]\nexports.cells=[[0,1,2]]\n"


def sha(data):
    return hashlib.sha256(data).hexdigest()


def md3(points, tags):
    """A file of one frame with one triangle, and tags that move by their origin alone."""
    tag_data = b"".join(struct.pack("<64s12f", name.encode(), *origin, 2, 0, 0, 0, 2, 0, 0, 0, 2)
                        for name, origin in tags)
    surface_size = 108 + 12 + 8 * len(points)
    surface = struct.pack("<4s64s10i", b"IDP3", b"s", 0, 1, 0, len(points), 1, 108, 0, 0, 120,
                          surface_size)
    surface += struct.pack("<3i", 0, 1, 2)
    surface += b"".join(struct.pack("<4h", *(round(64 * x) for x in p), 0) for p in points)
    header = struct.pack("<4si64si", b"IDP3", 15, b"m", 0) + struct.pack("<3i", 1, len(tags), 1)
    header += struct.pack("<i", 0)
    header += struct.pack("<4i", 108, 108, 108 + len(tag_data), 0)
    return header.ljust(108, b"\0") + tag_data + surface


class Desk:
    """A folder with a list of models and clients that know these packages alone."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp())
        self.bin, self.store = self.folder / "bin", self.folder / "store"
        self.bin.mkdir()
        self.store.mkdir()
        self.entries = []
        for name in ("npm", "apt-get"):
            script = self.bin / name
            script.write_text(f"#!/bin/sh\necho \"{name} $*\" >> {self.folder}/calls\n"
                              f"cp {self.store}/\"$(echo $2 | tr -d / | cut -d= -f1)\"/* . "
                              f"2>/dev/null || {{ echo E: no such package >&2; exit 1; }}\n")
            script.chmod(0o755)

    def npm(self, name, version, files):
        place = self.store / f"{name}@{version}"
        place.mkdir()
        with tarfile.open(place / f"{name}-{version}.tgz", "w:gz") as tar:
            for path, data in files.items():
                info = tarfile.TarInfo("package/" + path)
                info.size = len(data)
                tar.addfile(info, io.BytesIO(data))

    def debian(self, name, version, files):
        root = self.folder / "root" / name
        (root / "DEBIAN").mkdir(parents=True)
        (root / "DEBIAN" / "control").write_text(
            f"Package: {name}\nVersion: {version}\nArchitecture: all\nMaintainer: nobody\n"
            "Description: made up\n")
        for path, data in files.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_bytes(data)
        (self.store / name).mkdir()
        subprocess.run(["dpkg-deb", "--build", root, self.store / name / f"{name}_{version}_all.deb"],
                       check=True, capture_output=True)

    def list(self, source, package, version, *models):
        self.entries.append(f'[[package]]\nname = "{package}"\nsource = "{source}"\n'
                            f'version = "{version}"\nlicence = "none"\n')
        for name, path, data, convert in models:
            self.entries.append(
                f'[[package.model]]\nname = "{name}"\npath = "{path}"\nsha256 = "{sha(data)}"\n'
                f'convert = "{convert}"\nfile = "{name}.obj"\n')

    def fetch(self, *arguments):
        listed = self.folder / "models.toml"
        listed.write_text("\n".join(self.entries))
        return subprocess.run(
            ["/usr/bin/python3", "-B", FETCH, "--from", listed, "-o", self.folder / "out", *arguments],
            env={"PATH": f"{self.bin}:/usr/bin:/bin"}, capture_output=True, text=True, check=False)

    def made(self, name):
        return (self.folder / "out" / f"{name}.obj").read_bytes()

    def calls(self):
        calls = self.folder / "calls"
        return calls.read_text().splitlines() if calls.exists() else []


class Fetch(unittest.TestCase):
    def setUp(self):
        self.desk = Desk()
        self.addCleanup(shutil.rmtree, self.desk.folder)

    def expect_got(self, calls, *names):
        """All is got by these calls of clients, and these models are the triangle."""
        done = self.desk.fetch()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for name in names:
            self.assertEqual(self.desk.made(name), TRIANGLE)
        self.assertEqual(self.desk.calls(), calls)

    def test_gets_checks_and_converts(self):
        packed = gzip.compress(TRIANGLE, mtime=0)
        self.desk.npm("tiny", "1.0.0", {"a.obj.gz": packed, "index.js": JSON_MESH})
        self.desk.list("npm", "tiny", "1.0.0", ("a", "a.obj.gz", packed, "gunzip"),
                       ("b", "index.js", JSON_MESH, "json_mesh"))
        self.expect_got(["npm pack tiny@1.0.0 --silent"], "a", "b")
        self.assertIn("a, b: tiny 1.0.0 (npm), none",
                      (self.desk.folder / "out" / "LICENCES.txt").read_text())

    @unittest.skipUnless(shutil.which("dpkg-deb"), "there is no dpkg-deb")
    def test_reads_debian_packages_and_archives_in_them(self):
        pack = io.BytesIO()
        with zipfile.ZipFile(pack, "w") as inner:
            inner.writestr("maps/m.obj", TRIANGLE)
        self.desk.debian("tiny", "2-1", {"usr/share/t.obj": TRIANGLE, "usr/p.pk3": pack.getvalue(),
                                         "usr/p.sh3f": pack.getvalue()})
        self.desk.list("debian", "tiny", "2-1", ("t", "usr/share/t.obj", TRIANGLE, "copy"),
                       ("m", "usr/p.pk3/maps/m.obj", TRIANGLE, "copy"),
                       ("n", "usr/p.sh3f/maps/m.obj", TRIANGLE, "copy"))
        self.expect_got(["apt-get download tiny=2-1"], "t", "m", "n")

    def test_says_what_it_could_not_get_and_why(self):
        self.desk.npm("tiny", "1.0.0", {"a.obj": TRIANGLE})
        self.desk.list("npm", "tiny", "1.0.0", ("a", "a.obj", TRIANGLE, "copy"),
                       ("other", "a.obj", b"another", "copy"), ("gone", "b.obj", b"", "copy"),
                       ("bad", "a.obj", TRIANGLE, "json_mesh"))
        self.desk.list("npm", "absent", "1.0.0", ("far", "a.obj", TRIANGLE, "copy"))
        done = self.desk.fetch()
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.desk.made("a"), TRIANGLE, "what can be had is had")
        for name, reason in (("other", "sha256"), ("gone", "the package holds no package/b.obj"),
                             ("bad", "cannot be converted"), ("far", "npm pack absent@1.0.0")):
            self.assertRegex(done.stdout, rf"(?m)^{name} +not got: .*{reason}")
            self.assertFalse((self.desk.folder / "out" / f"{name}.obj").exists())
        self.assertIn("inkbench compare --scenes", done.stdout)

    def test_keeps_what_is_there(self):
        self.desk.npm("tiny", "1.0.0", {"a.obj": TRIANGLE})
        self.desk.list("npm", "tiny", "1.0.0", ("a", "a.obj", TRIANGLE, "copy"))
        self.assertEqual(self.desk.fetch().returncode, 0)
        self.assertEqual(self.desk.fetch().returncode, 0)
        self.assertEqual(len(self.desk.calls()), 1)

    def test_lists_without_getting(self):
        self.desk.list("npm", "tiny", "1.0.0", ("a", "a.obj", TRIANGLE, "copy"))
        done = self.desk.fetch("--list")
        self.assertEqual((done.returncode, done.stdout), (0, "a: tiny 1.0.0 (npm), none\n"))
        self.assertEqual(self.desk.calls(), [])

    def test_refuses_bad_input_in_one_line(self):
        self.desk.list("npm", "tiny", "1.0.0", ("a", "a.obj", TRIANGLE, "melt"))
        for done, words in ((self.desk.fetch(), "'melt' (accepted: copy"),
                            (self.desk.fetch("--from", "nowhere.toml"), "nowhere.toml: No such file")):
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)


class Quake(unittest.TestCase):
    def test_joins_a_player_at_his_tags_without_their_scale(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
        parts = [md3(points, [("tag_torso", (0, 0, 10))]), md3(points, [("tag_head", (5, 0, 10))]),
                 md3(points, [])]
        positions, triangles = quake.player_mesh(parts)
        self.assertEqual(positions[0], (0, 0, 0))
        self.assertEqual(positions[3], (0, 10, 0), "z up becomes y up")
        self.assertEqual(positions[6], (5, 20, 0))
        self.assertEqual(positions[7], (6, 20, 0), "the tag's axes of length 2 do not scale")
        self.assertEqual(triangles, [(0, 2, 1), (3, 5, 4), (6, 8, 7)])

    def test_refuses_what_is_neither(self):
        with self.assertRaises(ValueError):
            quake.map_mesh(b"no map at all")
        with self.assertRaises(ValueError):
            quake.player_mesh([b"nothing".ljust(200, b"\0")] * 3)


class List(unittest.TestCase):
    def test_ours_is_whole_and_all_its_files_are_drawn(self):
        done = subprocess.run(["/usr/bin/python3", "-B", FETCH, "--list"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = (SOURCE / "experiments" / "models.toml").read_text(encoding="utf-8")
        files = [line.split('"')[1] for line in text.splitlines() if line.startswith("file = ")]
        self.assertEqual(len(files), len(set(files)))
        asked = (SOURCE / "experiments" / "real.toml").read_text(encoding="utf-8")
        still = [word.rpartition("/")[2] for word in asked.split('"') if word.startswith("inkbench-out")]
        moving, = (line for line in text.splitlines() if line.startswith("# ") and " move: " in line)
        self.assertEqual(len(still), len(set(still)))
        self.assertEqual([], [file for file in still if file not in files])
        self.assertEqual([], [file for file in files if file not in still and Path(file).stem not in moving])
        listed = tomllib.loads(text)["package"]
        models = [model for package in listed for model in package["model"] if model["file"] in still]
        kinds = Counter(model["kind"] for model in models)
        tuned_on = Counter(model["kind"] for model in models if model.get("split") == "train")
        self.assertEqual((len(models), len(kinds)), (40, 10))
        for kind, count in kinds.items():
            self.assertGreaterEqual(count, 3, kind)
            self.assertLessEqual(3 * tuned_on[kind], count, f"at most a third of {kind} is tuned on")
        for line in text.splitlines():
            if line.startswith("sha256"):
                self.assertRegex(line, r'^sha256 = "[0-9a-f]{64}"$')


if __name__ == "__main__":
    unittest.main()
