#!/usr/bin/env python3
"""Test of SIGINT and SIGTERM at random times: signals.py PROGRAM [--rounds N] [--within S] [--seed K]
[--commands A,B] [--part F]

Starts every command of fpkcheck and sends SIGINT or SIGTERM at a random time in its first seconds.
The command must end in time, with the right exit code and one line on standard error, and must
leave no partial files.
"""

import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

# Arguments of each command, and the seconds within which the signal is sent. The problems have long
# single steps: many impulses (burn-in), large grids (factorisation), several cases.
COMMANDS = {
    "run": (["run", "case1", "case4", "--out", "OUT"], 12),
    "paper": (["paper", "--out", "OUT"], 12),
    "epc": (["epc", "case4", "--formulation", "moment", "--order", "12", "--out", "OUT"], 1.5),
    "fd": (["fd", "case4", "--refinement", "3", "--stepper", "direct", "--out", "OUT"], 4),
    "fd-characteristics": (
        ["fd", "case1", "--transport", "characteristics", "--refinement", "2", "--out", "OUT"], 4),
    "fd-until": (["fd", "case1", "--until", "20", "--refinement", "2", "--out", "OUT"], 4),
    "mcs": (["mcs", "case1", "--time", "1e9", "--out", "OUT"], 3),
    "mcs-burn-in": (["mcs", "case1", "--set", "impulse.rate=1e5", "--out", "OUT"], 3),
    "mcs-controlled": (["mcs", "case1", "--controlled", "--out", "OUT"], 4),
    "bounds": (["bounds", "case1", "--width", "1e-12", "--seconds", "60", "--out", "OUT"], 4),
    "study-grid": (["study", "grid", "case4", "--out", "OUT"], 5),
    "study-order": (["study", "order", "case4", "--out", "OUT"], 4),
    "study-regularisation": (["study", "regularisation", "case1", "--out", "OUT"], 4),
    "reference": (["reference", "case1", "--out", "OUT"], 5),
    "sweep": (["sweep", "case1", "--vary", "system.restitution=0.8:1:20", "--methods", "epc,fd-kf",
               "--out", "OUT"], 4),
    "check": (["check", "BASELINES/case1/summary.json", "--out", "OUT"], 4),
    "report": (["report", "SAVED"], 0.3),
    "evaluate": (["evaluate", "SAVED", "epc-gaussian-n6", "--at", "-"], 0.5),  # waits for points
}


def file_defect(out):
    """The defect of the files in a directory, as text; None without a defect."""
    names = [os.path.join(place, name) for place, _, files in os.walk(out) for name in files]
    partial = [name for name in names if ".partial-" in name]
    if partial:
        return f"partial files: {partial}"
    empty = [name for name in names if os.path.getsize(name) == 0]
    if empty:
        return f"empty files: {empty}"
    if os.path.isdir(out) and not names:
        return "an empty directory"
    return None


def send_signal(program, command, arguments, number, moment, saved, baselines):
    """Seconds from the signal to the end, exit code, list of failures, standard error."""
    with tempfile.TemporaryDirectory() as work:
        out = os.path.join(work, "out")
        if "SAVED" in arguments:
            shutil.copytree(saved, out)
        filled = [argument.replace("OUT", out).replace("SAVED", out)
                  .replace("BASELINES", baselines) for argument in arguments]
        # Standard input without data, which stays open until the program ends.
        reading, writing = os.pipe()
        process = subprocess.Popen([program, *filled], stdin=reading, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        os.close(reading)
        time.sleep(moment)
        early = process.poll() is not None
        begin = time.monotonic()
        if not early:
            process.send_signal(number)
        try:
            _, said = process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return 60.0, None, ["the program did not end within a minute"], ""
        finally:
            os.close(writing)
        seconds = time.monotonic() - begin
        wrong = []
        if early:
            return None, process.returncode, wrong, said
        # Before the handlers are installed and after the result, a signal has the default action.
        if process.returncode not in (128 + number, -number, 0):
            wrong.append(f"exit code {process.returncode} after {signal.Signals(number).name}")
        if process.returncode == -number and moment > 1:
            wrong.append("the signal was not handled")
        if process.returncode == 128 + number and said.count("\n") != 1 and command != "reference":
            wrong.append(f"standard error is {said!r}")
        problem = file_defect(out)
        if problem:
            wrong.append(problem)
        return seconds, process.returncode, wrong, said


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--within", type=float, default=1.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--part", type=float, default=1.0,
                        help="fraction of the time span of the signals, from its beginning")
    parser.add_argument("--commands", default=",".join(COMMANDS))
    given = parser.parse_args()
    baselines = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "baselines")
    chance = random.Random(given.seed)
    failed = 0
    with tempfile.TemporaryDirectory() as work:
        saved = os.path.join(work, "saved")
        commands = given.commands.split(",")
        if any("SAVED" in COMMANDS[command][0] for command in commands):
            subprocess.run([given.program, "epc", "case1", "--order", "6", "--out", saved, "-q"],
                           check=True)
        for command in commands:
            arguments, span = COMMANDS[command]
            times = []
            for _ in range(given.rounds):
                number = chance.choice([signal.SIGINT, signal.SIGTERM])
                moment = chance.uniform(0.02, given.part * span)
                seconds, code, wrong, said = send_signal(given.program, command, arguments, number, moment,
                                                 saved, baselines)
                if seconds is not None:
                    times.append(seconds)
                    if seconds > given.within:
                        wrong.append(f"shutdown took {seconds:.2f} s")
                for problem in wrong:
                    failed += 1
                    print(f"FAILED {command}, {signal.Signals(number).name} at {moment:.2f} s: "
                          f"{problem}", flush=True)
            worst = f"{max(times):.2f}" if times else "-"
            median = f"{sorted(times)[len(times) // 2]:.2f}" if times else "-"
            print(f"{command:22} {len(times):3} of {given.rounds:3} stopped, "
                  f"median {median} s, longest {worst} s", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
