"""Many rays, poses and motions at a world in one call: the single questions, on threads that nobody disturbs."""

import pickle
import signal
import threading
import time

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation


def test_many_poses_in_a_world_are_the_single_ones(unit_cube, bolt):
    world = graze.World()
    world.add((graze.Sphere([0, 0, 0], 0.5), random_poses(300, 8, seed=5)), role="solid")
    world.update()
    poses = random_poses(200, 9, seed=6)
    for shape in (unit_cube, graze.Capsule(0.25, 0.5)):
        singles = [(world.find_touching((shape, p)), world.find_within((shape, p), 0.5), world.find_closest((shape, p))) for p in poses]
        for threads in (0, 1, 3):
            touching = world.find_touching((shape, poses), threads=threads)
            near = world.find_within((shape, poses), 0.5, threads=threads)
            closest = world.find_closest((shape, poses), threads=threads)
            for i, (ids, distances, one) in enumerate(singles):
                assert np.array_equal(touching.ids[touching.offsets[i] : touching.offsets[i + 1]], ids)
                rows = slice(near.offsets[i], near.offsets[i + 1])
                for name in distances._fields:
                    assert np.array_equal(getattr(near.distances, name)[rows], getattr(distances, name)), name
                assert (closest.ids[i], closest.distance[i], closest.part[i]) == (one.id, one.distance, one.part)
                assert np.array_equal(closest.point_b[i], one.point_b)
            assert len(touching.offsets) == len(closest.ids) + 1 == 201 and 0 < len(touching.ids) < len(near.distances.ids)
    nobody = world.find_closest((unit_cube, poses), filter=(2, 0, 0))
    assert np.isinf(nobody.distance).all() and np.isnan(nobody.point_a).all()
    bad = poses.copy()
    bad[17, 0, 0] += 1
    for ask in (world.find_touching, world.find_closest, lambda placed: world.find_within(placed, 1)):
        with pytest.raises(graze.PoseError, match="pose 17 of shape") as caught:
            ask((unit_cube, bad))
        assert caught.value.place.index == 17
        assert len(ask((unit_cube, poses[:0]))[-1]) <= 1  # an offset, or nothing


def test_many_rays_at_a_world(unit_cube):
    world = graze.World()
    world.add((unit_cube, random_poses(100, 6, seed=7)))
    random = np.random.default_rng(8)
    origins, directions = random.uniform(-9, 9, (2000, 3)), random.normal(size=(2000, 3))
    expected = world.cast_rays(origins, directions, threads=1)
    assert 100 < expected.is_hit.sum() < 2000
    for threads in (0, 2, 5):
        assert world.cast_rays(origins, directions, threads=threads) == expected
    lengths = np.where(np.arange(2000) % 2, np.inf, 0.0)
    short = world.cast_rays(origins, directions, lengths)
    assert np.array_equal(short.distance[1::2], expected.distance[1::2]) and short.is_hit[::2].sum() < 100
    directions[1234] = 0
    with pytest.raises(graze.InputError, match="ray 1234"):
        world.cast_rays(origins, directions)
    with pytest.raises(graze.InputError, match="threads"):
        world.cast_rays(origins, directions, threads=2**40)


def test_all_that_many_rays_meet(unit_cube):
    world = graze.World()
    world.add((unit_cube, random_poses(100, 4, seed=7)))
    random = np.random.default_rng(8)
    origins, directions = random.uniform(-9, 9, (500, 3)), random.normal(size=(500, 3))
    singles = [world.cast_ray_all(o, d) for o, d in zip(origins, directions)]
    assert max(len(one.ids) for one in singles) > 2
    for threads in (0, 1, 3):
        lists = world.cast_ray_all(origins, directions, threads=threads)
        assert len(lists.offsets) == 501 and lists.offsets[-1] == len(lists.hits.ids)
        for i, one in enumerate(singles):
            rows = slice(lists.offsets[i], lists.offsets[i + 1])
            assert graze.BodyRayHits(*(column[rows] for column in lists.hits)) == one
    assert len(world.cast_ray_all(origins[:0], directions[:0]).offsets) == 1
    origins[123, 1] = np.nan
    with pytest.raises(graze.InputError, match="ray 123") as caught:
        world.cast_ray_all(origins, directions)
    assert caught.value.place.index == 123


