"""Many rays and poses at a world in one call: the single questions, on threads that nobody disturbs."""

import signal
import threading
import time

import graze
import numpy as np
import pytest
from conftest import random_poses, translation


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


def test_many_motions_in_a_world_are_the_single_ones(unit_cube):
    world = graze.World()
    world.add((unit_cube, random_poses(60, 6, seed=11)))
    starts = [translation(*place) for place in np.random.default_rng(12).uniform(-9, 9, (80, 3))]
    motions = [graze.RigidMotion.between(pose, translation(0, 0, 0.1 * i)) for i, pose in enumerate(starts)]
    singles = [world.cast(graze.Sphere([0, 0, 0], 0.25), motion) for motion in motions]
    assert 0 < sum(one is None for one in singles) < 80
    for threads in (0, 1, 3):
        found = world.cast(graze.Sphere([0, 0, 0], 0.25), motions, threads=threads)
        for i, one in enumerate(singles):
            if one is None:
                assert (found.contacts.status[i], found.contacts.low[i], found.contacts.high[i]) == ("free", 1, 1)
                continue
            assert (found.ids[i], found.part[i], found.contacts.status[i]) == (one.id, one.part, one.contact.status)
            assert (found.contacts.low[i], found.contacts.high[i]) == (one.contact.low, one.contact.high)
    assert len(world.cast(unit_cube, []).ids) == 0
    with pytest.raises(graze.PoseError, match=r"motion\[1\]"):
        world.cast(unit_cube, [motions[0], 2 * np.eye(4)])
    with pytest.raises(graze.InputError, match="many motions"):
        world.cast_all(unit_cube, motions)


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


def test_a_batch_in_a_world_ends_by_a_signal(bolt):
    world = graze.World()
    world.add((bolt, random_poses(200, 0.2, seed=9)))
    poses = random_poses(100_000, 0.2, seed=10)
    world.find_closest((bolt, poses[:4]))  # builds trees
    sent = []

    def send():
        time.sleep(0.3)
        sent.append(time.monotonic())
        signal.raise_signal(signal.SIGINT)

    threading.Thread(target=send).start()
    with pytest.raises(KeyboardInterrupt):
        world.find_closest((bolt, poses))
    assert time.monotonic() - sent[0] < 1
    assert len(world) == 200
