"""Sweeps over more poses than are asked at once: files, reductions, kills, executors."""

import concurrent.futures
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import graze
import numpy as np
import pytest
from conftest import MESHES, SWEPT, begins_in, translation

class Counting:
    """A query that writes down which poses it is asked, by their x; and fails after so many chunks."""

    def __init__(self, query, path, most=10**9):
        self.query, self.path, self.most = query, str(path), most

    def __getstate__(self):
        return {"query": self.query, "path": self.path, "most": 0}  # another limit is no other query

    def __call__(self, poses):
        if self.most == 0:
            raise RuntimeError("enough")
        self.most -= 1
        with open(self.path, "a") as file:
            file.writelines(f"{x!r}\n" for x in poses[:, 0, 3].tolist())
        return self.query(poses)


def asked(path):
    return [float(line) for line in Path(path).read_text().split()]


def test_sources_of_poses(touches, poses, tmp_path):
    dask_array = pytest.importorskip("dask.array")
    expected = touches(poses)
    np.save(tmp_path / "poses.npy", poses)
    np.save(tmp_path / "rows.npy", poses[:, :3])
    sources = {
        "array": poses,
        "three rows": poses[:, :3],
        "name": tmp_path / "poses.npy",
        "text": str(tmp_path / "rows.npy"),
        "map": np.load(tmp_path / "poses.npy", mmap_mode="r"),
        "dask": dask_array.from_array(poses, chunks=(130, 4, 4)),
        "generator": (pose for pose in poses),
        "parts": (poses[i : i + 77] for i in range(0, SWEPT, 77)),
        "list": list(poses),
    }
    for name, source in sources.items():
        assert np.array_equal(graze.sweep(touches, source, chunk=64), expected), name


def test_reductions(touches, gaps, poses):
    hits, distances = touches(poses), gaps(poses).distance
    assert graze.sweep(touches, poses, reduce=graze.count(), chunk=33) == hits.sum() > 0
    first = int(np.argmax(hits))
    assert graze.sweep(touches, poses, reduce=graze.first_hit(), chunk=7) == first
    least = graze.sweep(gaps, poses, reduce=graze.least_distance(), chunk=33)
    assert least == (distances.min(), int(np.argmin(distances)))
    far = np.tile(translation(1, 0, 0), (5, 1, 1))
    assert graze.sweep(touches, far, reduce=graze.first_hit()) is None
    nothing = np.empty((0, 4, 4))
    assert graze.sweep(touches, nothing, reduce=graze.count()) == 0
    assert graze.sweep(touches, nothing, reduce=graze.first_hit()) is None
    assert graze.sweep(gaps, nothing, reduce=graze.least_distance()) is None
    assert graze.sweep(touches, nothing).shape == (0,)