def test_many_motions_in_a_world_are_the_single_ones(unit_cube):
    world = graze.World()
    world.add((unit_cube, random_poses(60, 6, seed=11)))
    starts = np.stack([translation(*place) for place in np.random.default_rng(12).uniform(-9, 9, (80, 3))])
    ends = np.stack([translation(0, 0, 0.1 * i) for i in range(80)])
    motions = [graze.RigidMotion.between(*poses) for poses in zip(starts, ends)]
    arrays = graze.RigidMotions.between(starts, ends)
    for shape in (graze.Sphere([0, 0, 0], 0.25), cube(0.5)):
        settings = {"clearance": 0.125, "tolerance": 1e-4}
        singles = [world.cast(shape, motion, **settings) for motion in motions]
        lists = [world.cast_all(shape, motion, **settings) for motion in motions]
        assert 0 < sum(one is None for one in singles) < 80 and max(map(len, lists)) > 2
        for threads, many in ((0, motions), (1, arrays), (3, arrays)):
            found = world.cast(shape, many, threads=threads, **settings)
            for i, one in enumerate(singles):
                if one is None:
                    assert (found.contacts.status[i], found.contacts.low[i], found.contacts.high[i]) == ("free", 1, 1)
                else:
                    assert row_of(found, i) == one
            met = world.cast_all(shape, many, threads=threads, **settings)
            assert len(met.offsets) == 81 and met.offsets[-1] == len(met.casts.ids)
            for i, ones in enumerate(lists):
                assert [row_of(met.casts, k) for k in range(met.offsets[i], met.offsets[i + 1])] == ones
    for nothing in ([], arrays_of(0)):
        assert len(world.cast(unit_cube, nothing).ids) == 0 and world.cast_all(unit_cube, nothing).offsets.tolist() == [0]
    with pytest.raises(graze.PoseError, match=r"motion\[1\]"):
        world.cast(unit_cube, [motions[0], 2 * np.eye(4)])
    far = graze.RigidMotions(np.eye(4), shift=np.where(np.arange(300)[:, None] == 222, 1e250, [1.0, 0, 0]))
    for ask in (world.cast, world.cast_all):
        with pytest.raises(graze.PoseError, match="motion 222") as caught:
            ask(unit_cube, far)
        assert caught.value.place.index == 222
        with pytest.raises(graze.InputError, match="threads"):
            ask(unit_cube, arrays, threads=-1)


def row_of(casts, i):
    """Row i of BodyCasts as the BodyCast that one question has."""
    contacts = casts.contacts
    contact = graze.RigidContact(*(column[i].item() for column in contacts))
    return graze.BodyCast(int(casts.ids[i]), contact, int(casts.part[i]))


def arrays_of(count):
    return graze.RigidMotions(np.tile(np.eye(4), (count, 1, 1)))


def test_motions_of_arrays_are_the_single_ones():
    random = np.random.default_rng(21)
    starts, ends = random_poses(50, 3, seed=22), random_poses(50, 3, seed=23)
    centres, ways, axes, angles = random.normal(size=(50, 3)), random.normal(size=(50, 3)), random.normal(size=(50, 3)), random.uniform(-9, 9, 50)
    made = {
        "courses": (graze.RigidMotions(starts, centres, ways, axes, angles), lambda i: graze.RigidMotion(starts[i], centres[i], ways[i], axes[i], angles[i])),
        "three rows, backwards": (graze.RigidMotions(starts[::-1, :3], shift=ways), lambda i: graze.RigidMotion(starts[49 - i], shift=ways[i])),
        "one pose, big-endian ways": (graze.RigidMotions(np.eye(4), shift=ways.astype(">f8")), lambda i: graze.RigidMotion(np.eye(4), shift=ways[i])),
        "one way": (graze.RigidMotions(starts, shift=[1, 0, 0]), lambda i: graze.RigidMotion(starts[i], shift=[1, 0, 0])),
        "between": (graze.RigidMotions.between(starts, ends, centres), lambda i: graze.RigidMotion.between(starts[i], ends[i], centres[i])),
        "screws": (graze.RigidMotions.screw_between(starts, ends[0]), lambda i: graze.RigidMotion.screw_between(starts[i], ends[0])),
    }
    for name, (motions, single) in made.items():
        singles = [single(i) for i in range(50)]
        assert list(motions) == singles and len(motions) == 50 and motions[-1] == singles[49], name
        assert pickle.loads(pickle.dumps(motions)) == motions and motions != arrays_of(50), name
        assert np.array_equal(motions.at(0.25), [motion.at(0.25) for motion in singles]), name
        times = random.uniform(size=50)
        assert np.array_equal(motions.at(times), [motion.at(t) for motion, t in zip(singles, times)]), name
        for member in ("start", "centre", "shift", "axis", "angle"):
            assert np.array_equal(getattr(motions, member), [getattr(motion, member) for motion in singles]), (name, member)
    assert len(graze.RigidMotions(np.eye(4))) == 1 and len(arrays_of(0)) == 0 and arrays_of(0).at(1).shape == (0, 4, 4)
    assert pickle.loads(pickle.dumps(arrays_of(0))) == arrays_of(0)
    box, free = graze.Box([1, 1, 1]), graze.RigidMotions.between(starts, ends)
    assert np.array_equal(graze.is_free(box, np.eye(4), box, free), graze.is_free(box, np.eye(4), box, list(free)))
    assert graze.first_contact(box, np.eye(4), box, free) == graze.first_contact(box, np.eye(4), box, list(free))


