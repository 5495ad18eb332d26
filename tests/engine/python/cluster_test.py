"""Sweeps on clusters whose processes are killed: Dask's asks again, an MPI job ends and the next goes on."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import graze
import numpy as np
import pytest
from conftest import SWEPT, begins_in, cube


def kill_worker_once(path):
    """Ends the process that it runs in, the first time."""
    try:
        os.close(os.open(path, os.O_CREAT | os.O_EXCL))
    except FileExistsError:
        return
    os.kill(os.getpid(), signal.SIGKILL)


class Killing:
    """Ends its process once, when it was asked so many times."""

    def __init__(self, query, path, after=0):
        self.query, self.path, self.after = query, str(path), after

    def __call__(self, poses):
        asked_by[self.path] = asked_by.get(self.path, 0) + 1
        if asked_by[self.path] > self.after:
            kill_worker_once(self.path)
        return self.query(poses)


asked_by = {}  # in this process, as each task has its own copy of the query


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_of_dask_loses_a_worker(gaps, poses, tmp_path):
    distributed = pytest.importorskip("distributed")
    settings = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**settings) as cluster, distributed.Client(cluster) as client:
        query = Killing(gaps, tmp_path / "killed")
        paths = graze.sweep(query, poses, out=tmp_path / "gap.npy", chunk=50, executor=client)
        assert (tmp_path / "killed").exists()
        expected = gaps(poses)
        for name, path in paths.items():
            assert np.array_equal(np.load(path), getattr(expected, name)), name
        least = graze.sweep(gaps, poses, chunk=50, executor=client, reduce=graze.least_distance())
        assert least == (expected.distance.min(), int(np.argmin(expected.distance)))


def a_million_poses(reach, seed):
    """Of quaternions: a loop over random_poses() would take as long as the sweep."""
    random = np.random.default_rng(seed)
    w, x, y, z = (q := random.normal(size=(4, 1_000_000))) / np.linalg.norm(q, axis=0)
    poses = np.zeros((1_000_000, 4, 4))
    poses[:, 0, :3] = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], axis=1)
    poses[:, 1, :3] = np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], axis=1)
    poses[:, 2, :3] = np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], axis=1)
    poses[:, :3, 3] = random.uniform(-reach, reach, (1_000_000, 3))
    poses[:, 3, 3] = 1
    return poses


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("kind", ["touches", "gaps"])
def test_a_million_poses_on_a_cluster_that_loses_a_worker(touches, tmp_path, kind):
    """Killed from outside, while it has chunks, by a third of the way."""
    distributed = pytest.importorskip("distributed")
    poses = a_million_poses(0.02 if kind == "touches" else 1.5, seed=41)
    query = touches if kind == "touches" else graze.over_poses(graze.distance, cube(), cube())
    np.save(tmp_path / "poses.npy", poses)
    killed = []
    settings = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**settings) as cluster, distributed.Client(cluster) as client:
        workers = client.run(os.getpid)
        assert len(set(workers.values())) == 2

        def tell(done, total):
            assert total == 1_000_000
            if done > total / 3 and not killed:
                killed.append(next(iter(workers.values())))
                os.kill(killed[0], signal.SIGKILL)

        out = graze.sweep(query, tmp_path / "poses.npy", out=tmp_path / "answers.npy", chunk=10_000, executor=client, progress=tell)
        assert killed and killed[0] not in client.run(os.getpid).values()
    expected = query(poses)
    files = {"answers": out} if kind == "touches" else out
    for name, path in files.items():
        answers = np.load(path)
        whole = expected if kind == "touches" else getattr(expected, name)
        assert answers.dtype == whole.dtype and answers.tobytes() == whole.tobytes(), name
    assert sorted(begins_in(tmp_path / "answers.npy.journal")) == list(range(0, 1_000_000, 10_000))  # each once


MPI = """
import sys
import graze, numpy as np
from mpi4py.futures import MPIPoolExecutor
from conftest import MESHES
from cluster_test import Killing

if __name__ == "__main__":
    bolt, nut = graze.load_mesh(MESHES / "bolt.obj"), graze.load_mesh(MESHES / "nut.stl")
    query = graze.over_poses(graze.intersects, bolt, nut, threads=1)
    with MPIPoolExecutor() as executor:
        if sys.argv[1:] == ["dies"]:
            graze.sweep(Killing(query, "killed", after=8), "poses.npy", out="hits.npy", chunk=50, executor=executor)
        else:
            print(graze.sweep(query, "poses.npy", chunk=50, executor=executor, reduce=graze.count()))
            graze.sweep(query, "poses.npy", out="hits.npy", chunk=50, executor=executor)
"""


@pytest.fixture
def ask_ranks(poses, tmp_path):
    """Runs that program on three ranks."""
    pytest.importorskip("mpi4py")
    if shutil.which("mpiexec") is None:
        pytest.skip("there is no mpiexec")
    np.save(tmp_path / "poses.npy", poses)
    (tmp_path / "program.py").write_text(MPI)
    paths = os.pathsep.join([str(Path(__file__).parent), str(Path(graze.__file__).parents[1])])
    command = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "3"]
    command += [sys.executable, "-m", "mpi4py.futures", "program.py"]
    settings = {"cwd": tmp_path, "env": {**os.environ, "PYTHONPATH": paths}, "timeout": 300, "check": False}
    return lambda *words: subprocess.run([*command, *words], capture_output=True, text=True, **settings)


@pytest.mark.slow
def test_ranks_of_mpi(touches, poses, tmp_path, ask_ranks):
    done = ask_ranks()
    assert done.returncode == 0, done.stdout + done.stderr
    assert int(done.stdout) == touches(poses).sum()
    assert np.array_equal(np.load(tmp_path / "hits.npy"), touches(poses))


@pytest.mark.slow
def test_a_job_of_mpi_that_loses_a_rank_ends_and_the_next_goes_on(touches, poses, tmp_path, ask_ranks):
    began = time.monotonic()
    assert ask_ranks("dies").returncode != 0 and time.monotonic() - began < 120
    assert (tmp_path / "killed").exists() and not (tmp_path / "hits.npy").exists()
    before = begins_in(tmp_path / "hits.npy.journal")
    assert 0 < len(before) < SWEPT // 50  # some chunks were done, and not all
    done = ask_ranks("dies")
    assert done.returncode == 0, done.stdout + done.stderr
    assert np.load(tmp_path / "hits.npy").tobytes() == touches(poses).tobytes()
    begins = begins_in(tmp_path / "hits.npy.journal")
    assert begins[: len(before)] == before and sorted(begins) == list(range(0, SWEPT, 50))  # each once