def test_after_a_first_hit_nothing_is_asked(touches, poses, tmp_path):
    query = Counting(touches, tmp_path / "asked")
    first = graze.sweep(query, poses, reduce=graze.first_hit(), chunk=5)
    assert len(asked(tmp_path / "asked")) == 5 * (first // 5 + 1)


def test_files_of_answers(touches, gaps, poses, tmp_path):
    assert graze.sweep(touches, poses, out=tmp_path / "hits.npy", chunk=64) == tmp_path / "hits.npy"
    hits = np.load(tmp_path / "hits.npy", mmap_mode="r")
    assert hits.dtype == np.bool_ and np.array_equal(hits, touches(poses))
    paths = graze.sweep(gaps, (pose for pose in poses), out=tmp_path / "gap.npy", chunk=64)
    assert paths["point_a"] == tmp_path / "gap.point_a.npy" and not list(tmp_path.glob("*.part"))
    expected = gaps(poses)
    for name, path in paths.items():
        assert np.array_equal(np.load(path), getattr(expected, name)), name
    assert graze.sweep(gaps, poses, chunk=64) == expected


def test_a_store_of_answers(touches, gaps, poses, tmp_path):
    zarr = pytest.importorskip("zarr", reason="the package zarr, python3-zarr of Debian, is not there")
    out = graze.sweep(touches, poses, out=tmp_path / "hits.zarr", chunk=64)
    hits = zarr.open_array(str(out), mode="r")
    assert out == tmp_path / "hits.zarr" and hits.chunks == (64,) and hits.dtype == np.bool_
    assert np.array_equal(hits[:], touches(poses)) and not list(tmp_path.glob("*.part"))
    out = graze.sweep(gaps, (pose for pose in poses), out=tmp_path / "gap.zarr", chunk=64)
    group, expected = zarr.open_group(str(out), mode="r"), gaps(poses)
    assert sorted(group.array_keys()) == sorted(expected._fields) and group["point_a"].chunks == (64, 3)
    for name in expected._fields:
        assert np.array_equal(group[name][:], getattr(expected, name)), name
    stored = zarr.open_array(str(tmp_path / "poses.zarr"), mode="w", shape=poses.shape, chunks=(70, 4, 4), dtype="f8")
    stored[:] = poses
    assert np.array_equal(graze.sweep(touches, stored, chunk=64), touches(poses))
    with pytest.raises(graze.InputError, match="is there already"):
        graze.sweep(touches, poses, out=tmp_path / "poses.zarr")


def test_a_store_needs_its_package(touches, poses, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(graze.InputError, match="out: .*a.zarr needs the package zarr"):
        graze.sweep(touches, poses, out=tmp_path / "a.zarr")


def test_a_store_that_failed_goes_on(gaps, poses, tmp_path):
    zarr = pytest.importorskip("zarr", reason="the package zarr, python3-zarr of Debian, is not there")
    log, out = tmp_path / "asked", tmp_path / "gap.zarr"
    with pytest.raises(RuntimeError, match="enough"):
        graze.sweep(Counting(gaps, log, most=6), poses, chunk=64, out=out)
    assert len(asked(log)) == 6 * 64 and not out.exists()
    with pytest.raises(graze.InputError, match="another query"):
        graze.sweep(Counting(gaps, log), poses, chunk=65, out=out)
    assert graze.sweep(Counting(gaps, log), poses, chunk=64, out=out) == out
    assert asked(log) == poses[:, 0, 3].tolist()  # all, in order, none twice
    assert np.array_equal(zarr.open_group(str(out), mode="r")["distance"][:], gaps(poses).distance)
    assert graze.sweep(Counting(gaps, log, most=0), poses, chunk=64, out=out) == out
    shutil.rmtree(out)
    with pytest.raises(graze.InputError, match="is gone"):
        graze.sweep(Counting(gaps, log, most=0), poses, chunk=64, out=out)


@pytest.mark.parametrize("reduce", [None, graze.count()])
def test_a_sweep_that_failed_goes_on(touches, poses, tmp_path, reduce):
    log = tmp_path / "asked"
    settings = {"out": tmp_path / "hits.npy"} if reduce is None else {"reduce": reduce, "journal": tmp_path / "journal"}
    with pytest.raises(RuntimeError, match="enough"):
        graze.sweep(Counting(touches, log, most=6), poses, chunk=64, **settings)
    assert len(asked(log)) == 6 * 64 and not (tmp_path / "hits.npy").exists()
    result = graze.sweep(Counting(touches, log), poses, chunk=64, **settings)
    assert asked(log) == poses[:, 0, 3].tolist()  # all, in order, none twice
    if reduce is None:
        assert np.array_equal(np.load(result), touches(poses))
    else:
        assert result == touches(poses).sum()
    again = graze.sweep(Counting(touches, log, most=0), poses, chunk=64, **settings)
    assert again == result and len(asked(log)) == SWEPT


def test_a_journal_of_another_sweep_is_refused(touches, gaps, poses, tmp_path):
    out = tmp_path / "hits.npy"
    graze.sweep(touches, poses, out=out, chunk=64)
    with pytest.raises(graze.InputError, match="another query"):
        graze.sweep(gaps, poses, out=out, chunk=64)
    with pytest.raises(graze.InputError, match="another query"):
        graze.sweep(touches, poses, out=out, chunk=65)
    changed = poses.copy()
    changed[70, 0, 3] += 1
    with pytest.raises(graze.InputError, match="poses: those from 64 on"):
        graze.sweep(touches, changed, out=out, chunk=64)
    out.unlink()
    with pytest.raises(graze.InputError, match="is gone"):
        graze.sweep(touches, poses, out=out, chunk=64)
    (tmp_path / "hits.npy.journal").write_text("nonsense\n")
    with pytest.raises(graze.InputError, match="is no journal"):
        graze.sweep(touches, poses, out=out, chunk=64)


def test_bad_sweeps(touches, poses, tmp_path):
    with pytest.raises(graze.InputError, match="chunk"):
        graze.sweep(touches, poses, chunk=0)
    with pytest.raises(graze.InputError, match="out: is not taken beside reduce"):
        graze.sweep(touches, poses, out=tmp_path / "a.npy", reduce=graze.count())
    with pytest.raises(graze.InputError, match="journal"):
        graze.sweep(touches, poses, journal=tmp_path / "j")
    with pytest.raises(graze.InputError, match=r"poses: the shape \(4, 4\)"):
        graze.sweep(touches, np.eye(4))
    with pytest.raises(graze.InputError, match="query: has 1 answers to 64 poses"):
        graze.sweep(lambda part: np.zeros(1), poses, chunk=64)
    with pytest.raises(graze.InputError, match="query: cannot be pickled"):
        graze.sweep(lambda part: part, poses, out=tmp_path / "b.npy")
    with pytest.raises(graze.PoseError, match="pose 3 of b"):
        graze.sweep(touches, np.where(np.arange(SWEPT)[:, None, None] == 67, 2, 1) * poses, chunk=64)


def test_progress(touches, poses):
    told = []
    graze.sweep(touches, poses, chunk=300, progress=lambda done, total: told.append((done, total)))
    assert told == [(300, 1000), (600, 1000), (900, 1000), (1000, 1000)]
    graze.sweep(touches, iter(poses), chunk=600, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (1000, None)


def test_executors(touches, gaps, poses, tmp_path):
    with concurrent.futures.ThreadPoolExecutor(3) as executor:
        assert np.array_equal(graze.sweep(touches, poses, chunk=10, executor=executor), touches(poses))
        least = graze.sweep(gaps, poses, chunk=10, executor=executor, reduce=graze.least_distance())
        assert least == graze.sweep(gaps, poses, reduce=graze.least_distance())
        first = graze.sweep(touches, poses, chunk=10, executor=executor, reduce=graze.first_hit())
        assert first == int(np.argmax(touches(poses)))
        out = graze.sweep(touches, iter(poses), chunk=10, executor=executor, out=tmp_path / "hits.npy")
        assert np.array_equal(np.load(out), touches(poses))
        with pytest.raises(RuntimeError, match="enough"):
            graze.sweep(Counting(touches, tmp_path / "log", most=2), poses, chunk=10, executor=executor)


KILLED = """
import time
import graze, numpy as np
from sweep_test import Counting
from conftest import MESHES

if __name__ == "__main__":
    bolt, nut = graze.load_mesh(MESHES / "bolt.obj"), graze.load_mesh(MESHES / "nut.stl")
    query = Counting(graze.over_poses(graze.intersects, bolt, nut), "asked")
    tell = lambda done, total: (time.sleep(0.02), print(done, flush=True))
    graze.sweep(query, "poses.npy", out="OUT", chunk=10, progress=tell)
"""


@pytest.mark.parametrize("ending", ["npy", "zarr"])
def test_a_sweep_that_was_killed_goes_on(touches, poses, tmp_path, ending):
    out = tmp_path / f"hits.{ending}"
    if ending == "zarr":
        zarr = pytest.importorskip("zarr", reason="the package zarr, python3-zarr of Debian, is not there")
    np.save(tmp_path / "poses.npy", poses)
    (tmp_path / "program.py").write_text(KILLED.replace("OUT", out.name))
    paths = os.pathsep.join([str(Path(__file__).parent), str(Path(graze.__file__).parents[1])])
    settings = {"cwd": tmp_path, "env": {**os.environ, "PYTHONPATH": paths}}
    for kill_at in ("30", "400", None):
        process = subprocess.Popen([sys.executable, "program.py"], stdout=subprocess.PIPE, text=True, **settings)
        for line in process.stdout:
            if line.strip() == kill_at:
                process.send_signal(signal.SIGKILL)
        process.stdout.close()
        assert process.wait() == (-signal.SIGKILL if kill_at else 0)
    assert np.array_equal(np.load(out) if ending == "npy" else zarr.open_array(str(out), mode="r")[:], touches(poses))
    times = np.unique(asked(tmp_path / "asked"), return_counts=True)[1]
    assert len(times) == SWEPT and (times > 1).sum() <= 20  # but for the chunks that the kills met
    assert sorted(begins_in(tmp_path / f"{out.name}.journal")) == list(range(0, SWEPT, 10))
