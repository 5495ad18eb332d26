"""Queries in many poses, of many rays and ways: what single calls answer, on any number of threads."""

import graze
import numpy as np
import pytest
from conftest import random_poses, translation

POSES = random_poses(40, 0.02, seed=80)
BOX = graze.Box([0.01, 0.008, 0.006])


@pytest.mark.parametrize("threads", [1, 2])
def test_contacts_of_meshes_in_many_poses(bolt, nut, threads):
    lists = graze.find_contacts(bolt, (nut, POSES), threads=threads)
    all_of_them = lists.contacts
    assert len(lists.offsets) == 41 and lists.offsets[-1] == len(all_of_them.depth) > 0 and lists.is_complete.all()
    for i in range(0, 40, 3):
        one = graze.find_contacts(bolt, (nut, POSES[i]))
        own = slice(lists.offsets[i], lists.offsets[i + 1])
        for name in ("point", "point_a", "point_b", "normal", "depth"):
            assert np.array_equal(getattr(all_of_them, name)[own], getattr(one, name))
        corners = all_of_them.corners[all_of_them.offsets[own.start] : all_of_them.offsets[own.stop]]
        assert np.array_equal(corners, one.corners)
    few = graze.find_contacts(bolt, (nut, POSES), limit=1)
    assert np.array_equal(np.diff(few.offsets), np.minimum(np.diff(lists.offsets), 1))
    assert np.array_equal(few.is_complete, np.diff(lists.offsets) <= 1)
    assert few.contacts.is_complete == few.is_complete.all()


def test_contacts_of_shapes_in_many_poses(bolt):
    lists = graze.find_contacts(bolt, (BOX, POSES), margin=0.001)
    assert lists.offsets[-1] == len(lists.contacts.depth) > 0
    for i in range(0, 40, 3):
        one = graze.find_contacts(bolt, (BOX, POSES[i]), margin=0.001)
        own = slice(lists.offsets[i], lists.offsets[i + 1])
        assert all(np.array_equal(getattr(lists.contacts, name)[own], getattr(one, name)) for name in one._fields)


def test_intersections_and_separations_in_many_poses(bolt, nut):
    met = graze.find_intersection(bolt, (nut, POSES[:6]))
    assert met == [graze.find_intersection(bolt, (nut, pose)) for pose in POSES[:6]]
    for segment in range(len(met[0].segments)):
        first, count = met[0].segment_pairs[segment]
        assert count >= 1 and first + count <= len(met[0].pairs)
    for direction in (None, [0, 0, 1]):
        away = graze.separating_translation(bolt, (nut, POSES[:6]), direction)
        for i, pose in enumerate(POSES[:6]):
            one = graze.separating_translation(bolt, (nut, pose), direction)
            assert one.distance == away.distance[i] and np.array_equal(one.pose_b, away.pose_b[i])
            assert np.array_equal(one.translation, away.translation[i]) and np.array_equal(one.direction, away.direction[i])
    hull = graze.ConvexHull(bolt.vertices[::50])
    apart = graze.find_separation(hull, (BOX, POSES))
    for i, pose in enumerate(POSES):
        one = graze.find_separation(hull, (BOX, pose))
        assert one.distance == apart.distance[i] and np.array_equal(one.normal, apart.normal[i])
    assert (apart.distance < 0).any() and apart.is_converged.any()


def test_casts_in_many_poses_and_many_ways(bolt, nut):
    ways = np.random.default_rng(81).normal(size=(40, 3)) * 0.05
    for b in (nut, BOX):
        many = graze.cast(bolt, (b, POSES), ways)
        along_one = graze.cast(bolt, (b, POSES), ways[0])
        from_one = graze.cast(bolt, (b, POSES[0]), ways)
        assert many.is_hit.any() and (many.pair is None) == (b is BOX)
        for i in range(40):
            for casts, pose, way in ((many, POSES[i], ways[i]), (along_one, POSES[i], ways[0]), (from_one, POSES[0], ways[i])):
                one = graze.cast(bolt, (b, pose), way)
                assert (one is not None) == casts.is_hit[i]
                if one is None:
                    assert np.isnan(casts.time[i]) and np.isnan(casts.point[i]).all()
                    assert casts.pair is None or casts.pair[i].tolist() == [-1, -1]
                else:
                    assert one.time == casts.time[i] and one.is_at_start == casts.is_at_start[i]
                    assert np.array_equal(one.point, casts.point[i]) and np.array_equal(one.normal, casts.normal[i])
                    assert casts.pair is None or one.pair == tuple(casts.pair[i])
    with pytest.raises(graze.InputError, match="displacement: are 39, and there are 40 poses"):
        graze.cast(bolt, (nut, POSES), ways[:39])
    ways[17, 2] = np.inf
    with pytest.raises(graze.InputError, match="displacement: 17 is not finite") as caught:
        graze.cast(bolt, (nut, POSES), ways)
    assert caught.value.place.index == 17
    bad = POSES.copy()
    bad[23] *= 2
    with pytest.raises(graze.PoseError, match="pose 23 of b"):
        graze.cast(bolt, (nut, bad), [0, 0, 1])


