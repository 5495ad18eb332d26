#!/usr/bin/env python3
"""Prints what broad_phase.json says as tables: table.py broad_phase.json"""

import json
import math
import sys


def number(value):
    return f"{value:.2g}" if value < 10 else f"{value:.0f}"


def row_of(rows, contestant):
    return next((row for row in rows if row["contestant"] == contestant), None)


def best_peer(rows):
    peers = [row for row in rows if not row["contestant"].startswith("graze") and row["wrong_frames"] == 0]
    return min(peers, key=lambda row: row["median_ms"], default=None)


def print_scenes(scenes):
    sizes = sorted({row["boxes"] for row in scenes})
    print("| milliseconds a frame | " + " | ".join(f"{size:,}" for size in sizes) + " |")
    print("|---" * (len(sizes) + 1) + "|")
    ratios, threads = [], {}
    for scene in sorted({row["scene"] for row in scenes}):
        cells = []
        for size in sizes:
            rows = [row for row in scenes if row["scene"] == scene and row["boxes"] == size]
            own, peer, two = row_of(rows, "graze"), best_peer(rows), row_of(rows, "graze, 2 threads")
            cell = number(own["median_ms"])
            if peer:
                ratio = peer["median_ms"] / own["median_ms"]
                ratios.append(ratio)
                cell += f" ({number(ratio)}: {peer['contestant']})"
            cells.append(cell)
            if two:
                threads[scene, size] = own["median_ms"] / two["median_ms"]
        print(f"| {scene} | " + " | ".join(cells) + " |")
    mean = math.exp(sum(map(math.log, ratios)) / len(ratios)) if ratios else math.nan
    print(f"\nbest peer over graze: geometric mean {mean:.1f}, least {min(ratios, default=math.nan):.1f}")
    largest = [f"{scene} {size:,}: {gain:.2f}" for (scene, size), gain in threads.items() if size >= 100000]
    if largest:
        print("one thread over two: " + ", ".join(largest))
    held = [f"{row['scene']} {row['boxes']:,}: {row['bytes_per_box']:.1f}" for row in scenes
            if row["contestant"] == "graze" and row["boxes"] >= 100000]
    print("bytes a box: " + ", ".join(held))


def print_churn(churn):
    sizes = sorted({row["boxes"] for row in churn})
    print("\n| milliseconds a frame | " + " | ".join(f"{size:,} boxes" for size in sizes) + " |")
    print("|---" * (len(sizes) + 1) + "|")
    for one_in in sorted({row["boxes"] // row["replaced"] for row in churn}, reverse=True):
        cells = []
        for size in sizes:
            rows = [row for row in churn if row["boxes"] == size and row["boxes"] // row["replaced"] == one_in]
            own, peer = row_of(rows, "graze"), best_peer(rows)
            cell = number(own["median_ms"])
            if peer:
                cell += f" ({number(peer['median_ms'] / own['median_ms'])}: {peer['contestant']})"
            cells.append(cell)
        print(f"| one in {one_in} replaced | " + " | ".join(cells) + " |")


def print_movers(rows):
    counts = sorted({row["movers"] for row in rows})
    print("\n| microseconds a step | " + " | ".join(f"{count} movers" for count in counts) + " |")
    print("|---" * (len(counts) + 1) + "|")
    for size in sorted({row["boxes"] for row in rows}):
        cells = {row["movers"]: number(row["median_us"]) for row in rows if row["boxes"] == size}
        print(f"| {size:,} boxes | " + " | ".join(cells.get(count, "") for count in counts) + " |")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        result = json.load(file)
    print_scenes(result["scenes"])
    print_churn(result["churn"])
    print_movers(result["movers"])


if __name__ == "__main__":
    main()
