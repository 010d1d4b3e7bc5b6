#!/usr/bin/env python3
"""Kills a run, or fills the disk, before each of its file operations. Afterwards the directory must hold
the earlier run, the new run or (without an earlier run) nothing, but never files of both.

    at_each_file_operation.py PROGRAM LIBRARY [--all] [--verbose]

Without --all, tests a part of the operations.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FILES = ["summary.json", "marginals.csv", "joint.nc", "report.html"]
# Step from one tested operation to the next without --all, by fault and existence of an earlier run.
STRIDES = {("kill", True): 2, ("kill", False): 8, ("full", True): 5, ("full", False): 10}


# The environment has no gnuplot: figures are drawn after the files of the run. Options of sanitizers are
# kept.
BARE = {"PATH": "/nowhere",
        **{name: value for name, value in os.environ.items() if name.endswith("SAN_OPTIONS")}}


# The fastest solution; all solving commands write the same files in the same way.
def run(program, directory, restitution, **environment):
    return subprocess.run(
        [program, "mcs", "case1", "--time", "1e4", "--accuracy", "1", "--streams", "16", "--quiet",
         "--out", str(directory), "--set", f"system.restitution={restitution}"],
        env={**BARE, **environment}, capture_output=True, text=True, timeout=60)


def names(directory):
    return sorted(path.name for path in directory.iterdir()) if directory.exists() else []


def state(program, directory):
    """'old', 'new' or 'none': the run that the program reads in the directory."""
    report = subprocess.run([program, "report", str(directory)], env=BARE, capture_output=True,
                            text=True, timeout=60)
    if report.returncode != 0:
        if "no run in" in report.stderr and not any(name in FILES for name in names(directory)):
            return "none"
        raise SystemExit(f"partial run in {directory}: {report.stderr}")
    summary = json.loads((directory / "summary.json").read_text())
    restitution = summary["cases"][0]["system"]["restitution"]
    # The reader must have removed all temporary files of the writer.
    for name in names(directory):
        if "commit" in name and "partial" not in name:
            raise SystemExit(f"{name} is left in {directory}")
    return "old" if restitution == 0.98 else "new"


def main(program, library, every, verbose):
    base = pathlib.Path(tempfile.mkdtemp(prefix="fpkcheck-faults-"))
    before = base / "before"
    assert run(program, before, 0.98).returncode in (0, 1)
    count = base / "count"
    run(program, base / "counted", 0.9, LD_PRELOAD=library, FAULT="kill",
        FAULT_COUNT=str(count))
    last = int(count.read_text())
    assert last > 20, last
    total = {}
    for fault in ("kill", "full"):
        for there in (True, False):
            seen = []
            stride = 1 if every else STRIDES[fault, there]
            for number in range(1, last + 1, stride):
                directory = base / "run"
                shutil.rmtree(directory, ignore_errors=True)
                if there:
                    shutil.copytree(before, directory)
                done = run(program, directory, 0.9, LD_PRELOAD=library, FAULT=fault,
                           FAULT_AT=str(number))
                if fault == "kill" and done.returncode >= 0:
                    break  # fewer operations are needed to replace a run
                found = state(program, directory)
                assert found != ("none" if there else "old"), (fault, number, found)
                if fault == "full":
                    if done.returncode < 0 or len(done.stderr.splitlines()) > 2:
                        raise SystemExit(f"full disk at {number}: {done.returncode} {done.stderr}")
                    if done.returncode == 0 and found != "new":
                        raise SystemExit(f"full disk at {number}: no error message, {found}")
                seen.append(found)
                if verbose:
                    print(fault, there, number, found, done.returncode, done.stderr.strip()[:150])
            # The faults cover both sides of the operation that publishes the new run.
            assert "new" in seen and ("old" in seen or "none" in seen), (fault, there, seen)
            assert seen == sorted(seen, key=lambda each: each == "new"), (fault, there, seen)
            total[fault, there] = len(seen)
    shutil.rmtree(base)
    print("operations:", ", ".join(f"{fault}, {'over a run' if there else 'alone'}: {count}"
                                for (fault, there), count in total.items()))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], "--all" in sys.argv, "--verbose" in sys.argv)
