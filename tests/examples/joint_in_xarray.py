# Tests joint.nc in xarray: labels, axes, masses, and agreement of the marginals with marginals.csv.
import csv, sys
import matplotlib
matplotlib.use("Agg")
import numpy, xarray

directory, picture = sys.argv[1:]
joint = xarray.open_dataset(f"{directory}/joint.nc")
ids = ["epc-gaussian-n6", "epc-gaussian-n8", "fd-white", "mcs"]
assert list(joint.solution.values) == ids, joint.solution

averages = {}
for row in csv.DictReader(open(f"{directory}/marginals.csv")):
    averages.setdefault((row["case"], row["solution"], row["variable"]), []).append(float(row["density"]))
for case in ("case1", "case4"):
    p = joint[f"p_{case}"]
    assert p.dims == ("solution", f"y_{case}", f"ydot_{case}"), p.dims
    assert p.attrs["case"] == case and p.attrs["damping"] == 0.1 and p.attrs["units"] == "1", p.attrs
    y_bounds, v_bounds = joint[f"y_{case}_bounds"].values, joint[f"ydot_{case}_bounds"].values
    assert y_bounds[0, 0] == 0 and v_bounds[0, 0] == -v_bounds[-1, 1]
    dy, dv = numpy.diff(y_bounds)[:, 0], numpy.diff(v_bounds)[:, 0]
    for id in ids:
        density = p.sel(solution=id).values.astype(float)
        if (case, id, "y") not in averages:
            assert case == "case1" and id == "epc-gaussian-n8" and numpy.isnan(density).all()
            continue
        # The height of a cell is two bins of the marginal. A closure that is cut off inside the axes has a jump.
        p_y = numpy.array(averages[case, id, "y"]).reshape(-1, 2).mean(axis=1)
        p_v = numpy.array(averages[case, id, "ydot"])
        allowed = 1e-3 if id == "epc-gaussian-n8" else 1e-6
        errors = abs(density @ dv - p_y) @ dy, abs(dy @ density - p_v) @ dv, abs(dy @ density @ dv - 1)
        assert max(errors) < allowed, (case, id, errors)

import matplotlib.pyplot as plt
joint.p_case1.sel(solution="fd-white").plot(x="ydot_case1")
plt.savefig(picture)
