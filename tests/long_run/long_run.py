#!/usr/bin/python3
"""A long run that everything goes wrong with; what it leaves must be what an undisturbed run leaves.

    tests/long_run/long_run.py PROGRAM [--minutes 60] [--cells 20000] [--seed 1] [--folder DIR]

Computes a grid of about so many cells, first undisturbed, then again and again for so many minutes, each time in a new
folder, while
- it is killed with -9 at random times,
- its disk fills up twice (a small file system, which needs root),
- the clock is set back by two days while it computes (needs Debian's faketime),
- a second process begins in the same folder, which must be refused.
What cannot be had is left out, and said so. In the end every table and picture of each is compared byte by byte with
the undisturbed run's, and no file may be there that the other lacks. Exit code 1: something was lost, came twice or grew.
"""

import argparse
import filecmp
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path

BAD_INPUT = 2  # also the exit code of a full disk
# What an undisturbed run may hold more at its end than at its middle, in MiB and as a share.
GROWTH_MIB, GROWTH_SHARE = 50, 0.1
ROWS_PER_VIEW = 35  # about: a row a method, and one for each value of those with a sweep
MOST_TRIANGLES = 10_000
EXPERIMENT = """\
name = "long"
kind = "compare"

[grid]
scenes = [{scenes}]
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
    parser.add_argument("--minutes", type=float, default=60, help="how long runs are disturbed")
    parser.add_argument("--cells", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", type=Path, help="where to work; kept (default: a folder that is removed)")
    return parser.parse_args()


def say(text):
    print(f"[{time.strftime('%H:%M:%S')}] {text}", flush=True)


def small_scenes(program):
    """Names of the catalogue's scenes that leave time for many cells."""
    listed = subprocess.run([program, "list", "scenes", "--json"], capture_output=True, check=True).stdout
    return [scene["name"] for scene in json.loads(listed)["scenes"] if scene["triangles"] <= MOST_TRIANGLES]


def memory_mib(pid):
    """Of a process, resident; 0 once it has ended."""
    try:
        with open(f"/proc/{pid}/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20
    except (FileNotFoundError, ProcessLookupError, IndexError):
        return 0


class Clock:
    """The time of day that the runs see; it can be set back while they compute."""

    def __init__(self, folder):
        libraries = sorted(Path("/usr/lib").glob("*/faketime/libfaketimeMT.so.1"))
        self.file = folder / "clock"
        self.set("+0")
        self.environment = {}
        if libraries:
            self.environment = {"LD_PRELOAD": str(libraries[0]), "FAKETIME_TIMESTAMP_FILE": str(self.file),
                                "FAKETIME_NO_CACHE": "1", "FAKETIME_DONT_FAKE_MONOTONIC": "1"}
        else:
            say("left out: a clock set back (Debian: apt-get install faketime)")

    def set(self, offset):
        self.file.write_text(offset + "\n")


class Disk:
    """A file system of a given size that the run's folder lies on; an ordinary folder without root."""

    def __init__(self, folder, size_mib):
        self.folder = folder
        folder.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size_mib}m", "inkbench", folder],
                              capture_output=True, check=False)
        self.is_small = done.returncode == 0
        self.size_mib = size_mib
        if not self.is_small:
            say("left out: a full disk (mounting a file system needs root)")

    def resize(self, size_mib):
        subprocess.run(["mount", "-o", f"remount,size={size_mib}m", self.folder], check=True)

    def used_mib(self):
        return shutil.disk_usage(self.folder).used / 2**20

    def close(self):
        if self.is_small:
            subprocess.run(["umount", self.folder], check=False)


