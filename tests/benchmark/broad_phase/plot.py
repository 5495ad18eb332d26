#!/usr/bin/env python3
"""Draws what a frame takes, and how that grows: plot.py broad_phase.json broad_phase.svg"""

import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Shape and filling say who it is, so that the plot can be read without colour: the library filled.
STYLE = {
    "graze": ("*", "#c0392b", True),
    "graze, 2 threads": ("s", "#e67e22", True),
    "FCL tree, float": ("o", "#1b6ca8", False),
    "FCL tree, double": ("D", "#1b6ca8", False),
    "Bullet DBVT": ("^", "#1e8449", False),
    "Bullet axis sweep": ("<", "#1e8449", False),
    "ODE hash space": ("v", "#8e44ad", False),
    "CGAL": ("s", "#34495e", False),
    "Embree, refit": ("P", "#7f8c8d", False),
    "Embree, rebuilt": ("X", "#7f8c8d", False),
}
SCENES = {
    "S1": "S1: all move a little",
    "S2": "S2: a pile on one floor, 15 % fall",
    "S3": "S3: one in a hundred moves",
    "S4": "S4: sizes over three decades, all move",
    "S5": "S5: dense clusters cross each other fast",
}
REPLACED = {100: "one in 100 is replaced", 10: "one in 10 is replaced"}
MOVERS = {0: "*", 10: "o", 1000: "s"}


def style_of(contestant):
    marker, colour, is_filled = STYLE.get(contestant, ("h", "#000000", False))
    return {"marker": marker, "color": colour, "markeredgecolor": colour if not is_filled else "black",
            "markerfacecolor": colour if is_filled else "white", "markeredgewidth": 1.0 if not is_filled else 0.6,
            "markersize": 11 if marker == "*" else 6.5,
            "linestyle": "-" if contestant.startswith("graze") else "--", "linewidth": 0.9}


def prepare(axes, title, label):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, linewidth=0.4, alpha=0.5)
    axes.set_title(title, loc="left", fontsize=9)
    axes.set_xlabel("boxes", fontsize=8)
    axes.set_ylabel(label, fontsize=8)


def draw_contest(axes, rows, title):
    for contestant in STYLE:
        points = [(row["boxes"], 1e6 * row["median_ms"] / row["boxes"], row["wrong_frames"])
                  for row in rows if row["contestant"] == contestant]
        if not points:
            continue
        axes.plot([x for x, _, _ in points], [y for _, y, _ in points], **style_of(contestant))
        for x, y, wrong in points:
            if wrong:
                axes.annotate("wrong", (x, y), xytext=(0, 5), textcoords="offset points", ha="center", fontsize=6)
    prepare(axes, title, "nanoseconds a box and frame")


def draw_movers(axes, rows):
    for count, marker in MOVERS.items():
        points = [(row["boxes"], row["median_us"]) for row in rows if row["movers"] == count]
        axes.plot(*zip(*points), marker=marker, color="#c0392b", markeredgecolor="black", markeredgewidth=0.6,
                  linewidth=0.9, label=f"{count} movers")
    axes.legend(fontsize=7, frameon=False)
    prepare(axes, "graze: a step with few movers", "microseconds a step")


def main():
    source, target = sys.argv[1:3]
    with open(source, encoding="utf-8") as file:
        result = json.load(file)
    figure, panels = plt.subplots(2, 4, figsize=(18, 8.5))
    contests = [([row for row in result["scenes"] if row["scene"] == scene], title)
                for scene, title in SCENES.items()]
    contests += [([row for row in result["churn"] if row["boxes"] // row["replaced"] == one_in], title)
                 for one_in, title in REPLACED.items()]
    for axes, (rows, title) in zip(panels.flat, contests):
        draw_contest(axes, rows, title)
    draw_movers(panels.flat[-1], result["movers"])
    present = [name for name in STYLE if any(row["contestant"] == name for row in result["scenes"])]
    handles = [plt.Line2D([], [], label=name, **style_of(name)) for name in present]
    figure.legend(handles=handles, loc="lower center", ncols=5, fontsize=8, frameon=False)
    figure.suptitle("Moving boxes: all overlapping pairs in every frame, medians over the frames. "
                    "Filled marks and full lines: graze; \"wrong\": in some frames not the pairs that all others find.\n"
                    f"{result['processor']}; one thread where nothing else is said", fontsize=9)
    figure.tight_layout(rect=(0, 0.06, 1, 1))  # the legend stands below
    figure.savefig(target, metadata={"Date": None} if target.endswith(".svg") else None)


if __name__ == "__main__":
    main()
