#!/usr/bin/env python3
"""Test of standard streams that are closed or have no reader: streams.py PROGRAM

The program must write all its files, and its output must not go into a file.
"""

import filecmp
import os
import pty
import signal
import subprocess
import sys
import tempfile
import threading
import time

FILES = ["summary.json", "marginals.csv", "report.html", "joint.nc"]


def run(program, out, suffix):
    command = f'"{program}" epc case1 --order 6 --out "{out}" {suffix}'
    return subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=120)


def escapes_at_terminal(program, command, terminal, interrupted=False):
    """Numbers of escape sequences on standard output (a pipe) and standard error (a terminal)."""
    ours, theirs = pty.openpty()
    child = subprocess.Popen([program] + command, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=theirs,
                             env=os.environ | {"TERM": terminal})
    os.close(theirs)
    shown = []

    def read():
        try:
            while data := os.read(ours, 65536):
                shown.append(data)
        except OSError:  # Linux reports a closed peer of a pseudo-terminal by an error
            pass

    reader = threading.Thread(target=read)
    reader.start()
    if interrupted:
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
    printed = child.communicate(timeout=120)[0]
    reader.join()
    os.close(ours)
    return printed.count(b"\x1b"), b"".join(shown).count(b"\x1b")


def main():
    program = sys.argv[1]
    wrong = []

    def expect(condition, what):
        if not condition:
            wrong.append(what)

    with tempfile.TemporaryDirectory() as work:
        usual = os.path.join(work, "usual")
        piped = run(program, usual, "")
        expect(piped.returncode == 0, "the run with open streams failed")
        expect("\x1b" not in piped.stdout + piped.stderr, "escape sequences in a pipe")
        for name, suffix in {"closed": ">&- 2>&-", "all closed": "<&- >&- 2>&-",
                             "no reader": "| true", "head": "2>&1 | head -1",
                             "quiet": "-q >&- 2>&-"}.items():
            out = os.path.join(work, name.replace(" ", "_"))
            run(program, out, suffix)
            for file in FILES:
                place = os.path.join(out, file)
                expect(os.path.exists(place), f"{name}: no {file}")
            expect(filecmp.cmp(os.path.join(usual, "marginals.csv"),
                               os.path.join(out, "marginals.csv"), shallow=False),
                   f"{name}: marginals.csv differs")
            size = os.path.getsize(os.path.join(out, "figures", "case1.png"))
            expect(size > 1000, f"{name}: the figure has {size} bytes")
        few = ["--methods", "epc-gaussian-n4,epc-gaussian-n6", "--out"]
        commands = {"run": ["run", "case1"] + few,
                    "sweep": ["sweep", "case1", "--vary", "impulse.rate=1,2"] + few}
        for terminal in ["xterm", "dumb"]:
            for name, command in commands.items():
                printed, shown = escapes_at_terminal(
                    program, command + [os.path.join(work, name + terminal)], terminal)
                expect(printed == 0, f"{name}: escape sequences in a pipe")
                expect((shown > 0) == (terminal == "xterm"),
                       f"{name}: {shown} escape sequences at a terminal {terminal}")
            shown = escapes_at_terminal(program, ["reference", "case1"], terminal, True)[1]
            expect((shown > 0) == (terminal == "xterm"),
                   f"interrupted: {shown} escape sequences at a terminal {terminal}")
        quiet = subprocess.run([program, "epc", "case1", "--order", "8", "-q"],
                               capture_output=True, text=True, timeout=120)
        expect(quiet.returncode == 1, f"order 8 ended with {quiet.returncode}")
        expect(quiet.stdout == "", "a quiet run printed to standard output")
        expect(quiet.stderr.count("\n") == 1 and "epc-gaussian-n8" in quiet.stderr,
               f"a quiet failure printed {quiet.stderr!r}")
        refused = subprocess.run([program, "reference", "case1", "--time", "1e300"],
                                 capture_output=True, text=True, timeout=5)
        expect(refused.returncode == 2, f"--time 1e300 ended with {refused.returncode}")
    for problem in wrong:
        print("FAILED", problem)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
