"""Combines sweeps into a compact table, workflows/sweep/map/validity.csv: called by scripts/validity.

A row is a problem: its dimensionless groups, restitution coefficient, impulse law and mean amplitude relative to the
root of E[Y^2]. A cell for each method has L1, letter of the status and milliseconds. The last method is the reference;
its L1 is its error estimate (workflows/sweep/map/validity_map.hpp).
"""

import argparse
import csv
import json
import statistics
from pathlib import Path

from document_parts import replace_part

# Letters of statuses. The letter x is for a solution with status `ok` and an L1 above twice its error estimate plus the
# error estimate of the reference.
LETTERS = {
    "ok": "o",
    "inaccurate": "i",
    "inadmissible": "a",
    "not_converged": "n",
    "ill_posed": "p",
    "failed": "f",
    "not_offered": "u",
}
WORST = "ufpnaixo"  # from worst to best: a problem solved in several units of measurement gets its worst letter
GROUPS = ["impulses_per_decay_time", "damping_ratio", "cubic_share"]
PAIR = ("_y", "_ydot")
REFERENCE = "fd-kf"


def short(number, digits):
    """The number with so many digits in the fewest characters: .0042, 7.1e-05 and 310 with two digits."""
    text = f"{number:.{digits}g}"
    if "e+" in text:
        text = str(int(float(text)))
    return text[1:] if text.startswith("0.") else text


class MethodResult:
    """The result of a method at a point: larger L1 to the reference, letter of the status, milliseconds."""

    def __init__(self, row, reference):
        self.letter = LETTERS[row["status"]]
        self.milliseconds = 1000 * float(row["seconds"])
        is_reference = row["solution"] == row["reference"]
        kind = "error" if is_reference else "l1"
        numbers = [row[kind + suffix] for suffix in PAIR]
        self.l1 = max(map(float, numbers)) if all(numbers) else None
        if self.letter != "o" or is_reference or self.l1 is None:
            return
        stated = [row["error" + suffix] for suffix in PAIR]
        limits = [
            (2 * float(own) if own else 0.0) + float(reference["error" + suffix] or 0)
            for own, suffix in zip(stated, PAIR)
        ]
        if any(float(number) > limit for number, limit in zip(numbers, limits)):
            self.letter = "x"


def points_of(folder):
    """(key, answers) of each point of a sweep with a reference solution."""
    plan = json.loads((folder / "sweep.json").read_text())["plan"]
    case = plan["case"]
    points = {}
    varied = [axis["key"] for axis in plan["vary"]]
    with open(folder / "sweep.csv", newline="") as file:
        for row in csv.DictReader(file):
            points.setdefault(tuple(row[key] for key in varied), []).append(row)
    for values, rows in points.items():
        at = dict(zip(varied, values))
        if case["impulse"]["mean"] != 0 or "impulse.mean" in at:
            raise SystemExit(f"{folder}: impulses with a mean: the map has no such points; omit this sweep")
        if not rows[0][GROUPS[0]]:
            continue  # an invalid combination of values
        restitution = float(at.get("system.restitution", case["system"]["restitution"]))
        law = at.get("impulse.law", case["impulse"]["law"])
        key = (*(rows[0][group] for group in GROUPS), short(restitution, 4), law, "0")
        reference = next((row for row in rows if row["solution"] == row["reference"] == REFERENCE), None)
        if reference is None or not all(reference["error" + suffix] for suffix in PAIR):
            print(f"{folder}: no reference {REFERENCE} at {at}")
            continue
        yield key, {row["solution"]: MethodResult(row, reference) for row in rows}


def cell(answers):
    """The cell of a problem over its systems of units: worst letter, largest L1, median of the times."""
    if not answers:
        return ""
    letter = min((one.letter for one in answers), key=WORST.index)
    l1 = max((one.l1 for one in answers if one.l1 is not None), default=None)
    milliseconds = statistics.median(one.milliseconds for one in answers)
    return f"{'' if l1 is None else short(l1, 2)}{letter}{short(max(milliseconds, 1), 2)}"


def units_text(problems, methods):
    """Summary of the differences between problems that were solved in several units; they should be negligible."""
    several = [found for found in problems.values() if len(found) > 1]
    widest, apart, lettered = 0.0, "", []
    for found in several:
        for method in methods:
            answers = [one[method] for one in found if method in one]
            if len({one.letter for one in answers}) > 1:
                lettered.append(method)
            numbers = [one.l1 for one in answers if one.l1 is not None and one.letter in "oix"]
            if len(numbers) > 1 and max(numbers) - min(numbers) > widest:
                widest, apart = max(numbers) - min(numbers), method
    counts = sorted({(method, lettered.count(method)) for method in lettered})
    text = f"{sum(map(len, several))} points of the plans are {len(several)} problems in several units. "
    text += f"Between the units the error of a method differs by at most {widest:.1g} ({apart}), and " if several else ""
    text += "the statuses are equal." if not counts else ""
    if counts:
        text += "the statuses differ: " + ", ".join(f"`{m}` at {n}" for m, n in counts) + "."
    return text.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sweeps", nargs="+", type=Path)
    parser.add_argument("--out", required=True, type=Path)
    parser.add_argument("--document", type=Path)
    arguments = parser.parse_args()
    problems, methods = {}, []
    for folder in arguments.sweeps:
        for key, answers in points_of(folder):
            problems.setdefault(key, []).append(answers)
            methods += [method for method in answers if method not in methods]
    methods.sort(key=lambda method: (method.startswith("fd-"), method == REFERENCE))
    lines = [",".join([*GROUPS, "restitution", "law", "mean_share", *methods])]
    for key, found in sorted(problems.items(), key=lambda one: [one[0][4], *map(float, one[0][:4])]):
        cells = [cell([one[method] for one in found if method in one]) for method in methods]
        lines.append(",".join([*key, *cells]))
    text = "\n".join(lines) + "\n"
    arguments.out.write_text(text)
    print(f"{arguments.out}: {len(problems)} problems, {len(text) / 1000:.0f} kB")
    if arguments.document and arguments.document.exists():
        replace_part(arguments.document, "units", units_text(problems, methods))


main()
