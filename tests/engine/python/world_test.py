"""Worlds: their states, against each other, drawn, kept as snapshots."""

import pickle

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation


def only_small(a, b):
    """A filter that pickle finds."""
    return (a & 0xFFFFFFFF) < 3


def test_what_a_body_was_told(unit_cube):
    world = graze.World(islands=True)
    body = world.add(unit_cube, kind="kinematic", filter=(1, 2, -3), role="sensor", margin=0.25, detection="continuous", user_data=7)
    assert (world.kind(body), world.role(body), world.margin(body)) == ("kinematic", "sensor", 0.25)
    assert (world.detection(body), world.filter(body), world.user_data(body)) == ("continuous", (1, 2, -3), 7)
    assert world.sides(body) == "surface"
    floor = world.add(unit_cube, kind="static", sides=("one_sided", 0.5))
    room = world.add(cube(9), sides="solid")
    assert world.sides(floor) == ("one_sided", 0.5) and world.sides(room) == "solid"
    world.set_user_data([body, floor], [2**63, 5])
    assert world.user_data(body) == 2**63 and world.user_data(floor) == 5
    world.set_user_data([body, floor], 9)
    assert world.user_data(floor) == 9
    with pytest.raises(graze.InputError, match="value"):
        world.set_user_data([body, floor], [1, 2, 3])
    with pytest.raises(graze.InputError, match="sides"):
        world.add(unit_cube, sides="hollow")
    world.remove(body)
    for ask in (world.kind, world.role, world.margin, world.detection, world.filter, world.sides, world.user_data, world.island):
        with pytest.raises(graze.StaleIdError):
            ask(body)
        with pytest.raises(graze.InputError, match="id"):
            ask([body, floor])


def test_lists_of_one_body():
    ball = graze.Sphere([0, 0, 0], 0.5)
    world = graze.World(islands=True)
    a, b, c, d = (int(i) for i in world.add((ball, np.stack([translation(x, 0, 0) for x in (0, 0.9, 1.8, 2.9)])), margin=0.1))
    update = world.update()
    assert world.pairs().tolist() == [[a, b], [b, c]] == update.begun.tolist()
    assert world.pairs(a).tolist() == [[a, b]] and world.pairs(d).shape == (0, 2)
    assert world.near_pairs().tolist() == [[a, b], [b, c], [c, d]] and world.near_pairs(d).tolist() == [[c, d]]
    assert world.island(a).tolist() == [a, b, c] and world.island(d).tolist() == [d]
    assert world.contacts(d).pairs.tolist() == [[c, d]] and len(world.contacts().pairs) == 3
    assert np.allclose(world.contacts(d).contacts.depth, -0.1)
    assert update.counters["shape_tests"] >= 3 and set(update.counters) > {"pairs_near", "trees_unbuilt"}


def test_contacts_that_go_on_keep_their_numbers():
    world = graze.World(tracks_contacts=True)
    world.add(graze.HalfSpace([0, 0, 1]), kind="static")
    box = world.add((graze.Box([0.5, 0.5, 0.5]), translation(0, 0, 0.499)))
    first = world.update().contacts
    assert len(set(first.ids.tolist())) == len(first.contacts.depth) == 4 and first.ids.min() > 0
    kept = world.snapshot()
    world.move(box, translation(0.25, 0, 0.499))
    assert np.array_equal(world.update().contacts.ids, first.ids)
    assert len(world.contacts().ids) == 0
    world.move(box, translation(0, 0, 2))
    assert len(world.update().contacts.ids) == 0
    world.restore(kept)
    world.move(box, translation(0.25, 0, 0.499))
    assert len(world.update().contacts.ids) == 4
    assert len(graze.World().update().contacts.ids) == 0
    with pytest.raises(graze.InputError, match="tracks_contacts"):
        graze.World(contacts=False, tracks_contacts=True)


def test_sides_count_in_a_world():
    world = graze.World()
    room = world.add(cube(4), kind="static", sides="solid")
    ball = world.add(graze.Sphere([0, 0, 0], 0.1))
    assert world.update().begun.tolist() == [[room, ball]]
    open_world = graze.World()
    open_world.add(cube(4), kind="static")
    open_world.add(graze.Sphere([0, 0, 0], 0.1))
    assert len(open_world.update().begun) == 0


