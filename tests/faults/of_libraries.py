#!/usr/bin/env python3
"""Makes functions of SUNDIALS, KLU and CHOLMOD, and the allocation of memory, fail. The program must
report the failure by a status or a message; it must not crash, hang, or give a wrong solution the status ok.

    of_libraries.py PROGRAM LIBRARY [--all] [--verbose]

Without --all, tests a part of the commands, and memory failures at a few calls.
"""

import json
import os
import subprocess
import sys
import tempfile

COMMANDS = {
    "fd": ["fd", "case1", "--max-seconds", "3"],
    "direct": ["fd", "case1", "--stepper", "direct"],
    "characteristics": ["fd", "case1", "--set", "system.restitution=0.3", "--set",
                        "impulse.rate=0.05"],
    "transient": ["fd", "case1", "--until", "3", "--snapshots", "3"],
    "epc": ["epc", "case1", "--formulation", "moment", "--order", "4"],
    "bounds": ["bounds", "case1", "--seconds", "1"],
    "mcs": ["mcs", "case1", "--time", "2e4", "--accuracy", "1"],
    "controlled": ["mcs", "case1", "--controlled", "--time", "2e4"],
    "run": ["run", "case1", "--methods", "epc-moment-n4,fd-kf,mcs", "--time", "2e4"],
}
KLU = ["klu_analyze", "klu_analyze_given", "klu_factor", "klu_refactor", "klu_solve",
       "klu_rgrowth", "cholmod_start", "cholmod_nested_dissection"]
CVODE = ["CVodeCreate", "CVodeInit", "CVodeSetLinearSolver", "CVodeSetJacTimes",
         "CVodeSetPreconditioner", "CVode"]
GMRES = ["SUNLinSol_SPGMR", "SUNLinSolInitialize", "SUNLinSolSetup", "SUNLinSolSolve"]
FUNCTIONS = {"fd": KLU + CVODE + GMRES, "direct": KLU + GMRES, "characteristics": GMRES,
             "transient": KLU + CVODE + GMRES, "bounds": KLU, "controlled": KLU, "run": KLU + CVODE + GMRES}
FEW = ["fd", "characteristics"]
LONGEST = 90  # time limit of a run in seconds, to detect hangs


def run(program, command, **environment):
    # With arenas of threads, small allocations would also fail as parts of large blocks.
    return subprocess.run([program, *command, "--json"], capture_output=True, text=True,
                          timeout=LONGEST, env=os.environ | {"MALLOC_ARENA_MAX": "1"} | environment)


def ok_moments(done):
    """{id: moments} of the solutions with status ok."""
    try:
        summary = json.loads(done.stdout)
    except json.JSONDecodeError:
        return {}
    return {s["id"]: s["moments"] for case in summary.get("cases", [])
            for s in case["solutions"] if s["status"] == "ok"}


def reasons(done):
    """The reasons of the solutions without status ok."""
    try:
        summary = json.loads(done.stdout)
    except json.JSONDecodeError:
        return []
    return [s["reason"] for case in summary.get("cases", []) for s in case["solutions"]
            if s["status"] != "ok" and s["reason"]] or summary.get("reason", [])


def defect(done, true):
    """The defect of a run with a fault, or an empty text."""
    # METIS aborts the program with a message when an allocation in METIS fails, although CHOLMOD
    # tested the available memory before. The program cannot catch this.
    if done.returncode == -6 and "***Memory" in done.stderr:
        return ""
    if done.returncode < 0 or done.returncode > 128:
        return f"ended by signal {-done.returncode}"
    lines = done.stderr.splitlines()
    if done.returncode != 0 and not lines and not reasons(done):
        return "no message and no reason"
    if len(lines) > 6 or any(len(line) > 600 for line in lines):
        return f"message of {len(lines)} lines"
    for solution, moments in ok_moments(done).items():
        for name, value in moments.items():
            was = true.get(solution, moments)[name]
            # Less time or fewer grids may change a solution within the accuracy of status ok.
            if value is not None and abs(value - was) > 2e-2 * abs(was) + 1e-3:
                return f"{solution} is ok with {name} = {value} instead of {was}"
    return ""


def main(program, library, every, verbose):
    directory = tempfile.mkdtemp(prefix="fpkcheck-faults-")
    count = os.path.join(directory, "count")
    findings, tried = [], 0
    for name, command in COMMANDS.items():
        if not every and name not in FEW:
            continue
        plain = run(program, command)
        if plain.returncode > 1:
            sys.exit(f"{' '.join(command)}: fails without a fault: {plain.stderr.strip()}")
        true = ok_moments(plain)
        for function in [*FUNCTIONS.get(name, []), "malloc"]:
            faulty = {"LD_PRELOAD": library, "FAULT_FUNCTION": function}
            numbers, calls = [1, 30, 300] if function == "malloc" else [1], "?"
            if every:
                run(program, command, FAULT_COUNT=count, **faulty)
                with open(count) as file:
                    calls = int(file.read())
                parts = 24 if function == "malloc" else 3
                numbers = sorted({1 + (calls - 1) * k // (parts - 1)
                                  for k in range(parts)}) if calls else []
            for number in numbers:
                done = run(program, command, FAULT_AT=str(number), **faulty)
                found = defect(done, true)
                tried += 1
                if verbose or found:
                    print(f"{name}: {function} from call {number} of {calls}: "
                          f"{done.returncode} {found} {done.stderr.strip()[:300]}", flush=True)
                if found:
                    findings.append((name, function, number))
    print(f"{tried} faults, {len(findings)} findings")
    sys.exit(1 if findings else 0)


main(sys.argv[1], sys.argv[2], "--all" in sys.argv, "--verbose" in sys.argv)
