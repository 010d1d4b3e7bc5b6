#!/usr/bin/env python3
"""A sweep killed at random moments and started again: kills.py PROGRAM [--rounds N] [--seed K]

Starts a sweep, ends it by SIGKILL, SIGTERM or SIGINT at a random moment, and repeats the command
until it succeeds. Asserts that the table equals that of an uninterrupted sweep except for the times,
and that no temporary files remain.
"""

import argparse
import csv
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

SWEEP = ["sweep", "case1", "--vary", "system.restitution=0.8:0.99:12", "--vary",
         "system.cubic=0.1:1:12", "--methods", "epc-gaussian-n4,epc-gaussian-n6", "--accuracy",
         "auto", "--quiet"]
SIGNALS = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT]
STOPPED = {signal.SIGKILL: -signal.SIGKILL, signal.SIGTERM: 143, signal.SIGINT: 130}


def table(directory):
    with open(os.path.join(directory, "sweep.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        del row["seconds"]
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=4)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    rng = random.Random(given.seed)
    failures, in_time = [], 0
    with tempfile.TemporaryDirectory() as work:
        whole = os.path.join(work, "whole")
        begin = time.monotonic()
        subprocess.run([given.program, *SWEEP, "--out", whole], check=True)
        seconds = time.monotonic() - begin
        expected = table(whole)
        for number in range(given.rounds):
            out = os.path.join(work, str(number))
            with_what = SIGNALS[number % len(SIGNALS)]
            process = subprocess.Popen([given.program, *SWEEP, "--out", out],
                                       stderr=subprocess.PIPE, text=True)
            time.sleep(rng.uniform(0, 0.9 * seconds))
            process.send_signal(with_what)
            _, said = process.communicate(timeout=60)
            if process.returncode == 0:
                continue  # finished before the signal
            in_time += 1
            if process.returncode not in (STOPPED[with_what], -with_what):
                failures.append(f"round {number}: exit code {process.returncode}: {said}")
            # At most the points in progress are solved again; points in the journal are not.
            journal = os.path.join(out, "journal")
            before = open(journal).read().splitlines() if os.path.exists(journal) else []
            subprocess.run([given.program, *SWEEP, "--out", out], check=True,
                           stderr=subprocess.DEVNULL)
            after = open(journal).read().splitlines()
            sure = before[:-1]  # the last line may be incomplete
            if after[:len(sure)] != sure:
                failures.append(f"round {number}: the journal lost lines")
            if table(out) != expected:
                failures.append(f"round {number}: the table differs")
            names = sorted(os.listdir(out))
            if [name for name in names if "partial" in name or name.startswith(".")]:
                failures.append(f"round {number}: left behind: {names}")
    for failure in failures:
        print(failure)
    print(f"{in_time} of {given.rounds} were stopped before their end; {len(failures)} failures")
    return 1 if failures or in_time == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