def test_worlds_against_each_other(unit_cube):
    cell, robot = graze.World(), graze.World()
    walls = cell.add((unit_cube, random_poses(30, 5, seed=50)), kind="static")
    links = robot.add((graze.Box([0.5, 0.25, 0.25]), random_poses(6, 2, seed=51)))
    where = random_poses(1, 1, seed=52)[0]
    expected_distances = {}
    for wall in walls:
        for link in links:
            gap = graze.distance((unit_cube, cell.poses(int(wall))), (robot.shape(int(link)), where @ robot.poses(int(link))))
            expected_distances[int(wall), int(link)] = gap.distance
    touching = {tuple(int(i) for i in pair) for pair in cell.find_touching((robot, where))}
    assert touching == {pair for pair, gap in expected_distances.items() if gap == 0} and touching
    near = cell.find_within((robot, where), 1.0)
    found = {(int(a), int(b)): gap for (a, b), gap in zip(near.pairs, near.distance)}
    assert set(found) == {pair for pair, gap in expected_distances.items() if gap <= 1.0}
    assert all(np.isclose(found[pair], expected_distances[pair], atol=1e-9) for pair in found)
    assert near.parts.shape == (len(found), 2) and (near.lower_bound <= near.distance).all()
    far = translation(100, 0, 0)
    closest = cell.find_closest((robot, far))
    assert len(cell.find_touching((robot, far))) == 0 and closest.distance > 80
    assert (closest.a, closest.b) in expected_distances and closest.is_converged
    assert cell.find_closest(graze.World()) is None
    assert len(cell.find_touching(robot)) >= 0
    assert len(robot.find_touching(robot, filter=False)) >= len(links)
    with pytest.raises(graze.PoseError, match="pose of world"):
        cell.find_touching((robot, 2 * np.eye(4)))
    with pytest.raises(graze.InputError, match="filter"):
        cell.find_touching(robot, filter=(1, 2, 3))
    with pytest.raises(graze.InputError):
        cell.find_within(robot, -1)


def test_the_closest_pair(unit_cube):
    world = graze.World()
    a, b, c = (int(i) for i in world.add((unit_cube, np.stack([translation(x, 0, 0) for x in (0, 3, 4.5)]))))
    found = world.find_closest_pair()
    assert (found.a, found.b, found.distance) == (b, c, 0.5) and found.normal.tolist() == [1, 0, 0]
    world.exclude(b, c)
    assert world.find_closest_pair().distance == 2
    assert world.find_closest_pair(filter=False).distance == 0.5
    assert graze.World().find_closest_pair() is None


def test_all_that_a_ray_and_a_motion_meet(unit_cube):
    world = graze.World()
    ids = world.add((unit_cube, np.stack([translation(x, 0, 0) for x in (0, 3, 6)])))
    hits = world.cast_ray_all([-5, 0.1, 0.2], [1, 0, 0])
    assert hits.ids.tolist() == ids.tolist() and hits.distance.tolist() == [4.5, 7.5, 10.5]
    met = world.cast_all(graze.Sphere([0, 0, 0], 0.1), graze.RigidMotion.between(translation(-5, 0, 0), translation(4, 0, 0)))
    assert [cast.id for cast in met] == ids[:2].tolist() and met[0].contact.low < met[1].contact.low
    near = world.cast(graze.Sphere([0, 0, 0], 0.1), translation(8, 0, 0), clearance=2)
    assert near.id == ids[2] and near.contact.status == "hit"
    with pytest.raises(TypeError, match="has no pose"):
        world.cast((unit_cube, np.eye(4)), np.eye(4))
    directions = np.tile([1.0, 0, 0], (500, 1))
    directions[321] = np.nan
    with pytest.raises(graze.InputError, match="ray 321") as caught:
        world.cast_rays([-5, 0, 0], directions)
    assert caught.value.place.index == 321
    told = []
    world.cast_rays([-5, 0, 0], np.tile([1.0, 0, 0], (5000, 1)), progress=lambda done, total: told.append(done))
    assert told[-1] == 5000


