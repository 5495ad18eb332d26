"""What the command writes for numpy: `graze pair --output`, and the package says the same."""

import json
import os
import subprocess

import graze
import numpy as np
import pytest
from conftest import MESHES, random_poses

COMMAND = os.environ.get("GRAZE_COMMAND", "")


@pytest.fixture(scope="module")
def poses():
    return random_poses(500, 0.02, seed=50)


@pytest.mark.outside
@pytest.mark.parametrize("rows", [3, 4])
def test_its_arrays_are_the_answers_of_the_package(bolt, nut, poses, tmp_path, rows):
    if not COMMAND:
        pytest.skip("GRAZE_COMMAND does not say where the command graze is")
    np.save(tmp_path / "poses.npy", poses[:, :rows])

    def told(query):
        files = [str(MESHES / "bolt.obj"), str(MESHES / "nut.stl"), "--poses", "poses.npy", "--json"]
        command = [COMMAND, "pair", *files, "--query", query, "--output", f"{query}.npy"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
        return json.loads(done.stdout), np.load(tmp_path / f"{query}.npy")

    hits = graze.intersects(bolt, (nut, poses))
    summary, answers = told("any")
    assert answers.dtype == np.bool_ and np.array_equal(answers, hits) and 0 < hits.sum() < len(hits)
    assert (summary["poses"], summary["intersecting"]) == (500, hits.sum())
    summary, answers = told("distance")
    expected = graze.distance(bolt, (nut, poses)).distance
    assert answers.dtype == np.float64 and answers.tobytes() == expected.tobytes()
    assert summary["least_distance"] == expected.min() and summary["nearest_pose"] == np.argmin(expected)
    _, answers = told("pairs")
    assert answers.dtype == np.dtype([("intersects", np.bool_), ("pairs", np.uint64)])
    assert np.array_equal(answers["intersects"], hits)
    assert np.array_equal(answers["pairs"], np.diff(graze.find_triangle_pairs(bolt, (nut, poses)).offsets))
