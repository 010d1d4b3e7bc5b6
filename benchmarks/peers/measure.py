"""Runs fpkcheck and other programs on one processor and writes their times and errors to peers.csv,
peers.md and peers.png in the given directory.

    measure.py FPKCHECK SIMULATION DIRECTORY      (benchmarks/peers/run calls it)
"""

import csv
import io
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from problem import V_EDGES, Y_EDGES, exact_white, rebin

HERE = Path(__file__).parent
SETTINGS = {"white": ["--set", "system.restitution=1"], "impulses": []}
# Finer than every measured grid; three independent methods agree with it to 1e-5 (docs/results.md).
REFERENCE = ["fd", "--refinement", 2.5]


def run_on_one_processor(command):
    return subprocess.run(["taskset", "-c", "0", *map(str, command)], capture_output=True,
                          text=True, check=True,
                          env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"})


def run_fpkcheck(program, problem, command, *options):
    """Bin averages, and the solver's own measurement of its time."""
    with tempfile.TemporaryDirectory() as directory:
        run_on_one_processor([program, command, "case1", *SETTINGS[problem], *options, "--quiet", "--out",
                       directory])
        summary = json.loads(Path(directory, "summary.json").read_text())
        densities = {}
        with open(Path(directory, "marginals.csv"), newline="") as file:
            for row in csv.DictReader(file):
                densities.setdefault(row["variable"], []).append(
                    (float(row["abscissa"]), float(row["density"])))
    result = []
    for name, wanted in (("y", Y_EDGES), ("ydot", V_EDGES)):
        centres, density = np.array(densities[name]).T
        width = centres[1] - centres[0]
        edges = np.append(centres - width / 2, centres[-1] + width / 2)
        result.append(rebin_by_spline(edges, density, wanted))
    return (*result, summary["cases"][0]["solutions"][0]["seconds"])


def rebin_by_spline(edges, density, wanted):
    """Averages over other bins, by a spline interpolant of the cumulative distribution."""
    from scipy.interpolate import make_interp_spline

    # Separately for both signs, since the density of y' may jump at 0.
    result = []
    for low, high in zip(wanted[:-1], wanted[1:]):
        side = edges >= -1e-12 if low >= -1e-12 else edges <= 1e-12
        at = edges[side]
        inside = (edges[:-1] >= at[0]) & (edges[1:] <= at[-1])
        cumulative = np.concatenate(([0], np.cumsum(density[inside] * np.diff(at))))
        spline = make_interp_spline(at, cumulative, k=5)
        result.append(float(spline(min(high, at[-1])) - spline(low)) / (high - low))
    return np.array(result)


def run_peer(command):
    rows = dict((row[0], np.array(row[1:], dtype=float))
                for row in csv.reader(io.StringIO(run_on_one_processor(command).stdout)))
    return rows["y"], rows["v"], float(rows["seconds"][0])


def main():
    program, simulation, directory = sys.argv[1:]
    python = sys.executable
    differences = [python, HERE / "differences.py"]
    white = ["fd", "--equation", "white"]
    entries = [
        ("white", "fpkcheck fd-white", "default", lambda: run_fpkcheck(program, "white", *white)),
        *(("white", "fpkcheck fd-white", f"direct, order 7, refined {f:g}",
           lambda f=f: run_fpkcheck(program, "white", *white, "--stepper", "direct", "--order", 7,
                                   "--refinement", f)) for f in (1, 1.5)),
        *(("white", "SciPy, splu", f"{n} x {n}",
           lambda n=n: run_peer([*differences, "white", n, "direct"])) for n in (70, 140, 280)),
        ("white", "SciPy, BDF", "70 x 70", lambda: run_peer([*differences, "white", 70, "bdf"])),
        *(("white", "FEniCS, quadratic", f"{n} x {n} x 4",
           lambda n=n: run_peer([python, HERE / "elements.py", n])) for n in (20, 40, 80)),
        ("impulses", "fpkcheck fd-kf", "default", lambda: run_fpkcheck(program, "impulses", "fd")),
        ("impulses", "fpkcheck epc-moment-n8", "",
         lambda: run_fpkcheck(program, "impulses", "epc", "--formulation", "moment", "--order", 8)),
        ("impulses", "fpkcheck mcs --controlled", "",
         lambda: run_fpkcheck(program, "impulses", "mcs", "--controlled")),
        *(("impulses", "fpkcheck mcs", f"time {t:g}",
           lambda t=t: run_fpkcheck(program, "impulses", "mcs", "--time", t))
          for t in (1e5, 1e6, 1e7)),
        *(("impulses", "SciPy, splu", f"{n} x {n}",
           lambda n=n: run_peer([*differences, "impulses", n, "direct"])) for n in (70, 140)),
        *(("impulses", "NumPy simulation", f"step {h:g}, time {t:g}",
           lambda h=h, t=t: run_peer([python, HERE / "simulation.py", h, t]))
          for h, t in ((0.05, 1e5), (0.05, 1e6), (0.01, 1e6))),
        *(("impulses", "plain C++ simulation", f"step 0.05, time {t:g}",
           lambda t=t: run_peer([simulation, 0.05, t])) for t in (1e5, 1e6, 1e7)),
    ]
    truth = {"white": exact_white(),
             "impulses": run_fpkcheck(program, "impulses", *REFERENCE)[:2]}
    rows = []
    for problem, name, size, solve in entries:
        try:
            y, v, seconds = solve()
        except subprocess.CalledProcessError as error:
            print(f"{problem}, {name} {size}: failed: {error.stderr.strip()[-200:]}",
                  file=sys.stderr)
            continue
        l1 = [float(np.sum(np.abs(density - true) * np.diff(edges))) for density, true, edges in
              zip((y, v), truth[problem], (Y_EDGES, V_EDGES))]
        rows.append((problem, name, size, seconds, *l1))
        print(f"{problem:9} {name:24} {size:24} {seconds:9.3f} s  L1 {l1[0]:.1e}  {l1[1]:.1e}",
              flush=True)
    write(rows, Path(directory))


def write(rows, directory):
    with open(directory / "peers.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["problem", "program", "size", "seconds", "l1_y", "l1_ydot"])
        out.writerows(rows)
    text = "| problem | program | size | seconds | L1 of p(y) | L1 of p(y') |\n|---|---|---|---|---|---|\n"
    for problem, name, size, seconds, l1_y, l1_v in rows:
        text += f"| {problem} | {name} | {size} | {seconds:.3g} | {l1_y:.1e} | {l1_v:.1e} |\n"
    (directory / "peers.md").write_text(text)

    figure, panels = plt.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True)
    titles = {"white": "white noise, r = 1, against the exact density",
              "impulses": "Gaussian impulses, r = 0.98, against fd-kf refined"}
    names = list(dict.fromkeys(row[1] for row in rows))
    markers = dict(zip(names, "osD^vP*X<>"))
    colours = dict(zip(names, plt.get_cmap("tab10").colors))
    for panel, problem in zip(panels, titles):
        for name in names:
            points = [(row[3], max(row[4], row[5])) for row in rows if row[:2] == (problem, name)]
            if points:
                ours = name.startswith("fpkcheck")
                panel.loglog(*zip(*points), marker=markers[name],
                             color=colours[name], label=name,
                             linestyle="-" if ours else "--", linewidth=2 if ours else 1)
        panel.set_title(titles[problem], fontsize=10)
        panel.set_xlabel("processor time, seconds")
        panel.set_ylabel("L1, the larger of p(y) and p(y')")
        panel.grid(alpha=0.3)
        panel.legend(fontsize=8)
    figure.savefig(directory / "peers.png", dpi=130)


if __name__ == "__main__":
    main()
