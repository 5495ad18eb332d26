"""Two meshes, in one pose and in many: batches answer what single calls do, and errors name the pose."""

import signal
import threading
import time

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, rotation, translation


def test_touching_counts(unit_cube):
    assert graze.intersects(unit_cube, (unit_cube, translation(1, 0, 0))) is True
    assert graze.intersects(unit_cube, (unit_cube, translation(np.nextafter(1, 2), 0, 0))) is False
    assert not graze.intersects(unit_cube, (unit_cube, translation(1, 0, 0)), hit="crossing")
    assert not graze.intersects(unit_cube, cube(0.5))
    assert graze.intersects(unit_cube, cube(0.5), hit="solid")


@pytest.mark.parametrize("threads", [0, 1, 2])
@pytest.mark.parametrize("hit", ["touching", "crossing", "solid"])
def test_a_batch_answers_as_single_calls(bolt, nut, hit, threads):
    poses = random_poses(150, 0.02, seed=1)
    singles = [graze.intersects(bolt, (nut, pose), hit=hit) for pose in poses]
    answers = graze.intersects(bolt, (nut, poses), hit=hit, threads=threads)
    assert answers.dtype == np.bool_ and answers.shape == (150,)
    assert answers.tolist() == singles and 0 < answers.sum() < 150


def test_poses_on_either_side_and_on_both(bolt, nut):
    a, b = random_poses(100, 0.01, seed=2), random_poses(100, 0.01, seed=3)
    both = graze.intersects((bolt, a), (nut, b))
    assert both.tolist() == [graze.intersects((bolt, x), (nut, y)) for x, y in zip(a, b)]
    assert graze.intersects((bolt, a), nut).tolist() == [graze.intersects((bolt, x), nut) for x in a]
    with pytest.raises(graze.InputError, match="b: has 99 poses, and a has 100"):
        graze.intersects((bolt, a), (nut, b[:99]))


@pytest.mark.parametrize(
    "change",
    [
        lambda poses: poses[:, :3],
        lambda poses: np.asfortranarray(poses),
        lambda poses: poses.astype(">f8"),
        lambda poses: np.repeat(poses, 2, axis=0)[::2],
        lambda poses: poses.transpose(0, 2, 1).copy().transpose(0, 2, 1),
        lambda poses: list(poses),
    ],
)
def test_poses_in_any_layout(bolt, nut, change):
    poses = random_poses(50, 0.02, seed=4)
    assert np.array_equal(graze.intersects(bolt, (nut, change(poses))), graze.intersects(bolt, (nut, poses)))


def test_poses_of_other_numbers(unit_cube):
    assert graze.intersects(unit_cube, (unit_cube, np.eye(4, dtype=int)))
    assert graze.intersects(unit_cube, (unit_cube, np.eye(4, dtype=np.float32)))
    wide = rotation([1, 2, 3], 0.3).astype(np.float32)  # still rigid within 1e-6
    assert graze.intersects(unit_cube, (unit_cube, wide))


def test_no_poses_have_no_answers(unit_cube):
    assert graze.intersects(unit_cube, (unit_cube, np.empty((0, 4, 4)))).shape == (0,)
    lists = graze.find_triangle_pairs(unit_cube, (unit_cube, np.empty((0, 3, 4))))
    assert lists.offsets.tolist() == [0] and lists.pairs.shape == (0, 2)


@pytest.mark.parametrize(
    "pose, error, says",
    [
        (np.eye(3), graze.PoseError, r"pose of b: the shape \(3, 3\)"),
        (np.eye(4) * 2, graze.PoseError, "pose of b"),
        (np.diag([1.0, 1, -1, 1]), graze.PoseError, "pose of"),
        (np.full((4, 4), np.nan), graze.PoseError, "pose of"),
        (translation(np.inf, 0, 0), graze.PoseError, "pose of"),
        (np.eye(4, dtype=complex), graze.InputError, "pose of b: numbers of the type complex128"),
        ("up", graze.InputError, "pose of b"),
        (rotation([1, 2, 3], 0.3).astype(np.float16), graze.PoseError, "pose of"),
    ],
)
def test_what_is_no_pose_is_refused(unit_cube, pose, error, says):
    with pytest.raises(error, match=says):
        graze.intersects(unit_cube, (unit_cube, pose))


def test_the_first_bad_pose_of_many_is_named(unit_cube):
    poses = np.tile(np.eye(4), (5000, 1, 1))
    poses[4321] *= 2
    poses[4900, 0, 3] = np.nan
    for threads in (1, 2):
        for query in (graze.intersects, graze.find_triangle_pairs, graze.interiors_intersect):
            with pytest.raises(graze.PoseError, match="pose 4321 of b") as caught:
                query(unit_cube, (unit_cube, poses), threads=threads)
            assert caught.value.place.element == "pose" and caught.value.place.index == 4321


