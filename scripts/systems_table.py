"""Writes the table of docs/systems.md from runs of the example systems. The row of a system without a run is kept.

    systems_table.py docs/systems.md DIRECTORY NAME ...
"""

import json
import pathlib
import sys

from document_parts import replace_part


def l1(case, a, b):
    """The larger L1 distance of p(y) and p(y') of two solutions, or None."""
    found = [row["l1"] for row in case["comparisons"] if {row["a"], row["b"]} == {a, b}]
    return max(found) if found and None not in found else None


def number(value):
    return "–" if value is None else f"{value:.1e}"


def at_rest(solution):
    return ", ".join(f"{atom['probability']:.4f}" for atom in solution.get("atoms", []))


def row(name, case):
    solutions = {one["id"]: one for one in case["solutions"]}
    ok = [key for key, one in solutions.items() if one["status"] == "ok"]
    # Reference: the simulation if it is ok, else finite volumes.
    judge = next((key for key in ("mcs", "fd-kf") if key in ok), None)
    fd = l1(case, "fd-kf", "mcs") if "fd-kf" in ok and "mcs" in ok else None
    closures = [(l1(case, key, judge), key) for key in solutions if key.startswith("epc-")]
    closures = [(value, key) for value, key in closures if value is not None]
    best = min(closures) if closures else None
    rest = " / ".join(filter(None, (at_rest(solutions.get(key, {})) for key in ("mcs", "fd-kf"))))
    not_offered = [key for key, one in solutions.items() if one["status"] == "not_offered"]
    return [
        f"[`{name}`](#{name})", f"{solutions[judge]['moments']['y2']:.4f}" if judge else "–",
        f"{solutions[judge]['moments']['v2']:.4f}" if judge else "–", rest or "–", number(fd),
        f"{best[1]} {number(best[0])}" if best else "–",
        f"{len(ok)} of {len(solutions) - len(not_offered)}"
    ]


def main():
    page, directory, names = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]
    head = ["system", "E[y^2]", "E[y'^2]", "P(rest): mcs / fd-kf", "fd-kf to mcs, L1", "closest closure, L1", "ok of offered"]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    former = page.read_text().splitlines()
    for name in names:
        summary = directory / name / "summary.json"
        if summary.exists():
            case = json.loads(summary.read_text())["cases"][0]
            lines.append("| " + " | ".join(row(name, case)) + " |")
        else:
            lines += [line for line in former if line.startswith(f"| [`{name}`]")]
    replace_part(page, "table", "\n".join(lines))


if __name__ == "__main__":
    main()
