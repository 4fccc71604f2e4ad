"""What the tests of the adapters share: the program, the adapters, and what of their engines is missing."""

import importlib.machinery
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(os.environ.get("INKBENCH_SOURCE", Path(__file__).resolve().parents[2]))
PROGRAM = os.environ.get("INKBENCH", str(ROOT / "build" / "release" / "inkbench"))
OUTSIDE = ROOT / "methods" / "outside"
SKIPPED = 77
LONGEST_S = 600


def adapter(name):
    return OUTSIDE / name / name


def load_installer():
    """methods/outside/install as a module."""
    loader = importlib.machinery.SourceFileLoader("install", str(OUTSIDE / "install"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("install", loader))
    loader.exec_module(module)
    return module


def engines():
    with open(OUTSIDE / "engines.toml", "rb") as file:
        return tomllib.load(file)["package"]


def missing_packages(name):
    """The packages that an adapter needs and this machine lacks."""
    installer = load_installer()
    return [entry["name"] for entry in engines()
            if name in entry["for"] and not installer.state_of(entry)]


def skip_without(name):
    """Ends the test as skipped, with a sentence, where the adapter's engine is not installed."""
    missing = missing_packages(name)
    if missing:
        print(f"Skipped: {', '.join(missing)} is missing (methods/outside/install {name}).")
        sys.exit(SKIPPED)


def run(*words, **options):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          timeout=LONGEST_S, check=False, **options)


def export_view(scene, size, folder):
    """Writes a scene's first view; the path of its view.json."""
    done = run(PROGRAM, "export", scene, "--views", "1", "--size", size, "-o", folder)
    if done.returncode != 0:
        raise RuntimeError(done.stdout + done.stderr)
    return next(Path(folder).rglob("camera.json"))


def read_glb(path):
    """The JSON of a .glb and its bytes."""
    data = path.read_bytes()
    json_bytes = int.from_bytes(data[12:16], "little")
    return json.loads(data[20:20 + json_bytes]), data[28 + json_bytes:]


def scratch():
    return tempfile.TemporaryDirectory(prefix="inkbench-outside-")
