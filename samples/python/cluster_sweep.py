"""A million poses in a file, asked in chunks: how many touch, and how near the others come.

The same call takes an executor of concurrent.futures, mpi4py's MPIPoolExecutor, or a client of Dask:

    with distributed.Client("scheduler:8786") as client:
        graze.sweep(query, "poses.npy", out="gap.npy", executor=client)
"""

import tempfile
from pathlib import Path

import graze
import numpy as np

MESHES = Path(__file__).resolve().parents[2] / "data" / "meshes"
COUNT = 20_000  # a million takes a minute


def main() -> None:
    bolt, nut = graze.load_mesh(MESHES / "bolt.obj"), graze.load_mesh(MESHES / "nut.stl")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "poses.npy"
        poses = np.tile(np.eye(4), (COUNT, 1, 1))
        poses[:, 0, 3] = np.linspace(-0.05, 0.05, COUNT)
        poses[:, 2, 3] = 0.001
        np.save(file, poses)

        touches = graze.over_poses(graze.intersects, bolt, nut)
        print(graze.sweep(touches, file, reduce=graze.count()), "poses touch")
        print("the first is", graze.sweep(touches, file, reduce=graze.first_hit(), chunk=1024))

        gaps = graze.over_poses(graze.distance, bolt, nut)
        written = graze.sweep(gaps, file, out=Path(folder) / "gap.npy", chunk=4096)  # killed, it goes on from here
        distances = np.load(written["distance"], mmap_mode="r")
        print(f"the farthest is {distances.max():.4f} m away")


if __name__ == "__main__":
    main()
