"""Makes the tables of docs/validity.md from workflows/sweep/map/validity.csv: called by scripts/validity.

Within 1 %: a solution with a density, `ok` or `inaccurate`, whose L1 of p(y) and of p(y') is below 0.01.
"""

import argparse
import csv
import math
import re
import statistics
from pathlib import Path

from document_parts import replace_part

LIMITS = (0.01, 0.05)
# Definition of a bound: this fraction of the points above it is within the limit, and at least so many points exist.
SHARE, FEWEST = 0.95, 4
IMPULSES = ((0, 1), (1, 2), (2, 3), (3, 10), (10, 30), (30, 100), (100, float("inf")))
CUBIC = ((0, 0.01), (0.01, 0.1), (0.1, 0.4), (0.4, 0.7), (0.7, 0.9), (0.9, 1))
LAWS = ("gaussian", "laplace", "two_point", "uniform")
CELL = re.compile(r"(?P<l1>[\d.]+(?:e-\d+)?)?(?P<letter>[oxianpfu])(?P<milliseconds>[\d.]+)$")


class MethodResult:
    def __init__(self, cell):
        found = CELL.match(cell)
        if not found:
            raise SystemExit(f"{cell}: not a cell of the map")
        self.letter = found["letter"]
        self.seconds = float(found["milliseconds"]) / 1000
        self.l1 = float(found["l1"]) if found["l1"] else None
        self.is_density = self.letter in "oxi" and self.l1 is not None

    def within(self, limit):
        return self.is_density and self.l1 < limit


class Point:
    def __init__(self, row, methods):
        self.impulses = float(row["impulses_per_decay_time"])
        self.restitution = float(row["restitution"])
        self.cubic = float(row["cubic_share"])
        self.law = row["law"]
        self.damping_ratio = float(row["damping_ratio"])
        self.answers = {method: MethodResult(row[method]) for method in methods if row[method]}


    def rate(self):
        """Impulses in the time 1/c. The damping of equivalent linearisation is c + 2 (1-r) sqrt(k) / pi."""
        return self.impulses / 2 * (1 + (1 - self.restitution) / (math.pi * self.damping_ratio))

    def distance(self, other):
        """As validity_map_distance() in workflows/sweep/map/validity_map.cpp computes it."""
        if self.law != other.law:
            return math.inf
        return math.hypot(
            math.log(self.impulses / other.impulses),
            math.log(self.damping_ratio / other.damping_ratio),
            (self.restitution - other.restitution) / 0.1,
            (self.cubic - other.cubic) / 0.2,
        )


def table(header, rows):
    """A text table with aligned columns, the first one to the left."""
    cells = [header, *rows]
    widths = [max(len(row[k]) for row in cells) for k in range(len(header))]
    lines = []
    for row in cells:
        line = [row[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(row[1:], widths[1:]))]
        lines.append("  ".join(line).rstrip())
    return "```\n" + "\n".join(lines) + "\n```"


def methods_table(points, methods):
    rows = []
    for method in methods:
        answers = [point.answers[method] for point in points if method in point.answers]
        letters = [one.letter for one in answers]
        fine = [one.l1 for one in answers if one.letter in "ox"]
        others = [(letter, letters.count(letter)) for letter in "anpfu" if letter in letters]
        rows.append(
            [
                method,
                str(len(answers)),
                *(str(sum(one.within(limit) for one in answers)) for limit in LIMITS),
                str(len(fine)),
                str(sum(l1 >= LIMITS[0] for l1 in fine)),
                str(letters.count("x")),
                f"{max(fine):.2g}" if fine else "-",
                ", ".join(f"{count} {letter}" for letter, count in others) or "-",
                f"{statistics.median(one.seconds for one in answers):.2g}",
            ]
        )
    header = ["method", "points", "< 1 %", "< 5 %", "ok", "ok, > 1 %", "ok, > 2 stated", "worst ok", "none", "seconds"]
    return table(header, rows)


def bound(pairs, limit):
    """The smallest x such that the fraction SHARE of the points at x and above is within the limit, or None."""
    found, within = None, 0
    for count, (x, answer) in enumerate(sorted(pairs, key=lambda pair: -pair[0]), 1):
        within += answer.within(limit)
        if answer.within(limit) and count >= FEWEST and within >= SHARE * count:
            found = x
    return found


def bounds_cell(pairs, written):
    """The bounds for both limits: "-" without a bound, "?" with too few points."""
    if len(pairs) < FEWEST:
        return "?"
    bounds = [bound(pairs, limit) for limit in LIMITS]
    if bounds == [None, None]:
        return "-"
    return " ".join("-" if one is None else written(one) for one in bounds)


def restitution_text(number):
    return f"{number:.2f}".replace("0.", ".", 1)


def rate_text(number):
    return f"{number:.2g}" if number < 10 else f"{number:.0f}"


def range_text(low, high):
    if low == 0:
        return f"< {high:g}"
    return f"> {low:g}" if high == float("inf") else f"{low:g} .. {high:g}"


def restitution_table(points, methods):
    points = [point for point in points if point.law == "gaussian"]
    rows = []
    for method in methods:
        row = [method]
        for low, high in IMPULSES:
            inside = [
                (point.restitution, point.answers[method])
                for point in points
                if low <= point.impulses < high and method in point.answers
            ]
            row.append(bounds_cell(inside, restitution_text))
        rows.append(row)
    return table(["impulses per decay time", *(range_text(*one) for one in IMPULSES)], rows)