class LongRun:
    """The command, what was done to it, and what went wrong."""

    def __init__(self, program, experiment, out, log, environment=None):
        self.command = [program, "run", experiment, "--no-times", "--quiet", "--out", out]
        self.environment = {**os.environ, **(environment or {})}
        self.log = log
        self.faults = []
        self.kills = self.full_disks = self.clocks = self.refusals = 0

    def start(self):
        return subprocess.Popen(self.command, stdout=self.log, stderr=subprocess.STDOUT, env=self.environment)

    def is_computed(self):
        """Whether only the page is left to write, of which the folder is free already."""
        record = self.command[-1] / "run.toml"
        if not record.exists():
            return False
        return tomllib.loads(record.read_text(encoding="utf-8"))["progress"]["state"] != "unfinished"

    def has_all_blocks(self):
        """Whether every cell is computed, and tables and page are left to write."""
        blocks = self.command[-1] / "blocks"
        record = self.command[-1] / "run.toml"
        if not record.exists():
            return False
        wanted = tomllib.loads(record.read_text(encoding="utf-8"))["progress"]["blocks"]
        return self.is_computed() or (blocks.exists() and sum(1 for _ in blocks.iterdir()) >= wanted)

    def fault(self, text):
        say("FAULT: " + text)
        self.faults.append(text)

    def disturbances(self):
        return (f"{self.kills} kills, {self.full_disks} full disks, {self.clocks} clocks set back, "
                f"{self.refusals} second processes refused")


def watch(process, seconds, at_half=None, is_over=lambda: False):
    """Waits until the process has ended, the seconds are over or it says so; its memory every half second."""
    began = time.monotonic()
    samples = []
    while process.poll() is None and time.monotonic() - began < seconds:
        time.sleep(0.5)
        used_mib = memory_mib(process.pid)
        if is_over():
            break
        samples.append(used_mib)
        if at_half and time.monotonic() - began > seconds / 2:
            at_half()
            at_half = None
    return [s for s in samples if s > 0]


def kill(process):
    process.send_signal(signal.SIGKILL)
    process.wait()


def fill_disk(run, disk):
    """One stretch on a disk with a MiB left."""
    disk.resize(max(1, int(disk.used_mib()) + 1))
    process = run.start()
    watch(process, 600)
    if process.poll() is None:
        kill(process)
        run.fault("on a full disk the run went on for ten minutes")
    elif process.returncode == BAD_INPUT:
        run.full_disks += 1
    elif process.returncode not in (0, 3):  # so little was left that it fitted
        run.fault(f"on a full disk the run ended with {process.returncode}")
    disk.resize(disk.size_mib)


def begin_second(run, first):
    """A second process in the first one's folder: one of both must be refused, on a busy machine the one begun first."""
    second = run.start()
    began = time.monotonic()
    while first.poll() is None and second.poll() is None and time.monotonic() - began < 600:
        time.sleep(0.1)
    if second.poll() == BAD_INPUT:
        run.refusals += 1
        return
    if first.poll() == BAD_INPUT:
        run.refusals += 1
    elif second.poll() is None and first.poll() is None:
        run.fault("of two processes in one folder none was refused within ten minutes")
    elif not run.is_computed():
        run.fault(f"of two processes in one folder one ended with {first.poll()}, the other with {second.poll()}")
    if second.poll() is None:
        kill(second)
        run.kills += 1


def set_back(run, process, clock):
    """The clock of a run that computes."""
    clock.set("-2d")
    run.clocks += process.poll() is None


def disturb(run, chance, disk, clock, calm_seconds):
    """Stretches that end with a kill, until one comes to the end."""
    # Resumed so often that some ten kills fall on what is computed, and not all of it on the first stretches.
    longest = max(3.0, min(calm_seconds / 4, 240.0))
    turn = full_disks = 0
    while True:
        turn += 1
        if disk.is_small and full_disks < 2 and turn % 3 == 0:
            full_disks += 1
            fill_disk(run, disk)
            continue
        is_clock_turn = clock.environment and turn % 3 == 2
        clock.set("+0")
        process = run.start()
        if turn % 4 == 1:
            watch(process, 2)
            if process.poll() is None:
                begin_second(run, process)
            if process.poll() == BAD_INPUT:
                continue
        seconds = chance.uniform(1, longest)
        watch(process, seconds, (lambda: set_back(run, process, clock)) if is_clock_turn else None)
        if process.poll() is None:
            kill(process)
            run.kills += 1
            continue
        if process.returncode not in (0, 3):
            run.fault(f"the run ended with {process.returncode}")
        return


