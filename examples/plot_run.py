# Plots p(y) of all solutions of a run with status ok, integrated from the joint densities p(y, y').
#   build/release/cli/fpkcheck run case1 --out results && /usr/bin/python3 examples/plot_run.py results p_y.png
import json, sys
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt, xarray

plt.rc("axes", prop_cycle=plt.cycler(color=plt.cm.tab20.colors))
directory, picture = sys.argv[1:]
solutions = {c["name"]: c["solutions"] for c in json.load(open(f"{directory}/summary.json"))["cases"]}
joint = xarray.open_dataset(f"{directory}/joint.nc")
densities = [variable for variable in joint.values() if "case" in variable.attrs]
figure, panels = plt.subplots(1, len(densities), figsize=(6 * len(densities), 4), squeeze=False)
for panel, density in zip(panels.flat, densities):
    _, y, ydot = density.dims
    p = (density * joint[f"{ydot}_bounds"].diff("bounds").squeeze()).sum(ydot, skipna=False)
    for id in [s["id"] for s in solutions[density.attrs["case"]] if s["status"] == "ok"]:
        panel.plot(joint[y], p.sel(solution=id), label=id)
    panel.set(title=density.attrs["case"], xlabel="y", ylabel="p(y)")
    panel.legend(fontsize="small")
figure.savefig(picture)