def test_all_that_many_rays_meet(bolt):
    origins = np.random.default_rng(82).normal(size=(300, 3)) * 0.02
    lists = graze.cast_ray_all(bolt, origins, -origins)
    assert lists.offsets[-1] == len(lists.hits.distance) > 0 and lists.hits.is_hit.all()
    for i in range(0, 300, 20):
        one = graze.cast_ray_all(bolt, origins[i], -origins[i])
        own = slice(lists.offsets[i], lists.offsets[i + 1])
        assert all(np.array_equal(getattr(lists.hits, name)[own], getattr(one, name)) for name in one._fields)
    directions = -origins
    directions[201] = 0
    with pytest.raises(graze.InputError, match="ray 201"):
        graze.cast_ray_all(bolt, origins, directions)


def test_how_far_many_motions_are_free(bolt, nut):
    motions = [graze.RigidMotion.between(translation(0.05, 0, 0.01 * i), translation(-0.05, 0.001 * i, 0)) for i in range(8)]
    motions.append(graze.RigidMotion(np.eye(4)))
    last = graze.last_free(bolt, np.eye(4), nut, motions, threads=2)
    expected = [graze.last_free(bolt, np.eye(4), nut, motion) for motion in motions]
    assert expected[-1] is None and np.isnan(last[-1]) and last[:-1].tolist() == expected[:-1]


def test_points_in_any_layout_at_once(bolt):
    """Rows are read in place where they can be; what is broadcast or goes backwards is copied."""
    points = np.random.default_rng(83).uniform(-0.02, 0.02, (50, 3))
    expected = graze.nearest_points(bolt, points)
    assert graze.nearest_points(bolt, points[::-1]).distance.tolist() == expected.distance[::-1].tolist()
    assert graze.nearest_points(bolt, points[:, ::-1][:, ::-1]) == expected
    wide = np.zeros((50, 7))
    wide[:, ::3] = points
    assert graze.nearest_points(bolt, wide[:, ::3]) == expected
    assert graze.nearest_points(bolt, np.broadcast_to(points[0], (9, 3))).distance.tolist() == [expected.distance[0]] * 9
    assert graze.nearest_points(bolt, points[:0]).distance.shape == (0,)
    assert graze.nearest_points(bolt, points[:1]).distance.tolist() == [expected.distance[0]]
    assert graze.nearest_points(bolt, np.asfortranarray(points)) == expected


def test_progress_of_all_batches(bolt, nut):
    points = POSES[:, :3, 3]
    for ask in (
        lambda progress: graze.find_contacts(bolt, (nut, POSES), progress=progress),
        lambda progress: graze.contains(bolt, points, progress=progress),
        lambda progress: graze.cast_rays(bolt, points, [0, 0, 1], progress=progress),
        lambda progress: graze.cast(bolt, (nut, POSES), [0, 0, 0.1], progress=progress),
        lambda progress: graze.distance(bolt, (nut, POSES), progress=progress),
        lambda progress: graze.is_free(bolt, np.eye(4), nut, list(POSES), progress=progress),
    ):
        told = []
        ask(lambda done, total: told.append((done, total)))
        assert told[-1] == (40, 40) and [done for done, _ in told] == sorted({done for done, _ in told})

        def refuse(done, total):
            raise KeyError("enough")

        with pytest.raises(KeyError, match="enough"):
            ask(refuse)