def test_bad_arrays_of_motions():
    starts, motions = random_poses(9, 3, seed=24), arrays_of(4)
    bad = starts.copy()
    bad[5, 0, 0] += 1
    for error, text, make in (
        (graze.PoseError, "motion 5", lambda: graze.RigidMotions(bad)),
        (graze.PoseError, "motion 5", lambda: graze.RigidMotions.between(starts, bad)),
        (graze.InputError, "motion 0", lambda: graze.RigidMotions(starts, axis=np.zeros((9, 3)))),
        (graze.InputError, "motion 3", lambda: graze.RigidMotions(starts, shift=np.where(np.arange(9)[:, None] == 3, np.nan, 0) * [1, 1, 1])),
        (graze.InputError, "shift: are 8, and there are 9 of start", lambda: graze.RigidMotions(starts, shift=np.zeros((8, 3)))),
        (graze.InputError, "end: are 2", lambda: graze.RigidMotions.screw_between(starts, starts[:2])),
        (graze.InputError, "angle", lambda: graze.RigidMotions(starts, angle=np.zeros((9, 1)))),
        (graze.InputError, "t: are 3", lambda: motions.at([0, 0, 0])),
        (graze.InputError, "", lambda: motions.at(2)),
        (IndexError, "", lambda: motions[4]),
        (TypeError, "", lambda: motions["first"]),
    ):
        with pytest.raises(error, match=text):
            make()


def test_nobody_uses_a_world_that_a_batch_asks(unit_cube):
    world = graze.World()
    id = world.add((unit_cube, translation(0, 0, 0)))
    origins = np.tile([-5.0, 0, 0], (100_000, 1))
    for meddle in (lambda: world.move(id, translation(1, 0, 0)), lambda: world.find_touching(unit_cube), world.update):
        with pytest.raises(graze.InputError, match="progress: cannot use the world"):
            world.cast_rays(origins, [1, 0, 0], progress=lambda done, total: meddle())
    assert world.cast_rays(origins[:2], [1, 0, 0]).distance.tolist() == [4.5, 4.5]  # as it was, and free again
    mover = threading.Thread(target=lambda: [world.move(id, translation(0.25 * (k % 2), 0, 0)) for k in range(200)])
    mover.start()
    while mover.is_alive():
        distances = world.cast_rays(origins[:500], [1, 0, 0], threads=2).distance
        assert (distances == distances[0]).all()  # all rays meet one state of the world
    mover.join()


@pytest.mark.parametrize("query", ["closest", "cast"])
def test_a_batch_in_a_world_ends_by_a_signal(unit_cube, query):
    """Of many questions that take microseconds each: one that takes long is not interrupted."""
    world = graze.World()
    world.add((unit_cube, random_poses(200, 6, seed=9)))
    poses = np.tile(random_poses(2000, 6, seed=10), (200, 1, 1))
    motions = graze.RigidMotions(poses, shift=[1, 0, 0])
    ask = {"closest": lambda: world.find_closest((unit_cube, poses)), "cast": lambda: world.cast(unit_cube, motions)}[query]
    world.find_closest((unit_cube, poses[:4]))  # builds trees
    sent = []

    def send():
        time.sleep(0.3)
        sent.append(time.monotonic())
        signal.raise_signal(signal.SIGINT)

    threading.Thread(target=send).start()
    with pytest.raises(KeyboardInterrupt):
        ask()
    assert time.monotonic() - sent[0] < 1
    assert len(world) == 200
