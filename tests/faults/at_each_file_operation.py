#!/usr/bin/env python3
"""Stops a run before each thing that it does to a file: afterwards its directory holds the run of
before, the new one or (where there was none) nothing, and never some files of both.

    at_each_file_operation.py PROGRAM LIBRARY [--all] [--verbose]

Without --all, at a part of them.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FILES = ["summary.json", "marginals.csv", "joint.nc", "report.html"]
# Of the things that it does, one of so many, by the fault and by whether there was a run.
STRIDES = {("kill", True): 2, ("kill", False): 8, ("full", True): 5, ("full", False): 10}


# Without gnuplot: pictures come after the run and are drawn again from it. What is said to sanitizers
# goes on to them.
BARE = {"PATH": "/nowhere",
        **{name: value for name, value in os.environ.items() if name.endswith("SAN_OPTIONS")}}


# What is solved in the shortest time: every command that solves writes the same files in the same way.
def run(program, directory, restitution, **environment):
    return subprocess.run(
        [program, "mcs", "case1", "--time", "1e4", "--accuracy", "1", "--streams", "16", "--quiet",
         "--out", str(directory), "--set", f"system.restitution={restitution}"],
        env={**BARE, **environment}, capture_output=True, text=True, timeout=60)


def names(directory):
    return sorted(path.name for path in directory.iterdir()) if directory.exists() else []


def state(program, directory):
    """'old', 'new' or 'none', by what the program itself reads there."""
    report = subprocess.run([program, "report", str(directory)], env=BARE, capture_output=True,
                            text=True, timeout=60)
    if report.returncode != 0:
        if "no run in" in report.stderr and not any(name in FILES for name in names(directory)):
            return "none"
        raise SystemExit(f"neither a run nor none in {directory}: {report.stderr}")
    summary = json.loads((directory / "summary.json").read_text())
    restitution = summary["cases"][0]["system"]["restitution"]
    # Finished and read, it has no left-overs of the writing.
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
                    break  # over a run there is less to make
                found = state(program, directory)
                assert found != ("none" if there else "old"), (fault, number, found)
                if fault == "full":
                    if done.returncode < 0 or len(done.stderr.splitlines()) > 2:
                        raise SystemExit(f"full disk at {number}: {done.returncode} {done.stderr}")
                    if done.returncode == 0 and found != "new":
                        raise SystemExit(f"full disk at {number}: said nothing, {found}")
                seen.append(found)
                if verbose:
                    print(fault, there, number, found, done.returncode, done.stderr.strip()[:150])
            # Both sides of the moment at which the new run is there were met.
            assert "new" in seen and ("old" in seen or "none" in seen), (fault, there, seen)
            assert seen == sorted(seen, key=lambda each: each == "new"), (fault, there, seen)
            total[fault, there] = len(seen)
    shutil.rmtree(base)
    print("moments:", ", ".join(f"{fault}, {'over a run' if there else 'alone'}: {count}"
                                for (fault, there), count in total.items()))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], "--all" in sys.argv, "--verbose" in sys.argv)
