"""A run over a real Slurm of one node: shares, one killed with -9, submitted again, merged.

    slurm_test.py PROGRAM SOURCE

Starts munged, slurmctld and slurmd in a folder of their own, without systemd, and computes
experiments/smoke.toml through experiments/slurm.sh and through experiments/Snakefile. The tables must
be those of one undisturbed run, byte for byte. Exit code 77 (skipped) says what is missing: it needs
root, a machine on which Slurm starts, and Debian's munge, slurmctld, slurmd, slurm-client; the Snakefile needs snakemake.
"""

import filecmp
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SKIPPED = 77
ARGUMENTS = "--size 960x540 --no-times"
SHARES = 3


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def check(is_so, what):
    if not is_so:
        sys.exit(f"slurm: {what}")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(is_there, what, seconds=120):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = is_there()
        if found:
            return found
        time.sleep(0.01)
    return sys.exit(f"slurm: waited {seconds} s for {what}")


class Slurm:
    """One controller and one node, both of this machine; gone when it is closed."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        host = socket.gethostname().split(".")[0]
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "cgroup.conf").write_text("")
        (folder / "slurm.conf").write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0
MinJobAge=300
ReturnToService=2
MpiDefault=none
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} RealMemory=64000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
""")
        self.env = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        self.start("munged", "--foreground", "--force", f"--key-file={key}",
                   f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
                   f"--log-file={folder}/munged.log", f"--seed-file={folder}/munged.seed")
        wait_for((folder / "munge.socket").exists, "munged")
        self.start("slurmctld", "-D", "-i", "-f", folder / "slurm.conf")
        self.start("slurmd", "-D", "-N", host, "-f", folder / "slurm.conf")
        for _ in range(600):
            if "idle" in self.run("sinfo", "-h", "-o", "%T", is_checked=False) and self.runs_a_job():
                return
            time.sleep(0.1)
        self.close()
        logs = [p.read_text(errors="replace")[-300:] for p in sorted(folder.glob("slurm*.out"))]
        skip("Slurm itself does not start here: " + " / ".join(logs))

    def runs_a_job(self):
        """Whether a job that only writes a file comes to its end."""
        done = self.folder / "done"
        self.run("sbatch", "--output=/dev/null", "--wrap", f"touch {done}", is_checked=False)
        for _ in range(300):
            if done.exists() and not self.jobs():
                return True
            time.sleep(0.1)
        return False

    def start(self, *words):
        log = open(self.folder / f"{words[0]}.out", "wb")
        self.daemons.append(subprocess.Popen([str(w) for w in words], env=self.env, stdout=log,
                                             stderr=log, stdin=subprocess.DEVNULL))

    def run(self, *words, is_checked=True, **more):
        done = subprocess.run([str(w) for w in words], env={**self.env, **more}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        check(not is_checked or done.returncode == 0,
              f"{' '.join(map(str, words))}: exit code {done.returncode}\n{done.stdout}")
        return done.stdout

    def jobs(self):
        return self.run("squeue", "-h", "-o", "%i %T").split("\n")[:-1]

    def close(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()


def share_process(program, share):
    """The process id of a share that is at work, or None."""
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if words[0] == str(program).encode() and f"{share}/{SHARES}".encode() in words:
            return int(entry.name)
    return None


def check_same(reference, run):
    """All tables and images, byte for byte; run.toml says how long it took."""
    names = sorted(p.relative_to(reference) for p in reference.rglob("*")
                   if p.is_file() and p.suffix in (".csv", ".png"))
    check(len(names) > 20, f"the reference has only {len(names)} files")
    for name in names:
        check((run / name).is_file(), f"{name} is missing in {run}")
        check(filecmp.cmp(reference / name, run / name, shallow=False), f"{name} differs in {run}")


def through_script(slurm, program, source, desk):
    """Three shares; the second is killed with -9 at work, then submitted again."""
    env = {"INKBENCH": str(program), "INKBENCH_ARGS": ARGUMENTS}
    words = [source / "experiments/slurm.sh", source / "experiments/smoke.toml", SHARES, desk / "out"]
    slurm.run(*words, **env)
    blocks = desk / "out.parts" / "2-of-3" / "blocks"
    wait_for(lambda: blocks.is_dir() and any(blocks.iterdir()), "a block of the second share")
    victim = share_process(program, 2)
    check(victim, "the second share ended before it could be killed: give it more to do")
    os.kill(victim, signal.SIGKILL)
    wait_for(lambda: not slurm.jobs(), "the jobs to end")
    check(not (desk / "out" / "run.toml").exists(), "it was merged without the killed share")
    status = slurm.run(program, "run", source / "experiments/smoke.toml", "--status", "--out",
                       desk / "out", *ARGUMENTS.split())
    check("blocks are done" in status and "2-of-3: " in status, f"--status says {status}")
    said = slurm.run(program, "merge", "--partial", *sorted((desk / "out.parts").glob("*-of-*")),
                     "--out", desk / "partial", is_checked=False)
    check((desk / "partial" / "rows.csv").is_file(), f"there are no tables of a partial run:\n{said}")
    slurm.run(*words, TASKS="2", **env)
    wait_for(lambda: not slurm.jobs(), "the second submission to end")
    logs = "".join(p.read_text() for p in (desk / "out.parts").glob("*.log"))
    check((desk / "out" / "run.toml").exists(), f"it was not merged:\n{logs}")


def through_snakemake(slurm, program, source, desk):
    profile = source / "experiments/profiles/slurm7"
    slurm.run("snakemake", "-s", source / "experiments/Snakefile", "--profile", profile,
              "--directory", desk, "--jobs", "2", "--latency-wait", "5", "--set-threads", "share=1",
              "--config",
              f"experiment={source}/experiments/smoke.toml", f"shares={SHARES}",
              f"out={desk}/snake", f"inkbench={program}", f"arguments={ARGUMENTS}",
              HOME=str(desk))


def main():
    check(len(sys.argv) == 3, __doc__)
    program, source = (Path(word).resolve() for word in sys.argv[1:])
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name)]
    if missing:
        skip(f"{', '.join(missing)} not installed (Debian: munge slurmctld slurmd slurm-client)")
    if os.geteuid() != 0:
        skip("Slurm's daemons need root here")
    with tempfile.TemporaryDirectory(prefix="inkbench-slurm-") as name:
        desk = Path(name)
        os.environ["XDG_CACHE_HOME"] = str(desk / "cache")
        (desk / "slurm").mkdir()
        subprocess.run([program, "run", source / "experiments/smoke.toml", *ARGUMENTS.split(), "--quiet",
                        "--out", desk / "one"], check=True, stdout=subprocess.DEVNULL)
        slurm = Slurm(desk / "slurm")
        try:
            through_script(slurm, program, source, desk)
            check_same(desk / "one", desk / "out")
            print("slurm.sh: killed, submitted again, merged: the bytes of one run")
            if shutil.which("snakemake"):
                through_snakemake(slurm, program, source, desk)
                check_same(desk / "one", desk / "snake")
                print("Snakefile: the bytes of one run")
            else:
                print("snakemake is not installed: the Snakefile was not tried")
        finally:
            slurm.close()


if __name__ == "__main__":
    main()
