#!/usr/bin/env python3
"""Draws what a query takes, and how that grows: plot.py pairs.json regimes.svg scaling.svg"""

import json
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

QUESTIONS = ["any", "pairs", "distance", "within"]
REGIMES = ["far", "near", "touch", "deep"]
# Shape and filling say who it is, so that the plots can be read without colour: the library filled.
STYLE = {
    "graze wide": ("*", "#c0392b", True),
    "graze aabb": ("s", "#e67e22", True),
    "graze obb": ("D", "#8e6d3b", True),
    "FCL OBBRSS": ("o", "#1b6ca8", False),
    "FCL OBB": ("D", "#1b6ca8", False),
    "Bullet GImpact": ("^", "#1e8449", False),
    "ODE": ("v", "#8e44ad", False),
    "CGAL": ("s", "#34495e", False),
    "Embree": ("P", "#7f8c8d", False),
}


def style_of(contestant):
    marker, colour, is_filled = STYLE.get(contestant, ("X", "#000000", False))
    return {"marker": marker, "color": colour, "markeredgecolor": colour if not is_filled else "black",
            "markerfacecolor": colour if is_filled else "white", "markeredgewidth": 1.0 if not is_filled else 0.6,
            "markersize": 11 if marker == "*" else 6.5}


def geometric_mean(values):
    return math.exp(sum(math.log(max(value, 1e-3)) for value in values) / len(values))


def answers_in(scenes, kind, regime, question):
    """Contestant -> its answers, one for each scene."""
    found = {}
    for scene in scenes:
        for poses in scene["regimes"]:
            if scene["kind"] != kind or poses["regime"] != regime:
                continue
            for answer in poses["answers"]:
                if answer["question"] == question:
                    found.setdefault(answer["contestant"], []).append({**answer, "poses": poses["poses"]})
    return found


def draw_column(axes, place, answers, scenes):
    """One regime: who answers in all scenes at its geometric mean, with a bar from best to worst."""
    width = 0.8 / len(STYLE)
    for contestant, scores in answers.items():
        if len(scores) < scenes:
            continue
        rank = list(STYLE).index(contestant) if contestant in STYLE else len(STYLE)
        x = place + (rank - len(STYLE) / 2) * width
        times = [score["median_microseconds"] for score in scores]
        style = style_of(contestant)
        axes.plot([x, x], [min(times), max(times)], color=style["color"], linewidth=0.8, alpha=0.7, zorder=2)
        axes.plot([x], [geometric_mean(times)], linestyle="none", zorder=3, **style)
        wrong = sum(score["wrong"] for score in scores)
        if wrong:
            asked = sum(score["poses"] for score in scores)
            axes.annotate(f"{wrong}/{asked}", (x, max(times)), xytext=(0, 4), textcoords="offset points",
                          ha="center", fontsize=6, rotation=90)


def count_scenes(scenes, kind, regime):
    return sum(scene["kind"] == kind and any(p["regime"] == regime for p in scene["regimes"]) for scene in scenes)


def draw_question(axes, scenes, question):
    columns = [("meshes", regime, regime) for regime in REGIMES]
    columns += [("parallel", "clear", "parallel,\nclear"), ("parallel", "touch", "parallel,\ntouch")]
    for place, (kind, regime, _) in enumerate(columns):
        draw_column(axes, place, answers_in(scenes, kind, regime, question), count_scenes(scenes, kind, regime))
        axes.axvline(place + 0.5, color="grey", linewidth=0.4)
    axes.set_xlim(-0.5, len(columns) - 0.5)
    axes.set_xticks(range(len(columns)), [label for _, _, label in columns])
    axes.set_yscale("log")
    axes.grid(True, axis="y", which="major", linewidth=0.4, alpha=0.5)
    axes.set_title(question, loc="left", fontsize=10)
    axes.set_ylabel("microseconds a query")


def legend(figure, contestants):
    handles = [plt.Line2D([], [], linestyle="none", label=name, **style_of(name)) for name in contestants]
    figure.legend(handles=handles, loc="lower center", ncols=len(handles), fontsize=8, frameon=False)


def draw_regimes(result, target):
    figure, panels = plt.subplots(2, 2, figsize=(14, 9))
    for axes, question in zip(panels.flat, QUESTIONS):
        draw_question(axes, result["scenes"], question)
    legend(figure, [contestant["contestant"] for contestant in result["contestants"]])
    figure.suptitle("Two meshes in a pose: medians of each scene's poses; marks: geometric mean over the scenes, "
                    "bars: from the fastest scene to the slowest,\nfractions: poses answered otherwise than exactly. "
                    f"{result['processor']}, one thread", fontsize=9)
    save(figure, target)


def draw_growth(axes, scenes, regime, question, value, label):
    lines = {}
    for scene in (scene for scene in scenes if scene["kind"] == "scaling"):
        for poses in (poses for poses in scene["regimes"] if poses["regime"] == regime):
            for answer in (answer for answer in poses["answers"] if answer["question"] == question):
                amount = value(answer)
                if amount is not None:
                    lines.setdefault(answer["contestant"], []).append((scene["triangles"][0], amount))
    for contestant, points in lines.items():
        axes.plot(*zip(*points), linewidth=0.9, linestyle="-" if contestant.startswith("graze") else "--",
                  **style_of(contestant))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, linewidth=0.4, alpha=0.5)
    axes.set_title(f"{question}, {regime}", loc="left", fontsize=9)
    axes.set_ylabel(label, fontsize=8)


def draw_scaling(result, target):
    rows = [("any", False), ("pairs", False), ("distance", False), ("pairs", True)]
    regimes = ["near", "touch", "deep"]
    figure, panels = plt.subplots(len(rows), len(regimes), figsize=(12, 13))
    for line, (question, is_work) in zip(panels, rows):
        for axes, regime in zip(line, regimes):
            if is_work:
                draw_growth(axes, result["scenes"], regime, question, total_work, "tests a query, of all kinds")
            else:
                draw_growth(axes, result["scenes"], regime, question, lambda a: a["median_microseconds"],
                            "microseconds a query")
    for axes in panels[-1]:
        axes.set_xlabel("triangles of each mesh")
    legend(figure, [contestant["contestant"] for contestant in result["contestants"]])
    figure.suptitle("A rock against itself, refined: medians over the poses. Filled marks and full lines: graze. "
                    f"{result['processor']}, one thread", fontsize=9)
    save(figure, target)


def total_work(answer):
    if "work" not in answer:
        return None
    work = answer["work"]
    return max(work["volume_tests"] + work["filter_tests"] + work["triangle_tests"], 0.1)


def save(figure, target):
    figure.tight_layout(rect=(0, 0.03, 1, 1))  # the legend stands below
    figure.savefig(target, metadata={"Date": None} if target.endswith(".svg") else None)
    plt.close(figure)


def main():
    source, regimes, scaling = sys.argv[1:4]
    with open(source, encoding="utf-8") as file:
        result = json.load(file)
    draw_regimes(result, regimes)
    draw_scaling(result, scaling)


if __name__ == "__main__":
    main()
