"""An arm of six links in ten thousand states: which links touch which, in which states.

Links are meshes in frames of their own; forward kinematics give a pose for each link and state, as arrays. Neighbours
share a joint and always touch there, so that they are not asked.
"""

from typing import Any, List, Tuple

import graze
import numpy as np
from numpy.typing import NDArray

STATES = 10_000
LENGTHS = (0.3, 0.25, 0.25, 0.2, 0.2, 0.12)  # metres, along each link's z axis
NAMES = ("base", "shoulder", "elbow", "forearm", "wrist", "hand")


def tube(length: float, radius: float, sides: int = 24) -> graze.Mesh:
    """A closed prism around the z axis, from z = 0 to `length`."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
    bottom = np.column_stack([ring, np.zeros(sides)])
    top = np.column_stack([ring, np.full(sides, length)])
    faces: List[Tuple[int, int, int]] = []
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(i, j, sides + i), (j, sides + j, sides + i), (2 * sides, j, i), (2 * sides + 1, sides + i, sides + j)]
    return graze.Mesh(np.vstack([bottom, top, [[0, 0, 0], [0, 0, length]]]), faces)


def turns(axis: int, angles: NDArray[np.float64]) -> Any:
    """Rotations about a coordinate axis, of the shape (n, 4, 4)."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    poses = np.tile(np.eye(4), (len(angles), 1, 1))
    poses[:, u, u] = poses[:, v, v] = np.cos(angles)
    poses[:, v, u] = np.sin(angles)
    poses[:, u, v] = -np.sin(angles)
    return poses


def poses_of_links(angles: NDArray[np.float64]) -> List[Any]:
    """Forward kinematics: for each link its poses in all states."""
    frame = np.tile(np.eye(4), (len(angles), 1, 1))
    poses = []
    for link, length in enumerate(LENGTHS):
        frame = frame @ turns((2, 1, 0, 1, 0, 1)[link], angles[:, link])
        poses.append(frame)
        step = np.eye(4)
        step[2, 3] = length
        frame = frame @ step
    return poses


def main() -> None:
    random = np.random.default_rng(7)
    angles = random.uniform(-2.6, 2.6, (STATES, len(LENGTHS)))
    links = [tube(length, 0.05 - 0.005 * i) for i, length in enumerate(LENGTHS)]
    poses = poses_of_links(angles)

    touching: List[List[str]] = [[] for _ in range(STATES)]
    for a in range(len(links)):
        for b in range(a + 2, len(links)):
            hits = graze.intersects((links[a], poses[a]), (links[b], poses[b]))  # a pose of each, in each state
            for state in np.flatnonzero(hits):
                touching[state].append(f"{NAMES[a]}-{NAMES[b]}")
            print(f"{NAMES[a]:>9} and {NAMES[b]:<9} touch in {hits.sum():5} of {STATES} states")
    clear = sum(not pairs for pairs in touching)
    print(f"{clear} states are clear; the first that is not is {next(i for i, pairs in enumerate(touching) if pairs)}:")
    print(next(pairs for pairs in touching if pairs))


if __name__ == "__main__":
    main()
