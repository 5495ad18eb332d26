"""A part of a sweep, for a job of many tasks that share a file system: part_of_sweep.py POSES PART PARTS

Each task maps the file, asks its own part of it on all the threads that it was given, and writes hits.PART.npy beside
it. One that was killed goes on where it was when it is run again. Without arguments: a small file, in four parts, put
together again.
"""

import os
import sys
import tempfile
from pathlib import Path
from typing import Any

import graze
import numpy as np

MESHES = Path(__file__).resolve().parents[2] / "data" / "meshes"


def sweep_part(file: Path, part: int, parts: int) -> Path:
    poses = np.load(file, mmap_mode="r")  # of which the system reads what is asked
    first, last = (len(poses) * k // parts for k in (part, part + 1))
    bolt, nut = graze.load_mesh(MESHES / "bolt.obj"), graze.load_mesh(MESHES / "nut.stl")
    threads = int(os.environ.get("SLURM_CPUS_PER_TASK", "0"))  # 0: all that the task has
    touches = graze.over_poses(graze.intersects, bolt, nut, threads=threads)
    out: Path = graze.sweep(touches, poses[first:last], out=file.with_name(f"hits.{part:05}.npy"), chunk=1 << 20)
    return out


def main() -> None:
    if len(sys.argv) == 4:
        print(sweep_part(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])))
        return
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "poses.npy"
        poses: Any = np.tile(np.eye(4), (10_000, 1, 1))
        poses[:, :3, 3] = np.random.default_rng(1).uniform(-0.02, 0.02, (len(poses), 3))
        np.save(file, poses)
        hits = np.concatenate([np.load(sweep_part(file, part, 4)) for part in range(4)])
        print(hits.sum(), "of", len(hits), "poses touch")


if __name__ == "__main__":
    main()
