#!/usr/bin/env python3
"""Draws time against false candidates, one panel a regime: plot.py volumes.json volumes.svg"""

import json
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Shape says which volume, so that the plot can be read without colour.
STYLE = {
    "wide": ("*", "#000000"),
    "aabb": ("s", "#1b6ca8"),
    "sphere": ("o", "#c0392b"),
    "obb": ("D", "#1e8449"),
    "kdop": ("h", "#8e44ad"),
    "sphere-aabb": ("^", "#1b6ca8"),
    "sphere-obb": ("v", "#1e8449"),
    "sphere-kdop": ("P", "#8e44ad"),
}
REGIMES = ["far", "near", "touch", "deep"]


def false_candidates(volume):
    """Pairs of triangles a query that volumes let through and that do not intersect."""
    return volume["pairs"]["triangle_tests"] - volume["pairs"]["hits"]


def geometric_mean(values):
    return math.exp(sum(math.log(max(value, 1e-3)) for value in values) / len(values))


def draw_regime(axes, queries):
    for name, (marker, colour) in STYLE.items():
        measures = [v for query in queries for v in query["volumes"] if v["volume"] == name]
        false = [false_candidates(v) + 1 for v in measures]
        times = [v["pairs"]["microseconds"] for v in measures]
        axes.scatter(false, times, marker=marker, s=18, color=colour, alpha=0.35, linewidths=0)
        axes.scatter([geometric_mean(false)], [geometric_mean(times)], marker=marker, s=130,
                     facecolors=colour, edgecolors="black", linewidths=0.8, label=name, zorder=3)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", linewidth=0.4, alpha=0.5)


def main():
    source, target = sys.argv[1:3]
    with open(source, encoding="utf-8") as file:
        result = json.load(file)
    figure, panels = plt.subplots(1, len(REGIMES), figsize=(14, 4.6), constrained_layout=True)
    for axes, regime in zip(panels, REGIMES):
        queries = [query for query in result["queries"] if query["regime"] == regime]
        draw_regime(axes, queries)
        axes.set_title(regime)
        axes.set_xlabel("false candidates a query, plus one")
    panels[0].set_ylabel("microseconds a query for all pairs")
    panels[-1].legend(loc="lower right", fontsize=8, title="large: geometric mean", title_fontsize=8)
    machine = result["machine"]
    pairs = len({query["pair"] for query in result["queries"]})
    figure.suptitle(f"What a fit is worth: {pairs} pairs of meshes, each small mark one; "
                    f"{machine['processor']}, one thread", fontsize=10)
    figure.savefig(target, metadata={"Date": None} if target.endswith(".svg") else None)


if __name__ == "__main__":
    main()