def compare_folders(expected, found):
    """Names of tables and pictures that differ, that are missing, and that are new."""
    names = {p.relative_to(expected) for p in expected.rglob("*") if p.is_file()}
    others = {p.relative_to(found) for p in found.rglob("*") if p.is_file()}
    compared = sorted(n for n in names & others if n.suffix in (".csv", ".png"))
    differing = [n for n in compared if not filecmp.cmp(expected / n, found / n, shallow=False)]
    return len(compared), differing, sorted(names - others), sorted(others - names)


def judge_equality(run, expected, found):
    """Names what differs between the folders; how many files were compared."""
    compared, *names = compare_folders(expected, found)
    for what, some in zip(("differs", "is missing", "is new"), names):
        for name in some[:20]:
            run.fault(f"{name} {what}")
    return compared


def judge_growth(run, samples):
    """Memory of the undisturbed run: its second half may not need more than its first, but for noise."""
    if len(samples) < 20:
        say("memory: the run is too short to tell")
        return
    half, fifth = len(samples) // 2, max(1, len(samples) // 5)
    first, last = max(samples[fifth:half]), max(samples[-fifth:])
    say(f"memory of the undisturbed run: at most {max(samples[:fifth]):.0f} MiB in its first fifth, {first:.0f} until its "
        f"middle, {last:.0f} in its last fifth")
    if last > first + max(GROWTH_MIB, GROWTH_SHARE * first):
        run.fault("memory grows")


def main():
    arguments = parse_arguments()
    folder = arguments.folder or Path(tempfile.mkdtemp(prefix="inkbench-long-"))
    folder.mkdir(parents=True, exist_ok=True)
    experiment = folder / "long.toml"
    scenes = small_scenes(arguments.program)
    sizes = max(1, round(arguments.cells / (len(scenes) * ROWS_PER_VIEW)))
    experiment.write_text(EXPERIMENT.format(scenes=", ".join(f'"{s}"' for s in scenes),
                                            sizes=", ".join(f'"{64 + 4 * i}x{36 + 2 * i}"' for i in range(sizes))))
    clock = Clock(folder)
    disk = Disk(folder / "disk", 4096)
    try:
        with open(folder / "log.txt", "w", encoding="utf-8") as log:
            say(f"{len(scenes)} scenes, {sizes} sizes: an undisturbed run")
            began = time.monotonic()
            calm = LongRun(arguments.program, experiment, folder / "calm", log)
            process = calm.start()
            samples = watch(process, 1e9, is_over=calm.has_all_blocks)
            at_end = watch(process, 1e9)
            if process.returncode not in (0, 3):
                sys.exit(f"long_run: the undisturbed run ended with {process.returncode}; see {folder / 'log.txt'}")
            seconds = time.monotonic() - began
            with open(folder / "calm/rows.csv", encoding="utf-8") as rows:
                count = sum(1 for _ in rows) - 1
            say(f"{count} rows in {seconds / 60:.0f} minutes; now disturbed ones for {arguments.minutes:g} minutes")
            run = LongRun(arguments.program, experiment, folder / "disk/run", log, clock.environment)
            judge_growth(run, samples)
            say(f"memory at most {max(at_end, default=0):.0f} MiB while tables and page of all rows were written")
            chance = random.Random(arguments.seed)
            end = time.monotonic() + 60 * arguments.minutes
            runs = compared = 0
            while runs == 0 or time.monotonic() < end:
                shutil.rmtree(folder / "disk/run", ignore_errors=True)
                disturb(run, chance, disk, clock, seconds)
                compared += judge_equality(run, folder / "calm", folder / "disk/run")
                runs += 1
                say(f"{runs} runs, {run.disturbances()}, {compared} tables and pictures compared")
                if run.faults:
                    break
        say("nothing lost, nothing twice" if not run.faults else f"{len(run.faults)} faults")
        return 1 if run.faults else 0
    finally:
        disk.close()
        if arguments.folder is None:
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
