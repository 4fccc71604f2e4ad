"""Small runs by the built program, for tests of what is drawn from them."""

import os
import subprocess

PROGRAM = os.environ["INKBENCH"]
METHODS = "mote4,mote4_tuned,mote16,decaudin,ids,jump_flood,edge_hash,edge_list"
_SMALL = ["--size", "160x90", "--quiet"]
COMMANDS = {
    "compare": ["compare", "--scenes", "cube,tiles", "--methods", METHODS, "--repetitions", "2",
                "--views", "2"],
    "seven": ["compare", "--scenes", "cube,tiles,torus,blocks,gear,gem,hills", "--methods",
              "mote4,surface8,id_lookup,roberts", "--repetitions", "2", "--views", "1", "--no-sweep",
              "--no-crosscheck", "--images", "none"],
    "ink": ["compare", "--scenes", "cube,tiles,torus,blocks,gear,gem,hills", "--methods", "strokes,chords,id_lookup,surface8",
            "--repetitions", "2", "--views", "1", "--no-sweep", "--no-crosscheck"],
    "stress": ["stress", "--methods", "mote4,ids", "--axes", "grazing,threads", "--points", "3"],
}


def make(name, folder):
    """Makes the run `name` in `folder`/`name` unless it is there; returns that folder."""
    out = os.path.join(folder, name)
    if not os.path.exists(os.path.join(out, "rows.csv")):
        done = subprocess.run([PROGRAM, *COMMANDS[name], *_SMALL, "--out", out], text=True,
                              capture_output=True, cwd=os.environ["INKBENCH_SOURCE"])
        if done.returncode not in (0, 3):
            raise RuntimeError(f"inkbench {COMMANDS[name]}: {done.stderr}")
    return out
