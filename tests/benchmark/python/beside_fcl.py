"""graze and FCL in the same loop of Python: beside_fcl.py MODULES MESHES [--poses N] [--rounds N] [--output FILE]

Bolt and nut, asked whether they intersect and how far they are, pose by pose through a thin binding of FCL's C++
library, pose by pose through the package, and by its batches on one thread and on all. They take turns, round by round;
microseconds for a pose, medians of the rounds: of the processor's time, which a busy machine disturbs less than a clock,
and by the clock for all threads. Answers are compared: a difference is told, and ends it.
"""

import argparse
import importlib
import json
import os
import platform
import statistics
import sys
import time
from pathlib import Path
from typing import Any, Callable, Dict, List

import graze
import numpy as np

WAYS = ("fcl", "single", "batch, one thread", "batch")
FEWER = {"intersects": 1, "distance": 100}
"""Distances take longer: so many times fewer are asked."""


def poses_of(count: int) -> Dict[str, Any]:
    """By name: apart, close by, touching, and anywhere around the bolt, a fifth of which touch."""
    kinds: Dict[str, Any] = {}
    for name, place in {"far": (1, 0, 0), "near": (0.0145, 0, 0.004), "touching": (0, 0, 0.002)}.items():
        kinds[name] = np.tile(np.eye(4), (count, 1, 1))
        kinds[name][:, :3, 3] = place
    kinds["mixed"] = np.tile(np.eye(4), (count, 1, 1))
    kinds["mixed"][:, :3, 3] = np.random.default_rng(1).uniform(-0.02, 0.02, (count, 3))
    return kinds


def ways_to_ask(question: str, bolt: graze.Mesh, nut: graze.Mesh, fcl: Any, poses: Any) -> Dict[str, Callable[[], Any]]:
    query = getattr(graze, question)
    of_fcl = fcl.collide if question == "intersects" else fcl.distance
    value = (lambda answer: answer) if question == "intersects" else (lambda answer: answer.distance)
    return {
        "fcl": lambda: [of_fcl(pose) for pose in poses],
        "single": lambda: [value(query(bolt, (nut, pose))) for pose in poses],
        "batch, one thread": lambda: value(query(bolt, (nut, poses), threads=1)),
        "batch": lambda: value(query(bolt, (nut, poses))),
    }


def compare(question: str, kind: str, answers: Dict[str, Any]) -> None:
    mine, theirs = np.asarray(answers["single"]), np.asarray(answers["fcl"])
    for way in ("batch, one thread", "batch"):
        if not np.array_equal(mine, answers[way]):
            raise SystemExit(f"{question}, {kind}: {way} and single differ")
    if question == "intersects":
        different = int((mine != theirs).sum())
    else:
        different = int((abs(mine - theirs) > 1e-9).sum())
    if different:
        raise SystemExit(f"{question}, {kind}: graze and FCL differ in {different} of {len(mine)} poses")


def measure(options: argparse.Namespace, fcl: Any) -> List[Dict[str, Any]]:
    bolt, nut = (graze.load_mesh(options.meshes / name) for name in ("bolt.obj", "nut.stl"))
    rows = []
    for question, fewer in FEWER.items():
        for kind, poses in poses_of(max(options.poses // fewer, 1)).items():
            ways = ways_to_ask(question, bolt, nut, fcl, poses)
            compare(question, kind, {way: ask() for way, ask in ways.items()})  # which builds all that is built once
            times: Dict[str, List[float]] = {way: [] for way in WAYS}
            for _ in range(options.rounds):
                for way, ask in ways.items():
                    clock = time.perf_counter if way == "batch" else time.process_time
                    began = clock()
                    ask()
                    times[way].append(1e6 * (clock() - began) / len(poses))
            medians = {way: round(statistics.median(taken), 4) for way, taken in times.items()}
            rows.append({"question": question, "poses": kind, "count": len(poses), "us": medians})
            print(as_text(rows[-1]), flush=True)
    return rows


def as_text(row: Dict[str, Any]) -> str:
    numbers = [row["us"][way] for way in WAYS]
    ratios = [numbers[0] / number for number in numbers[1:]]
    return f"{row['question']:11}{row['poses']:9}" + "".join(f"{number:19.2f}" for number in (*numbers, *ratios))


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("modules", type=Path, help="where graze_benchmark_fcl was built")
    parser.add_argument("meshes", type=Path)
    parser.add_argument("--poses", type=int, default=20_000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--output", type=Path)
    options = parser.parse_args()
    sys.path.insert(0, str(options.modules))
    fcl = importlib.import_module("graze_benchmark_fcl").Pair(*(str(options.meshes / name) for name in ("bolt.obj", "nut.stl")))
    columns = ("fcl, us", *(f"{way}, us" for way in WAYS[1:]), *(f"fcl / {way}" for way in WAYS[1:]))
    print(f"{'':20}" + "".join(f"{column:>19}" for column in columns))
    rows = measure(options, fcl)
    about = {"processor": processor(), "threads": os.cpu_count(), "load": os.getloadavg()[0], "rounds": options.rounds}
    if options.output:
        options.output.write_text(json.dumps({**about, "rows": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
