"""What the tests of the package share: the meshes of data/ and poses of them."""

import json
import os
from pathlib import Path
from typing import Any

import graze
import numpy as np
import pytest

SOURCES = Path(os.environ.get("GRAZE_SOURCES") or Path(__file__).resolve().parents[3])
MESHES = SOURCES / "data" / "meshes"


def translation(x: float, y: float, z: float) -> Any:
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def rotation(axis: Any, angle: float) -> Any:
    """Rodrigues' formula, as a pose."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    pose = np.eye(4)
    pose[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)
    return pose


def random_poses(count: int, reach: float, seed: int) -> Any:
    random = np.random.default_rng(seed)
    poses = np.stack([rotation(random.normal(size=3), random.uniform(0, np.pi)) for _ in range(count)])
    poses[:, :3, 3] = random.uniform(-reach, reach, (count, 3))
    return poses


def cube(edge: float = 1.0) -> Any:
    """A closed cube around the origin, of two triangles a face, counter-clockwise from outside."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) - 0.5
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4]]
    return graze.Mesh(edge * corners, faces + [[1, 5, 7], [1, 7, 3]])


@pytest.fixture(scope="session")
def bolt() -> Any:
    return graze.load_mesh(MESHES / "bolt.obj")


@pytest.fixture(scope="session")
def nut() -> Any:
    return graze.load_mesh(MESHES / "nut.stl")


@pytest.fixture
def unit_cube() -> Any:
    return cube()


SWEPT = 1000
"""Poses of sweeps."""


@pytest.fixture(scope="session")
def poses() -> Any:
    return random_poses(SWEPT, 0.02, seed=40)


@pytest.fixture(scope="session")
def touches(bolt: Any, nut: Any) -> Any:
    return graze.over_poses(graze.intersects, bolt, nut)


@pytest.fixture(scope="session")
def gaps(bolt: Any, nut: Any) -> Any:
    return graze.over_poses(graze.distance, bolt, nut)


def begins_in(journal: Path) -> Any:
    """Where the chunks of a sweep begin that are done, in the order in which they were. A last line that a kill cut short
    is none."""
    lines = [line for line in journal.read_text().splitlines(keepends=True) if line.endswith("\n")]
    return [row["begin"] for row in map(json.loads, lines) if "begin" in row]
