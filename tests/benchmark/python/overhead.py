"""What a call from Python costs over the same call from C++: overhead.py PROGRAM MESHES [--poses N] [--rounds N]

Both take turns, round by round; medians of the processors' time, which a busy machine disturbs less than a clock, and of
the wall clock for batches on all threads.
"""

import argparse
import json
import statistics
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any, Dict, List, Tuple

import graze
import numpy as np

KINDS = {"far": (1, 0, 0), "near": (0.0145, 0, 0.004), "touch": (0, 0, 0.002)}
SINGLES = 20_000


def seconds(ask: Any) -> Tuple[float, float]:
    """Of the wall clock, and of the processors on all threads."""
    began, spent = time.perf_counter(), time.process_time()
    ask()
    return time.perf_counter() - began, time.process_time() - spent


def of_python(bolt: graze.Mesh, nut: graze.Mesh, poses: Any, size: int) -> List[Dict[str, float]]:
    results: List[Dict[str, float]] = []
    for pose in poses:
        many = np.tile(pose, (size, 1, 1))

        def singles(pose: Any = pose) -> None:
            for _ in range(SINGLES):
                graze.intersects(bolt, (nut, pose))

        single, single_cpu = (taken / SINGLES for taken in seconds(singles))
        answers: List[Any] = []
        batch, batch_cpu = seconds(lambda many=many, answers=answers: answers.append(graze.intersects(bolt, (nut, many))))
        took: Dict[str, float] = {"single": single, "single_cpu": single_cpu, "batch": batch, "batch_cpu": batch_cpu}
        results.append({**took, "hits": float(answers[0].sum())})
    return results


def of_points(bolt: graze.Mesh, points: Any) -> List[Dict[str, float]]:
    """Rays from points to the origin, and what of the mesh is nearest to them."""
    answers: List[Any] = []
    cast, cast_cpu = seconds(lambda: answers.append(graze.cast_rays(bolt, points, -points)))
    near, near_cpu = seconds(lambda: answers.append(graze.nearest_points(bolt, points)))
    return [
        {"batch": cast, "batch_cpu": cast_cpu, "hits": float(answers[0].is_hit.sum())},
        {"batch": near, "batch_cpu": near_cpu, "hits": float((answers[1].triangle < 1000).sum())},
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path)
    parser.add_argument("meshes", type=Path)
    parser.add_argument("--poses", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    files = [options.meshes / "bolt.obj", options.meshes / "nut.stl"]
    bolt, nut = (graze.load_mesh(file) for file in files)
    poses = np.tile(np.eye(4), (len(KINDS), 1, 1))
    poses[:, :3, 3] = list(KINDS.values())
    python, native = [], []
    with tempfile.TemporaryDirectory() as folder:
        np.save(Path(folder) / "poses.npy", poses)
        points = np.random.default_rng(1).uniform(-0.02, 0.02, (options.poses, 3))
        points.tofile(Path(folder) / "points")
        command = [options.program, *files, Path(folder) / "poses.npy", Path(folder) / "points", str(options.poses)]
        for _ in range(options.rounds):
            python.append(of_python(bolt, nut, poses, options.poses) + of_points(bolt, points))
            native.append(json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout))
    columns = ("single, us", "C++", "more", "batch, CPU s", "C++", "ratio", "batch, s", "C++", "ratio")
    print(f"{'':8}" + "".join(f"{column:>13}" for column in columns))
    for i, kind in enumerate([*KINDS, "rays", "points"]):
        if python[0][i]["hits"] != native[0][i]["hits"]:
            raise SystemExit(f"{kind}: {python[0][i]['hits']} hits, and in C++ {native[0][i]['hits']}")

        def median(runs: List[List[Dict[str, float]]], name: str, i: int = i) -> float:
            return statistics.median(run[i][name] for run in runs)

        numbers = []
        if kind in KINDS:
            single, single_native = (1e6 * median(runs, "single_cpu") for runs in (python, native))
            numbers = [single, single_native, single - single_native]
        for name in ("batch_cpu", "batch"):
            mine, theirs = median(python, name), median(native, name)
            numbers += [mine, theirs, mine / theirs]
        blank = " " * (0 if kind in KINDS else 39)
        print(f"{kind:8}{blank}" + "".join(f"{number:13.3f}" for number in numbers))


if __name__ == "__main__":
    main()
