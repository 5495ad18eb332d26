#!/usr/bin/env python3
"""Prints what pairs.json says as tables: table.py pairs.json"""

import json
import sys


def print_table(title, rows):
    print(f"\n{title}")
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        cells = [row[0].ljust(widths[0])] + [cell.rjust(width) for cell, width in zip(row[1:], widths[1:])]
        print("  " + "  ".join(cells).rstrip())


def number(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def cell_of(regime, contestant, question):
    for answer in regime["answers"]:
        if answer["contestant"] == contestant and answer["question"] == question:
            wrong = f" ({answer['wrong']}!)" if answer["wrong"] else ""
            return number(answer["median_microseconds"]) + wrong
    return "-"


def times_of(scene, contestants, question):
    rows = [[question] + [regime["regime"] for regime in scene["regimes"]]]
    for contestant in contestants:
        cells = [cell_of(regime, contestant, question) for regime in scene["regimes"]]
        if any(cell != "-" for cell in cells):
            rows.append([contestant] + cells)
    return rows


def builds_of(scene):
    regimes = [regime["regime"] for regime in scene["regimes"]]
    rows = [["build", "ms", "MB"] + [f"with any, {regime}, ms" for regime in regimes]]
    for build in scene["builds"]:
        if "left_out" in build:
            continue
        one_shot = [number(build["one_shot_milliseconds"][regime]) for regime in regimes]
        rows.append([build["contestant"], number(build["milliseconds"]), number(build["bytes"] / 1e6)] + one_shot)
    return rows


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        result = json.load(file)
    contestants = [contestant["contestant"] for contestant in result["contestants"]]
    for scene in result["scenes"]:
        first, second = scene["triangles"]
        title = f"{scene['scene']} ({first:,} and {second:,} triangles)"
        print_table(title, builds_of(scene))
        for build in scene["builds"]:
            if "left_out" in build:
                print(f"  {build['contestant']} takes no part: {build['left_out']}")
        for question in ["any", "pairs", "distance", "within"]:
            print_table(f"{title}: microseconds; (n!): n poses answered otherwise than exactly",
                        times_of(scene, contestants, question))


if __name__ == "__main__":
    main()
