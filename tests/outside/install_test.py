"""methods/outside/install, and what it says of the adapters; with an `npm` that is a script."""

import io
import os
import sys
import tarfile
import unittest
from pathlib import Path

import adapters

INSTALL = adapters.OUTSIDE / "install"


def write_npm(folder):
    """A client that brings an archive of this name with another content."""
    archive = folder / "made.tgz"
    with tarfile.open(archive, "w:gz") as tar:
        member = tarfile.TarInfo("package/package.json")
        member.size = 2
        tar.addfile(member, io.BytesIO(b"{}"))
    npm = folder / "npm"
    npm.write_text(f"#!/bin/sh\ncp {archive} three-0.160.0.tgz\n")
    npm.chmod(0o755)


class InstallTest(unittest.TestCase):
    def test_every_adapter_has_its_packages_listed(self):
        found = sorted(path.parent.name for path in adapters.OUTSIDE.glob("*/*")
                       if path.name == path.parent.name)
        self.assertGreaterEqual(len(found), 5)
        listed = {n for entry in adapters.engines() for n in entry["for"]}
        self.assertEqual(found, sorted(listed - {"babylon", "gltf_validator", "brep"}))  # which are none
        said = adapters.run(sys.executable, INSTALL, "--list")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertEqual(len(said.stdout.splitlines()), len(adapters.engines()))
        for name in found:
            self.assertIn(name, said.stdout)

    def test_an_unknown_name_is_refused_with_those_accepted(self):
        said = adapters.run(sys.executable, INSTALL, "maya")
        self.assertEqual(said.returncode, 2)
        self.assertIn("'maya'", said.stderr)
        self.assertIn("three_ids", said.stderr)

    def test_a_package_of_another_content_is_not_installed(self):
        with adapters.scratch() as folder:
            write_npm(Path(folder))
            changed = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}",
                       "XDG_CACHE_HOME": f"{folder}/cache"}
            said = adapters.run(sys.executable, "-c", (
                "import runpy, sys\n"
                f"install = runpy.run_path({str(INSTALL)!r})\n"
                "three, = [e for e in install['tomllib'].load(open(install['LIST'], 'rb'))['package']"
                " if e['name'] == 'three']\n"
                "sys.exit(0 if install['install'](three) else 1)\n"), env=changed)
            self.assertEqual(said.returncode, 1, said.stdout + said.stderr)
            self.assertIn("sha256", said.stdout)
            self.assertFalse((Path(folder) / "cache/inkbench/outside/three-0.160.0").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