def test_bad_arguments_are_named(unit_cube):
    with pytest.raises(TypeError, match="a: int is neither"):
        graze.intersects(3, unit_cube)
    with pytest.raises(TypeError, match="b: tuple is neither"):
        graze.intersects(unit_cube, (unit_cube, np.eye(4), 3))
    with pytest.raises(graze.InputError, match='hit: \'soft\' is none of "touching", "crossing", "solid"'):
        graze.intersects(unit_cube, unit_cube, hit="soft")
    with pytest.raises(graze.InputError, match="threads: -1"):
        graze.intersects(unit_cube, (unit_cube, np.empty((0, 4, 4))), threads=-1)
    with pytest.raises(graze.InputError, match="limit: 1.5"):
        graze.find_triangle_pairs(unit_cube, unit_cube, limit=1.5)
    with pytest.raises(TypeError, match="work"):
        graze.intersects(unit_cube, unit_cube, work=3)
    with pytest.raises(TypeError, match="memory"):
        graze.intersects(unit_cube, unit_cube, memory=3)
    with pytest.raises(TypeError, match="progress"):
        graze.intersects(unit_cube, (unit_cube, np.empty((0, 4, 4))), progress=3)
    open_mesh = graze.Mesh(unit_cube.vertices, unit_cube.triangles[1:])
    with pytest.raises(graze.MeshError, match="boundary edges"):
        graze.intersects(unit_cube, (open_mesh, translation(9, 0, 0)), hit="solid")
    with pytest.raises(graze.MeshError, match="boundary edges"):
        graze.interiors_intersect(unit_cube, open_mesh)


def test_pairs_of_triangles(bolt, nut):
    poses = random_poses(40, 0.02, seed=5)
    lists = graze.find_triangle_pairs(bolt, (nut, poses))
    assert lists.is_complete.all() and lists.offsets[-1] == len(lists.pairs) > 0
    for i, pose in enumerate(poses):
        single = graze.find_triangle_pairs(bolt, (nut, pose))
        assert np.array_equal(lists.of(i), single.pairs) and single.is_complete
    assert np.array_equal(lists.of(-1), lists.of(39))
    with pytest.raises(IndexError):
        lists.of(40)
    few = graze.find_triangle_pairs(bolt, (nut, translation(0, 0, 0.002)), limit=3)
    assert few.pairs.shape == (3, 2) and few.pairs.dtype == np.uint32 and not few.is_complete


def test_interiors(unit_cube):
    poses = np.stack([translation(1, 0, 0), translation(0.5, 0, 0), translation(3, 0, 0)])
    assert graze.interiors_intersect(unit_cube, (unit_cube, poses)).tolist() == [False, True, False]
    assert graze.interiors_intersect(unit_cube, unit_cube) is True


def test_a_memory_changes_no_answer(bolt, nut):
    poses = np.tile(np.eye(4), (200, 1, 1))
    poses[:, 2, 3] = np.linspace(-0.03, 0.03, 200)
    memory = graze.PairMemory()
    hits = graze.intersects(bolt, (nut, poses), memory=memory)
    assert np.array_equal(hits, graze.intersects(bolt, (nut, poses)))
    assert memory.still_apart + memory.still_touching > 0
    lists = graze.find_triangle_pairs(bolt, (nut, poses), memory=memory)
    assert lists == graze.find_triangle_pairs(bolt, (nut, poses))


def test_work_is_summed_over_threads(bolt, nut):
    poses = random_poses(300, 0.02, seed=6)
    sums = []
    graze.intersects(bolt, (nut, poses))
    for threads in (1, 2):
        sums.append(graze.Work())
        graze.intersects(bolt, (nut, poses), threads=threads, work=sums[-1])
    assert sums[0] == sums[1] and sums[0].volume_tests > 0
    assert (sums[0] + sums[1]).volume_tests == 2 * sums[0].volume_tests
    assert sums[0].as_dict()["volume_tests"] == sums[0].volume_tests


def test_progress_is_told_to_functions_and_to_bars(bolt, nut):
    poses = random_poses(500, 0.02, seed=7)
    told = []
    graze.intersects(bolt, (nut, poses), progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (500, 500) and all(total == 500 for _, total in told)
    assert [done for done, _ in told] == sorted({done for done, _ in told})

    class Bar:
        n = 0

        def update(self, more):
            self.n += more

    bar = Bar()
    graze.intersects(bolt, (nut, poses), progress=bar)
    assert bar.n == 500


def test_what_a_callback_raises_ends_the_batch(bolt, nut):
    def refuse(done, total):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        graze.intersects(bolt, (nut, random_poses(500, 0.02, seed=8)), progress=refuse)


def test_a_signal_ends_a_batch_soon(bolt, nut):
    poses = np.broadcast_to(translation(0, 0, 0.002), (100_000_000, 4, 4))  # takes no memory
    sent = []

    def send():
        time.sleep(0.3)
        sent.append(time.monotonic())
        signal.raise_signal(signal.SIGINT)

    threading.Thread(target=send).start()
    with pytest.raises(KeyboardInterrupt):
        graze.intersects(bolt, (nut, poses))
    assert time.monotonic() - sent[0] < 1


def test_other_threads_run_while_a_batch_does(bolt, nut):
    poses = random_poses(20_000, 0.02, seed=9)
    counted = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    graze.intersects(bolt, (nut, poses))
    done.set()
    thread.join()
    assert counted[0] > 1


def test_many_threads_of_python_may_ask_at_once(bolt, nut):
    poses = random_poses(50, 0.02, seed=10)
    expected = graze.intersects(bolt, (nut, poses)).tolist()
    memory = graze.PairMemory()
    answers = [None] * 4

    def ask(k):
        answers[k] = [graze.intersects(bolt, (nut, pose), memory=memory) for pose in poses]

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(answer == expected for answer in answers)
