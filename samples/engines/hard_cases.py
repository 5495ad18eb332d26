#!/usr/bin/env python3
"""Hard cases with their truth (data/hard_cases) before an engine of your own, without graze: hard_cases.py FOLDER.

Copy this page and write your own answer(). The one below looks at boxes around triangles alone.
"""

import json
import sys
from pathlib import Path


def read(folder):
    """Yields (class, case) of every line; a class is the name of a file."""
    for file in sorted(Path(folder).glob("*.jsonl")):
        for line in file.read_text(encoding="utf-8").splitlines():
            yield file.stem, json.loads(line)


def mesh_of(shape):
    """The placed vertices and the triangles of a triangle or a mesh; None for other shapes."""
    if "triangle" in shape:
        return shape["triangle"], [[0, 1, 2]]
    if "mesh" not in shape or "motion" in shape:
        return None
    r = shape["pose"]
    place = lambda v: [r[i] * v[0] + r[i + 1] * v[1] + r[i + 2] * v[2] + r[i + 3] for i in (0, 4, 8)]
    return [place(v) for v in shape["mesh"]["vertices"]], shape["mesh"]["triangles"]


def largest(value):
    """The largest number of a shape, and no less than 1e-300."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return max([largest(each) for each in value] + [1e-300])
    return abs(value) if isinstance(value, (int, float)) else 1e-300


def is_near(said, true, scale):
    return said == true or abs(said - true) <= scale


def passes(case, said):
    """Whether an answer, written as the case's own is, says the same."""
    true = case["answer"]
    scale = 1e-9 * max(largest(case["a"]), largest(case["b"]))
    if "says" in true or "pairs" in true:
        return all(said[key] == true[key] for key in true if key in ("says", "pairs"))
    if "distance" in true:
        return is_near(said["distance"], true["distance"], scale)
    if "hits" in true:
        return len(said["hits"]) == len(true["hits"]) and all(
            is_near(p["distance"], q["distance"], scale) for p, q in zip(said["hits"], true["hits"])
        )
    return said["status"] == true["status"] and is_near(said["high"], true["high"], 1e-3)


def scoreboard(folder, answer):
    """Prints a row for each class. answer(case) returns None for what the engine has no query for."""
    rows = {}
    for kind, case in read(folder):
        row = rows.setdefault(kind, {"passed": 0, "failed": 0, "refused": 0})
        try:
            said = answer(case)
            row["refused" if said is None else "passed" if passes(case, said) else "failed"] += 1
        except (ArithmeticError, KeyError, TypeError, ValueError):
            row["failed"] += 1
    print(f"{'class':>14}{'passed':>8}{'failed':>8}{'refused':>8}")
    for kind, row in rows.items():
        print(f"{kind:>14}{row['passed']:>8}{row['failed']:>8}{row['refused']:>8}")
    totals = [sum(row[key] for row in rows.values()) for key in ("passed", "failed", "refused")]
    print(f"{'all':>14}{totals[0]:>8}{totals[1]:>8}{totals[2]:>8}")


def answer(case):
    """Yours goes here: {"says": True}, or None for what it does not know."""
    meshes = mesh_of(case["a"]), mesh_of(case["b"])
    if case["question"] != "any" or None in meshes or "settings" in case:
        return None
    boxes = [[(min(p[i] for p in points), max(p[i] for p in points)) for i in range(3)] for points, _ in meshes]
    return {"says": all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(*boxes))}


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: hard_cases.py FOLDER")
    scoreboard(sys.argv[1], answer)
