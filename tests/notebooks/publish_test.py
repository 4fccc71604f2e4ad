"""experiments/publish: what it writes is the run again, described whole, and the program reads it back."""

import csv
import gzip
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ["INKBENCH_SOURCE"])
sys.dont_write_bytecode = True
sys.path[:0] = [str(SOURCE / "notebooks"), str(Path(__file__).parent)]

import tiny_runs  # noqa: E402
from paper.runs import RunFolder  # noqa: E402

SCRIPT = SOURCE / "experiments/publish"
PACK_ABOVE_KIB = 8
DESK = tempfile.TemporaryDirectory(prefix="inkbench-publish-")


def call(*words):
    return subprocess.run([*map(str, words)], capture_output=True, text=True, check=False)


class Publish(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_folder = Path(tiny_runs.make("compare", DESK.name))
        cls.out = Path(DESK.name) / "published"
        done = cls.publish(cls.out)
        assert done.returncode == 0, done.stderr
        cls.croissant = json.loads((cls.out / "croissant.json").read_text(encoding="utf-8"))

    @classmethod
    def publish(cls, out):
        return call(SCRIPT, cls.run_folder, "-o", out, "--name", "tiny", "--date", "2026-01-02",
                    "--pack-above", PACK_ABOVE_KIB)

    @staticmethod
    def bytes_of(path):
        return gzip.decompress(path.read_bytes()) if path.suffix == ".gz" else path.read_bytes()

    def test_every_table_is_there_byte_for_byte_and_long_ones_are_packed(self):
        published = {item["@id"].removesuffix(".gz"): self.out / item["@id"]
                     for item in self.croissant["distribution"]}
        tables = {path.name for path in self.run_folder.glob("*.csv")}
        self.assertEqual(set(published), tables | {"run.toml"})
        for name, path in published.items():
            self.assertEqual(self.bytes_of(path), (self.run_folder / name).read_bytes(), name)
            is_long = (self.run_folder / name).stat().st_size > PACK_ABOVE_KIB * 1024
            self.assertEqual(path.suffix == ".gz", is_long and name != "run.toml", name)
        self.assertIn(".gz", {path.suffix for path in published.values()})

    def test_hashes_and_sizes_are_those_of_the_files(self):
        for item in self.croissant["distribution"]:
            data = (self.out / item["contentUrl"]).read_bytes()
            self.assertEqual(item["sha256"], hashlib.sha256(data).hexdigest())
            self.assertEqual(item["contentSize"], f"{len(data)} B")

    def test_every_column_is_described_with_a_type_that_its_values_have(self):
        kinds = {"sc:Integer": int, "sc:Float": float, "sc:Text": str}
        by_name = {records["name"]: records for records in self.croissant["recordSet"]}
        for path in self.run_folder.glob("*.csv"):
            records = by_name[path.stem]
            with path.open(encoding="utf-8", newline="") as file:
                reader = csv.DictReader(file)
                heads, lines = reader.fieldnames, list(reader)
            self.assertEqual([field["name"] for field in records["field"]], heads)
            for field in records["field"]:
                self.assertTrue(field["description"])
                self.assertEqual(field["source"]["extract"]["column"], field["name"])
                for line in lines:
                    if line[field["name"]] != "":
                        kinds[field["dataType"]](line[field["name"]])
        units = {field["name"]: field.get("unitText") for field in by_name["rows"]["field"]}
        self.assertEqual((units["truth_px"], units["draw_ns_min"], units["method"]), ("px", "ns", None))
        types = {field["name"]: field["dataType"] for field in by_name["rows"]["field"]}
        self.assertEqual((types["k_2px"], types["f_2px"], types["scene"]), ("sc:Integer", "sc:Float", "sc:Text"))

    def test_what_croissant_asks_of_a_data_set_is_there(self):
        for name in ("@context", "@type", "conformsTo", "name", "description", "license", "url", "creator",
                     "datePublished", "distribution", "recordSet"):
            self.assertTrue(self.croissant[name], name)
        files = {item["@id"] for item in self.croissant["distribution"]}
        names = [field["@id"] for records in self.croissant["recordSet"] for field in records["field"]]
        self.assertEqual(len(names), len(set(names)))
        for records in self.croissant["recordSet"]:
            for field in records["field"]:
                self.assertIn(field["source"]["fileObject"]["@id"], files)

    def test_the_same_run_gives_the_same_bytes(self):
        again = Path(DESK.name) / "again"
        self.assertEqual(self.publish(again).returncode, 0)
        for path in self.out.iterdir():
            self.assertEqual(path.read_bytes(), (again / path.name).read_bytes(), path.name)

    def test_program_and_figures_read_it_as_they_read_the_run(self):
        done = call(tiny_runs.PROGRAM, "diff", self.run_folder, self.out, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads(done.stdout)
        self.assertTrue(all(method["changed_images"] == method["changed_scores"] == 0 for method in told["methods"]))
        self.assertTrue(told["methods"])
        for name in ("rows.csv", "curves.csv"):
            self.assertTrue(RunFolder(self.out).table(name).equals(RunFolder(self.run_folder).table(name)), name)

    def test_what_is_no_finished_run_is_refused_and_nothing_is_written(self):
        nowhere = Path(DESK.name) / "nowhere"
        done = call(SCRIPT, Path(DESK.name) / "missing", "-o", nowhere)
        self.assertEqual((done.returncode, nowhere.exists()), (2, False))
        self.assertIn("run.toml", done.stderr)
        other = Path(DESK.name) / "other"
        other.mkdir()
        (other / "thesis.tex").write_text("mine", encoding="utf-8")
        self.assertEqual(call(SCRIPT, self.run_folder, "-o", other).returncode, 2)
        self.assertEqual([path.name for path in other.iterdir()], ["thesis.tex"])

    def test_a_packed_table_that_is_cut_short_is_told(self):
        cut = Path(DESK.name) / "cut"
        shutil.copytree(self.out, cut)
        packed = next(path for path in cut.glob("*.csv.gz"))
        packed.write_bytes(packed.read_bytes()[:-9])
        done = call(tiny_runs.PROGRAM, "diff", cut, cut)
        self.assertEqual(done.returncode, 2)
        self.assertIn(packed.name, done.stderr)


if __name__ == "__main__":
    unittest.main()
