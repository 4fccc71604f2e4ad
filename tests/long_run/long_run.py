#!/usr/bin/python3
"""A long run that everything goes wrong with; what it leaves must be what an undisturbed run leaves.

    tests/long_run/long_run.py PROGRAM [--minutes 60] [--cells 20000] [--seed 1] [--folder DIR]

Computes a grid of so many cells. While it computes, the run is killed with -9 at random times, its disk fills up
twice (a small file system of its own, which needs root; without, this part is left out and said so), the clock is
set back by two days (Debian's libfaketime, likewise), and a second process begins in the same folder, which
must be refused. In the end every table is compared byte by byte with an undisturbed run's, and the memory of the
longest stretch is printed: least and most, a minute after its begin and at its end. Exit code 1: something was lost,
came twice or grew.
"""

import argparse
import filecmp
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BAD_INPUT = 2  # also the exit code of a full disk
EXPERIMENT = """\
name = "long"
kind = "compare"

[grid]
scenes = ["train", "heldout"]
sizes = [{sizes}]
views = 1

[measure]
repetitions = 1

[sweep]
own_views = 0
"""


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--minutes", type=float, default=60, help="the disturbed run is killed so often that it takes this long")
    parser.add_argument("--cells", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", type=Path, help="where to work; kept (default: a folder that is removed)")
    return parser.parse_args()


def say(text):
    print(f"[{time.strftime('%H:%M:%S')}] {text}", flush=True)


def memory_mib(pid):
    """Of a process, resident; 0 once it has ended."""
    try:
        with open(f"/proc/{pid}/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20
    except (FileNotFoundError, ProcessLookupError, IndexError):
        return 0


def clock_set_back():
    """The environment in which a program sees the clock of two days ago; None without the library for it."""
    libraries = sorted(Path("/usr/lib").glob("*/faketime/libfaketime.so.1"))
    return {"LD_PRELOAD": str(libraries[0]), "FAKETIME": "-2d"} if libraries else None


class Disk:
    """A file system of a given size that the run's folder lies on; an ordinary folder without root."""

    def __init__(self, folder, size_mib):
        self.folder = folder
        folder.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size_mib}m", "inkbench", folder], capture_output=True)
        self.is_small = done.returncode == 0
        self.size_mib = size_mib
        if not self.is_small:
            say("left out: a full disk (mounting a file system needs root)")

    def resize(self, size_mib):
        subprocess.run(["mount", "-o", f"remount,size={size_mib}m", self.folder], check=True)

    def used_mib(self):
        usage = shutil.disk_usage(self.folder)
        return usage.used / 2**20

    def close(self):
        if self.is_small:
            subprocess.run(["umount", self.folder], check=False)


class LongRun:
    def __init__(self, program, experiment, out, log):
        self.command = [program, "run", experiment, "--no-times", "--quiet", "--out", out]
        self.log = log
        self.faults = []

    def start(self, clock=None):
        environment = {**os.environ, **(clock or {})}
        return subprocess.Popen(self.command, stdout=self.log, stderr=subprocess.STDOUT, env=environment)

    def fault(self, text):
        say("FAULT: " + text)
        self.faults.append(text)


def compare_tables(expected, found):
    names = sorted(p.relative_to(expected) for p in expected.rglob("*") if p.is_file())
    others = sorted(p.relative_to(found) for p in found.rglob("*") if p.is_file())
    differing = [str(n) for n in names if n.suffix in (".csv", ".png")
                 and not ((found / n).is_file() and filecmp.cmp(expected / n, found / n, shallow=False))]
    lost = [str(n) for n in names if n not in others]
    new = [str(n) for n in others if n not in names]
    return differing, lost, new


def disturb(run, arguments, disk):
    """Until the run is done: kills, full disks, a clock set back, a second process."""
    chance = random.Random(arguments.seed)
    end = time.monotonic() + 60 * arguments.minutes
    kills = fulls = refused = 0
    set_back = clock_set_back()
    if set_back is None:
        say("left out: a clock set back (Debian: libfaketime)")
    stretch = None  # the memory of the longest stretch without a kill
    while True:
        is_full_turn = disk.is_small and fulls < 2 and kills >= 3 * (fulls + 1)
        if is_full_turn:
            disk.resize(max(1, int(disk.used_mib()) + 1))
        process = run.start(set_back if kills % 4 == 2 else None)
        began = time.monotonic()
        is_last = time.monotonic() > end
        seconds = 1e9 if is_last or is_full_turn else chance.uniform(3, 45)
        samples = []
        if kills == 1:
            time.sleep(2)
            second = run.start()
            if second.wait() != BAD_INPUT:
                run.fault(f"a second process in the folder ended with {second.returncode}")
            refused += 1
        while process.poll() is None and time.monotonic() - began < seconds:
            time.sleep(0.5)
            samples.append(memory_mib(process.pid))
        samples = [s for s in samples if s > 0]
        if samples and (stretch is None or len(samples) > len(stretch)):
            stretch = samples
        if process.poll() is None:
            process.send_signal(signal.SIGKILL)
            process.wait()
            kills += 1
            continue
        if is_full_turn:
            if process.returncode != BAD_INPUT:
                run.fault(f"on a full disk the run ended with {process.returncode}")
            fulls += 1
            kills += 1
            disk.resize(disk.size_mib)
            continue
        say(f"done with exit code {process.returncode} after {kills} kills, {fulls} full disks, {refused} second processes")
        if process.returncode not in (0, 3):
            run.fault(f"the run ended with {process.returncode}")
        return stretch


def main():
    arguments = parse_arguments()
    folder = arguments.folder or Path(tempfile.mkdtemp(prefix="inkbench-long-"))
    folder.mkdir(parents=True, exist_ok=True)
    experiment = folder / "long.toml"
    # 36 scenes and some 35 rows a view and size.
    sizes = max(1, round(arguments.cells / (36 * 35)))
    experiment.write_text(EXPERIMENT.format(sizes=", ".join(f'"{64 + 4 * i}x{36 + 2 * i}"' for i in range(sizes))))
    disk = Disk(folder / "disk", 4096)
    try:
        with open(folder / "log.txt", "w", encoding="utf-8") as log:
            say("an undisturbed run")
            calm = LongRun(arguments.program, experiment, folder / "calm", log)
            code = calm.start().wait()
            if code not in (0, 3):
                sys.exit(f"long_run: the undisturbed run ended with {code}; see {folder / 'log.txt'}")
            rows = sum(1 for _ in open(folder / "calm/rows.csv", encoding="utf-8")) - 1
            say(f"{rows} rows; now a disturbed one for {arguments.minutes:g} minutes or until it is done")
            run = LongRun(arguments.program, experiment, folder / "disk/run", log)
            stretch = disturb(run, arguments, disk)
        differing, lost, new = compare_tables(folder / "calm", folder / "disk/run")
        for what, names in (("differs", differing), ("is missing", lost), ("is new", new)):
            for name in names[:20]:
                run.fault(f"{name} {what}")
        if stretch:
            tenth = max(1, len(stretch) // 10)
            say(f"memory of the longest stretch ({len(stretch) / 2:.0f} s): {max(stretch[:tenth]):.0f} MiB in its first tenth, "
                f"{max(stretch[-tenth:]):.0f} in its last, {max(stretch):.0f} at most")
        say("nothing lost, nothing twice" if not run.faults else f"{len(run.faults)} faults")
        return 1 if run.faults else 0
    finally:
        disk.close()
        if arguments.folder is None:
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
