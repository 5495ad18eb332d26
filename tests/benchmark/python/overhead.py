"""What a call from Python costs over the same call from C++: overhead.py PROGRAM MESHES [--poses N] [--rounds N]

Both take turns, round by round; medians. A batch's ratio is of wall clocks on all threads.
"""

import argparse
import json
import statistics
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any, Dict, List

import graze
import numpy as np

KINDS = {"far": (1, 0, 0), "near": (0.0145, 0, 0.004), "touch": (0, 0, 0.002)}
SINGLES = 20_000


def seconds(ask: Any) -> float:
    began = time.perf_counter()
    ask()
    return time.perf_counter() - began


def of_python(bolt: graze.Mesh, nut: graze.Mesh, poses: Any, size: int) -> List[Dict[str, float]]:
    results = []
    for pose in poses:
        many = np.tile(pose, (size, 1, 1))

        def singles(pose: Any = pose) -> None:
            for _ in range(SINGLES):
                graze.intersects(bolt, (nut, pose))

        single = seconds(singles) / SINGLES
        answers: List[Any] = []
        batch = seconds(lambda many=many, answers=answers: answers.append(graze.intersects(bolt, (nut, many))))
        results.append({"single": single, "batch": batch, "hits": int(answers[0].sum())})
    return results


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
        command = [options.program, *files, Path(folder) / "poses.npy", str(options.poses)]
        for _ in range(options.rounds):
            python.append(of_python(bolt, nut, poses, options.poses))
            native.append(json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout))
    print(f"{'':8}{'single, us':>12}{'C++':>8}{'more':>8}{'batch, s':>12}{'C++':>8}{'ratio':>8}")
    for i, kind in enumerate(KINDS):
        if python[0][i]["hits"] != native[0][i]["hits"]:
            raise SystemExit(f"{kind}: {python[0][i]['hits']} hits, and in C++ {native[0][i]['hits']}")
        single, batch = (statistics.median(run[i][name] for run in python) for name in ("single", "batch"))
        single_native, batch_native = (statistics.median(run[i][name] for run in native) for name in ("single", "batch"))
        print(
            f"{kind:8}{1e6 * single:12.3f}{1e6 * single_native:8.3f}{1e6 * (single - single_native):8.3f}"
            f"{batch:12.3f}{batch_native:8.3f}{batch / batch_native:8.3f}"
        )


if __name__ == "__main__":
    main()
