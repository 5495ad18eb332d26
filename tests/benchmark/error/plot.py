#!/usr/bin/env python3
"""Draws run time against error, one panel a question: plot.py error.json error.svg"""

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

LINES = {"double": "-", "float": ":"}


def share(contestant, scope):
    return contestant[scope]["errors"] / contestant[scope]["elements"]


def time_of(contestant):
    """On ordinary input, if the question has such categories."""
    return (contestant["generic"] or contestant["all"])["nanoseconds_mean"]


def exponent(epsilon):
    return f"{epsilon:.0e}".replace("e-0", "e-")


def text_of(contestant, scope, is_one_sided):
    name = contestant["name"]
    if contestant["epsilon"] is not None:
        name += ", ε " + exponent(contestant["epsilon"])
    if contestant["precision"] == "float":
        name += ", float"
    if contestant[scope]["unsure"] == contestant[scope]["errors"] > 0:
        name += " (unsure, never wrong)"
    if contestant[scope]["failed"] * 2 > contestant[scope]["errors"]:
        name += " (mostly refused)"
    if is_one_sided:
        name += f" ({100 * contestant[scope]['false_positives'] / contestant[scope]['elements']:.2g} % needless overlaps)"
    return name


def draw_families(axes, contestants, scope, labels):
    """A line through the values of EPSILON of each method, from none to the largest."""
    families = {}
    for contestant in contestants:
        families.setdefault((contestant["name"], contestant["precision"]), []).append(contestant)
    for (_, precision), family in families.items():
        if len(family) == 1:
            continue
        points = [(share(member, scope), time_of(member)) for member in family]
        axes.plot(*zip(*points), linestyle=LINES[precision], color=COLOURS["baseline"], linewidth=0.8, zorder=1)
        labels.avoid(axes, points)
        for member in family:
            if member["epsilon"] is None:
                continue
            axes.plot([share(member, scope)], [time_of(member)], marker=".", markersize=4,
                      color=COLOURS["baseline"], zorder=2)
            if member["epsilon"] in (family[1]["epsilon"], family[-1]["epsilon"]):
                labels.add(axes, share(member, scope), time_of(member),
                           "ε " + exponent(member["epsilon"]), size=5.5, colour=COLOURS["baseline"])


def draw_mark(axes, x, contestant, labels):
    """The mark at ordinary input, and a thin line to the mean over all categories."""
    origin = contestant["origin"]
    labels.avoid(axes, [(x, time_of(contestant)), (x, contestant["all"]["nanoseconds_mean"])])
    filled = "white" if contestant["precision"] == "float" else COLOURS[origin]
    axes.plot([x, x], [time_of(contestant), contestant["all"]["nanoseconds_mean"]], linewidth=0.6,
              color=COLOURS[origin], zorder=1)
    axes.plot([x], [time_of(contestant)], marker=MARKERS[origin], markerfacecolor=filled, zorder=3,
              markersize=11 if origin == "graze" else 5.5, markeredgecolor=COLOURS[origin])


def draw_panel(zero, axes, question, scope):
    contestants = [c for c in question["contestants"] if c[scope]]
    wrong = [c for c in contestants if c[scope]["errors"] > 0]
    right = [c for c in contestants
             if c[scope]["errors"] == 0 and (c["epsilon"] is None or question["is_one_sided"])]
    elements = max(c[scope]["elements"] for c in contestants)
    axes.set_xscale("log")
    axes.set_yscale("log")
    right.sort(key=time_of)
    labels = Labels()
    if wrong:
        axes.set_xlim(0.5 * min(share(c, scope) for c in wrong), 1.5)
    else:
        axes.set_xlim(1e-3, 1)
        axes.text(0.5, 0.5, "nobody is wrong", transform=axes.transAxes, ha="center", fontsize=8)
    for contestant in wrong:
        if contestant["epsilon"] is None:
            draw_mark(axes, share(contestant, scope), contestant, labels)
            labels.add(axes, share(contestant, scope), time_of(contestant), text_of(contestant, scope, question["is_one_sided"]))
    draw_families(axes, wrong, scope, labels)
    zero.set_xlim(0, 1)
    zero.set_xticks([0.1], [f"0 of {elements:,}"])
    for contestant in right:
        draw_mark(zero, 0.1, contestant, labels)
        labels.add(zero, 0.1, time_of(contestant), text_of(contestant, scope, question["is_one_sided"]))
    break_axis(zero, axes)
    return labels


def break_axis(zero, axes):
    zero.set_zorder(axes.get_zorder() + 1)  # long labels reach over the break
    zero.spines["right"].set_visible(False)
    axes.spines["left"].set_visible(False)
    axes.tick_params(axis="y", which="both", left=False, labelleft=False)
    zero.grid(True, axis="y", linewidth=0.3, alpha=0.5)
    axes.grid(True, linewidth=0.3, alpha=0.5)
    slash = {"marker": [(-1, -2), (1, 2)], "markersize": 6, "linestyle": "none", "color": "k",
             "clip_on": False}
    zero.plot([1, 1], [0, 1], transform=zero.transAxes, **slash)
    axes.plot([0, 0], [0, 1], transform=axes.transAxes, **slash)


SCOPES = {"all": "all categories", "generic": "ordinary input only", "floats": "inputs that floats hold"}


def panel(figure, place, question, scope):
    grid = place.subgridspec(1, 2, width_ratios=[1, 3], wspace=0.03)
    zero = figure.add_subplot(grid[0])
    axes = figure.add_subplot(grid[1], sharey=zero)
    labels = draw_panel(zero, axes, question, scope)
    zero.set_title(f"{question['question']}: {SCOPES[scope]}", loc="left", fontsize=10)
    axes.set_xlabel("share of wrong answers “apart”" if question["is_one_sided"] else
                    "share of wrong or missing answers")
    zero.set_ylabel("nanoseconds a query" if question["question"].startswith("meshes") else "nanoseconds each")
    return labels


def main():
    source, target = sys.argv[1:3]
    with open(source, encoding="utf-8") as file:
        result = json.load(file)
    first, *others = result["questions"]
    small = [(first, "floats"), (first, "generic")] + [(question, "all") for question in others]
    rows = (len(small) + 1) // 2
    figure = plt.figure(figsize=(13, 8 + 4.2 * rows))
    grid = figure.add_gridspec(1 + rows, 2, height_ratios=[2] + [1] * rows, hspace=0.24, wspace=0.12,
                               left=0.06, right=0.98, top=0.95, bottom=0.03)
    labels = [panel(figure, grid[0, :], first, "all")]
    for i, (question, scope) in enumerate(small):
        labels.append(panel(figure, grid[1 + i // 2, i % 2], question, scope))
    figure.suptitle(
        "Run time against error. Marks: mean on ordinary input; the thin line ends at the mean over all "
        "categories.\nStar: graze; circle: classic test, ε: what it snaps to zero; square: another library; "
        f"hollow: float. {result['machine']['processor']}, one thread", fontsize=9)
    figure.canvas.draw()
    for label in labels:
        label.place(figure)
    figure.savefig(target, metadata={"Date": None} if target.endswith(".svg") else None)


if __name__ == "__main__":
    main()