def test_a_drawing(unit_cube):
    world = graze.World(islands=True)
    a = world.add(unit_cube)
    b = world.add((graze.Sphere([0, 0, 0], 0.5), translation(0.9, 0, 0)))
    world.update()
    drawing = world.draw(boxes=True, islands=True, labels=True)
    assert drawing.lines.shape == (len(drawing.shows), 2, 3) and set(drawing.bodies.tolist()) == {a, b}
    edges = drawing.lines[(drawing.shows == 0) & (drawing.bodies == a)]
    assert len(edges) >= 12 and (np.abs(edges) == 0.5).all()
    assert np.count_nonzero(drawing.shows == 1) == 24 and (drawing.shows == 2).any() and (drawing.shows == 3).any()
    assert len(drawing.points) == len(drawing.point_bodies) > 0 and drawing.point_bodies[0].tolist() == [a, b]
    assert [body for _, _, body in drawing.labels] == [a, b]
    assert len(world.draw(shapes=False, contacts=False).lines) == 0
    for settings in ({"segments": 2}, {"segments": -1}, {"half_space_extent": np.nan}):
        with pytest.raises(graze.InputError):
            world.draw(**settings)
    world.move(a, translation(5, 0, 0))
    with pytest.raises(graze.InputError):
        world.draw()
    assert len(world.draw(contacts=False).lines) > 0


def history(world, ids, steps):
    told = []
    for poses in steps:
        world.move(ids, poses)
        update = world.update()
        told.append((update.begun.tolist(), update.ended.tolist(), update.contacts))
    return told


def test_snapshots_are_pickled_and_go_on_bit_for_bit(unit_cube):
    world = graze.World(islands=True, number=3)
    terrain = graze.HeightField(np.zeros((5, 5)))
    dumbbell = graze.Compound([graze.Sphere([-1, 0, 0], 0.5), (graze.Box([0.5] * 3), translation(1, 0, 0))], filters=[(1, 1, 0), None])
    blocks = graze.VoxelMap([0, 0, 0], 1.0, (2, 2, 2), [[0, 0, 0], [1, 1, 1]])
    kinds = [world.add(shape, kind="static") for shape in (terrain, dumbbell, blocks, graze.HalfSpace([0, 0, 1], -9))]
    ids = world.add((unit_cube, random_poses(25, 3, seed=60)), margin=0.05)
    gone = world.add(unit_cube)
    world.update()
    world.remove(gone)
    world.set_kind(ids[3], "kinematic")
    world.set_role(ids[4], "sensor")
    world.set_detection(ids[5], "continuous")
    world.exclude(ids[0], ids[1])
    world.set_user_data(ids[2], 99)
    world.update()
    world.sleep(ids[6])
    world.update()
    snapshot = world.snapshot()
    again = pickle.loads(pickle.dumps(snapshot))
    steps = [random_poses(25, 3, seed=61 + i) for i in range(5)]
    expected = history(world, ids, steps)
    other = graze.World(islands=True, number=3)
    for kept in (snapshot, again):
        other.restore(kept)
        assert other.bodies().tolist() == [*kinds, *ids.tolist()] and other.user_data(int(ids[2])) == 99
        assert not other.is_awake(int(ids[6])) and other.kind(int(ids[3])) == "kinematic"
        assert len(other.shape(kinds[1])) == 2 and other.shape(kinds[1]).filters == [(1, 1, 0), None]
        assert other.shape(kinds[0]) == terrain and len(other.shape(kinds[2])) == 2
        assert history(other, ids, steps) == expected
        assert other.add(unit_cube) == world.add(unit_cube)  # indices are given out in the same order
        world.restore(snapshot)
        expected = history(world, ids, steps)
    assert any(begun for begun, _, _ in expected)


def test_snapshots_with_filters(unit_cube):
    world = graze.World()
    world.set_pair_filter(only_small)
    world.add((unit_cube, np.tile(np.eye(4), (5, 1, 1))))
    pairs = world.update().begun
    other = graze.World()
    other.restore(pickle.loads(pickle.dumps(world.snapshot())))
    assert other.pairs().tolist() == pairs.tolist()
    late = other.add(unit_cube)
    assert other.update().begun.tolist() == [[int(a), late] for a in other.bodies()[:3]]
    world.set_pair_filter(lambda a, b: True)
    world.update()
    with pytest.raises((pickle.PicklingError, AttributeError)):
        pickle.dumps(world.snapshot())


def test_what_is_no_snapshot_is_refused(unit_cube):
    world = graze.World()
    world.add((unit_cube, np.tile(np.eye(4), (3, 1, 1))))
    world.update()
    state = world.snapshot().__getstate__()
    for place, value in ((2, (np.arange(9),) * 4 + (1, 0)), (1, [None] * 3), (1, []), (6, np.array([[7, 8]] * 3)), (7, [1, 2])):
        broken = list(state)
        broken[place] = value
        with pytest.raises(graze.InputError, match="pickle"):
            graze.WorldSnapshot.__new__(graze.WorldSnapshot).__setstate__(tuple(broken))
