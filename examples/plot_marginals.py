# Plots p(y') of all solutions of the first case of a run on a logarithmic scale, with 95 % confidence intervals.
#   build/release/cli/fpkcheck run case1 --out results && /usr/bin/python3 examples/plot_marginals.py results/marginals.csv p_v.png
import csv, sys
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rc("axes", prop_cycle=plt.cycler(color=plt.cm.tab20.colors))
marginals, picture = sys.argv[1:]
rows = [row for row in csv.DictReader(open(marginals)) if row["variable"] == "ydot"]
rows = [row for row in rows if row["case"] == rows[0]["case"]]
for id in dict.fromkeys(row["solution"] for row in rows):
    v, p, lower, upper = ([float(row[column] or "nan") for row in rows if row["solution"] == id]
                          for column in ("abscissa", "density", "lower", "upper"))
    plt.semilogy(v, p, label=id)
    plt.fill_between(v, lower, upper, alpha=0.3)
plt.gca().set(title=rows[0]["case"], xlabel="y'", ylabel="p(y')", ylim=(1e-8, None))
plt.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1, 1))
plt.savefig(picture, bbox_inches="tight")