def cubic_table(points, methods):
    points = [p for p in points if p.law == "gaussian" and p.restitution == 0.98 and abs(p.rate() - 10) < 0.02]
    rows = []
    for method in methods:
        row = [method]
        for low, high in CUBIC:
            inside = [point.answers[method] for point in points if low <= point.cubic < high]
            numbers = [one.l1 for one in inside if one.is_density]
            lost = len(inside) - len(numbers)
            text = f"{max(numbers):.2g}" if numbers else "-"
            row.append(text if not lost or not numbers else f"{text} ({lost} of {len(inside)} none)")
        rows.append(row)
    return table(["cubic fraction of the stiffness", *(range_text(*one) for one in CUBIC)], rows)


def law_table(points, methods):
    rows = []
    for method in methods:
        row = [method]
        for restitution in (0.98, 0.8):
            for law in LAWS:
                inside = [
                    (p.impulses, p.answers[method])
                    for p in points
                    if p.law == law and p.restitution == restitution and method in p.answers and 0.05 < p.cubic < 0.12
                ]
                row.append(bounds_cell(inside, rate_text))
        rows.append(row)
    return table(["r = .98, then r = .8", *LAWS, *LAWS], rows)


def impact_table(points):
    """Errors of the impact to first order, at points where the truncated series is accurate."""
    inside = [p for p in points if p.law == "gaussian" and p.impulses > 50 and p.restitution > 0.89]
    inside = [p for p in inside if "fd-km4-delta" in p.answers]
    header, rows = ["r"], [["fd-km4-delta"], ["fd-km4"]]
    for restitution in sorted({p.restitution for p in inside}, reverse=True):
        header.append(f"{restitution:.3g}")
        for row in rows:
            answers = [p.answers[row[0]] for p in inside if p.restitution == restitution]
            numbers = [one.l1 for one in answers if one.is_density]
            row.append(f"{max(numbers):.2g}" if len(numbers) == len(answers) else "none")
    return table(header, rows)


def steps_text(points, method):
    """The number of points within the limits, by impulses per decay time."""

    def held(low, high):
        answers = [p.answers[method] for p in points if low <= p.impulses < high and method in p.answers]
        return len(answers), [sum(one.within(limit) for one in answers) for limit in LIMITS], answers

    count, (close, _), answers = held(3, math.inf)
    worst = max(one.l1 if one.l1 is not None else 2 for one in answers)
    says_so = sum(one.letter == "o" for one in answers)
    text = f"With 3 impulses per decay time or more the error of `{method}` is below 1 % at {close} of {count} points, "
    text += f"its status is `ok` at {says_so} points, and its largest error is {worst:.2g}. "
    for low, high in ((2, 3), (1, 2)):
        count, (close, fair), _ = held(low, high)
        text += f"With {low} to {high} impulses per decay time the error is below 1 % at {close} of {count} points "
        text += f"and below 5 % at {fair} points. "
    count, (_, fair), _ = held(0, 1)
    return text + f"Below 1 impulse per decay time the error is below 5 % at {fair} of {count} points."


def paper_text(points):
    """The number of points within 1 % for each order of the paper's closure, at small losses and many impulses."""
    inside = [p for p in points if p.law == "gaussian" and p.restitution >= 0.95 and p.impulses >= 30]
    parts = []
    for order in (2, 4, 6, 8):
        answers = [p.answers[f"epc-gaussian-n{order}"] for p in inside]
        parts.append(f"{sum(one.within(LIMITS[0]) for one in answers)} (`n = {order}`)")
    text = ", ".join(parts[:-1]) + " and " + parts[-1]
    return (
        "At small losses and frequent impulses (`r` of 0.95 or more, 30 impulses per decay time or more) the error of "
        f"`gaussian` is below 1 % at {text} of {len(inside)} points."
    )


def distance_text(points, methods):
    """Ratios of the errors of closures between points at a distance of about one."""
    ratios = {method: [] for method in methods}
    for k, one in enumerate(points):
        for other in points[:k]:
            if not 0.8 < one.distance(other) < 1.2:
                continue
            for method in methods:
                a, b = one.answers.get(method), other.answers.get(method)
                if a and b and a.is_density and b.is_density and min(a.l1, b.l1) > 0:
                    ratios[method].append(max(a.l1, b.l1) / min(a.l1, b.l1))
    medians, nines = [], []
    for found in filter(lambda found: len(found) >= 100, ratios.values()):
        found.sort()
        medians.append(found[len(found) // 2])
        nines.append(found[len(found) * 9 // 10])
    if not medians:
        return ""
    return (
        "Between two points at a distance of 0.8 to 1.2 the error of a closure differs by a factor of "
        f"{min(medians):.1f} to {max(medians):.1f} (median); in a tenth of the pairs of points the factor exceeds "
        f"{min(nines):.0f} to {max(nines):.0f}."
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("map", type=Path)
    parser.add_argument("--document", required=True, type=Path)
    parser.add_argument("--check", action="store_true", help="write nothing; fail if the document is out of date")
    arguments = parser.parse_args()
    with open(arguments.map, newline="") as file:
        reader = csv.DictReader(file)
        methods = reader.fieldnames[6:]
        points = [Point(row, methods) for row in reader]
    tables = {
        "methods": methods_table(points, methods),
        "rate and restitution": restitution_table(points, methods[:-1]),
        "cubic": cubic_table(points, methods),
        "steps": steps_text(points, "epc-polar-n6"),
        "paper": paper_text(points),
        "impact": impact_table(points),
        "laws": law_table(points, methods[:-1]),
        "distance": distance_text(points, [method for method in methods if method.startswith("epc-")]),
    }
    for name, text in tables.items():
        print(f"{name}\n{text}\n")
        if arguments.document.exists():
            replace_part(arguments.document, name, text, arguments.check)


main()
