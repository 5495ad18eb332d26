"""Whether the tables of tests/benchmark/figures.md have the figures of the files in data/benchmark/ that their commands wrote."""

import json
import math
import re
import subprocess
import sys

BUNDLED = ("bolt-nut", "gear-pinion", "link-link", "rock-rock", "terrain-rock")
QUESTIONS = {"any": "do they touch", "pairs": "which triangles", "distance": "distance", "within": "within 1 % of the size"}


def numbers(cells):
    return [float(n) for cell in cells for n in re.findall(r"\d+(?:\.\d+)?", cell.replace(",", ""))]


def rows_of(text):
    """The figures of each row of a table, by its first cell, of which commas and the words after a colon are cut."""
    rows = {}
    for line in text.splitlines():
        if line.startswith("| "):
            first, *cells = [cell.strip() for cell in line.strip("|").split("|")]
            rows[first.split(":")[0].replace(",", "").replace(" is replaced", " replaced")] = numbers(cells)
    return rows


def fits(written, figure):
    """To the digits that a page has use for: one after the point, where the figure has more."""
    return written in (figure, round(figure, 1))


def breaches_of(rows, wanted, what):
    if not wanted:
        yield f"{what} says no figures"
    for name, figures in wanted.items():
        written = rows.get(name, [])
        if len(written) != len(figures) or not all(map(fits, written, figures)):
            yield f"tests/benchmark/figures.md: the row '{name}' has {rows.get(name)}, {what} says {figures}"


def broad_phase_breaches(root, page):
    kept = root / "data/benchmark/broad_phase.json"
    table = subprocess.run([sys.executable, root / "tests/benchmark/broad_phase/table.py", kept], capture_output=True,
                           text=True, check=True).stdout
    wanted = {name: figures for name, figures in rows_of(table).items()
              if re.match(r"S\d$|one in (1000|100|10) replaced$|\d+ boxes$", name)}
    return list(breaches_of(rows_of(page), wanted, "its table.py"))


def two_digits(value):
    return float(f"{value:.2g}")


def pairs_breaches(root, page):
    """Geometric means over the bundled pairs, and how many times longer FCL's OBBRSS trees take."""
    result = json.loads((root / "data/benchmark/pairs.json").read_text(encoding="utf-8"))
    wanted = {}
    for question, name in QUESTIONS.items():
        wanted[name] = []
        for regime in ("far", "near", "touch", "deep"):
            logs = {"graze wide": [], "FCL OBBRSS": []}
            for scene in result["scenes"]:
                for part in scene["regimes"] if scene["scene"] in BUNDLED else []:
                    for answer in part["answers"]:
                        if part["regime"] == regime and answer["question"] == question and answer["contestant"] in logs:
                            logs[answer["contestant"]].append(math.log(answer["median_microseconds"]))
            own, other = (math.exp(sum(each) / len(each)) for each in logs.values())
            wanted[name] += [two_digits(own), two_digits(other / own)]
    return list(breaches_of(rows_of(page), wanted, "data/benchmark/pairs.json"))


def section(page, title):
    return page.partition(f"\n## {title}\n")[2].split("\n## ")[0]


def figures_breaches(root, page):
    """Rows of different tables have the same names: each is looked for in its own section."""
    return (broad_phase_breaches(root, section(page, "Moving boxes beside other libraries")) +
            pairs_breaches(root, section(page, "Two meshes beside other libraries")))
