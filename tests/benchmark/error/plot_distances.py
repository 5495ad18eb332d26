#!/usr/bin/env python3
"""Draws run time against the error of distances: plot_distances.py error.json distances.svg"""

import json
import sys

import matplotlib

matplotlib.use("Agg")
# Text as text: a third of the size. The same names for the same things in each run.
matplotlib.rcParams["svg.fonttype"] = "none"
matplotlib.rcParams["svg.hashsalt"] = "graze"
import matplotlib.pyplot as plt

from labels import Labels
from marks import COLOURS, MARKERS

# Errors below this, in ulps, are drawn at it: nobody is better than rounding.
LEAST = 0.25


def time_of(contestant):
    """On ordinary input, if the question has such categories."""
    return (contestant["generic"] or contestant["all"])["nanoseconds_mean"]


def text_of(contestant, scope):
    name = contestant["name"]
    if contestant["precision"] == "float":
        name += ", float"
    counts = contestant[scope]
    worst = []
    for key, what in (("false_zeros", "0 although apart"), ("failed", "failed")):
        share = counts[key] / counts["elements"]
        if share >= 0.005:
            worst.append(f"{100 * share:.0f} % {what}")
    return name + (" (" + ", ".join(worst) + ")" if worst else "")


def draw_panel(axes, question, scope):
    contestants = [c for c in question["contestants"] if c[scope]]
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.axvline(question["bound_ulps"], color="black", linewidth=0.8, linestyle="--")
    labels = Labels()
    for contestant in contestants:
        origin = contestant["origin"]
        errors = [max(LEAST, contestant[scope][key] or 0) for key in ("ulps_median", "ulps_99", "ulps_max")]
        time = time_of(contestant) if scope != "all" else contestant["all"]["nanoseconds_mean"]
        filled = "white" if contestant["precision"] == "float" else COLOURS[origin]
        axes.plot(errors, [time] * 3, linewidth=0.7, color=COLOURS[origin], zorder=1)
        axes.plot(errors[:2], [time] * 2, marker="|", linestyle="none", color=COLOURS[origin], markersize=6)
        axes.plot(errors[2:], [time], marker=MARKERS[origin], markerfacecolor=filled, zorder=3,
                  markersize=11 if origin == "graze" else 5.5, markeredgecolor=COLOURS[origin])
        labels.avoid(axes, [(x, time) for x in errors])
        labels.add(axes, errors[2], time, text_of(contestant, scope))
    low, high = axes.get_xlim()
    axes.set_xlim(LEAST / 2, max(4 * high, 100))
    low, high = axes.get_ylim()
    axes.set_ylim(low / 1.5, high * 1.5)
    axes.text(question["bound_ulps"], 0.99, " the bound that is promised", fontsize=6.5, va="top",
              transform=axes.get_xaxis_transform())
    axes.grid(True, linewidth=0.3, alpha=0.5)
    axes.set_xlabel(f"error in ulps of the largest coordinate ({LEAST} stands for all that is less)")
    axes.set_ylabel("nanoseconds a query" if "mesh" in question["question"] else "nanoseconds each")
    return labels


SCOPES = {"all": "all categories", "generic": "ordinary input only"}


def main():
    source, target = sys.argv[1:3]
    with open(source, encoding="utf-8") as file:
        result = json.load(file)
    triangles, meshes = result["distances"]
    panels = [(triangles, "all"), (triangles, "generic"), (meshes, "all")]
    figure, rows = plt.subplots(len(panels), figsize=(11, 4.6 * len(panels)),
                                gridspec_kw={"hspace": 0.28, "left": 0.08, "right": 0.97, "top": 0.94, "bottom": 0.04})
    labels = []
    for axes, (question, scope) in zip(rows, panels):
        count = question["contestants"][0][scope]["elements"]
        axes.set_title(f"{question['question']}: {SCOPES[scope]}, {count:,} queries", loc="left", fontsize=10)
        labels.append(draw_panel(axes, question, scope))
    figure.suptitle(
        "Distances: run time against error. Marks: the largest error; ticks on the line: the median and the 99th "
        "percentile.\nStar: graze; circle: classic test; square: another library; hollow: float. "
        f"{result['machine']['processor']}, one thread", fontsize=9)
    figure.canvas.draw()
    for label in labels:
        label.place(figure)
    figure.savefig(target, metadata={"Date": None} if target.endswith(".svg") else None)


if __name__ == "__main__":
    main()
