"""Two meshes, one question, then ten thousand of them: does the nut touch the bolt?"""

from pathlib import Path

import graze
import numpy as np

MESHES = Path(__file__).resolve().parents[2] / "data" / "meshes"


def main() -> None:
    bolt = graze.load_mesh(MESHES / "bolt.obj")
    nut = graze.load_mesh(MESHES / "nut.stl")

    pose = np.eye(4)
    pose[:3, 3] = 0, 0, 0.002  # metres
    print("as it is:", graze.intersects(bolt, nut))
    print("moved up by 2 mm:", graze.intersects(bolt, (nut, pose)))
    found = graze.find_triangle_pairs(bolt, (nut, pose))
    print(len(found.pairs), "pairs of triangles meet, the first of them", found.pairs[0])

    poses = np.tile(np.eye(4), (10_000, 1, 1))
    poses[:, 2, 3] = np.linspace(0, 0.03, len(poses))  # all the way up and off
    hits = graze.intersects(bolt, (nut, poses))  # on all threads
    print(f"{hits.sum()} of {len(hits)} poses touch")

    turned = np.eye(4)
    turned[0, 0] = 1.1
    try:
        graze.intersects(bolt, (nut, turned))
    except graze.PoseError as error:
        print("refused:", error)


if __name__ == "__main__":
    main()
