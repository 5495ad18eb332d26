"""Shapes, worlds of them, and boxes: thousands at once, by arrays."""

import pickle

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation

SHAPES = [
    graze.Sphere([1, 2, 3], 0.5),
    graze.Box([1, 2, 3]),
    graze.Capsule(1, 2),
    graze.Cylinder(1, 2),
    graze.Cone(1, 2),
    graze.Ellipsoid([0, 0, 0], [1, 2, 3]),
    graze.ConvexHull(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])),
    graze.HalfSpace([0, 0, 2], 4),
    graze.Plane([0, 0, 2], 4),
    graze.HalfSpace([1, 2, 3], 4),
    graze.Plane([3, -1, 2], 0.1),
]


@pytest.mark.parametrize("shape", SHAPES)
def test_shapes_are_values(shape):
    again = pickle.loads(pickle.dumps(shape))
    assert again == shape and type(again) is type(shape) and hash(again) == hash(shape)
    assert repr(shape).startswith(type(shape).__name__)
    assert isinstance(shape, graze.Shape)
    world = graze.World()
    assert world.shape(world.add(shape)) == shape


@pytest.mark.parametrize(
    "make, says",
    [
        (lambda: graze.Sphere([0, 0, 0], -1), "radius"),
        (lambda: graze.Sphere([0, 0], 1), "centre"),
        (lambda: graze.Box([1, np.nan, 1]), "half extent"),
        (lambda: graze.Capsule("1", 2), "radius: '1' is not a number"),
        (lambda: graze.HalfSpace([0, 0, 0]), "normal"),
        (lambda: graze.ConvexHull([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), "volume|plane"),
    ],
)
def test_what_is_no_shape_is_refused(make, says):
    with pytest.raises(graze.InputError, match=says):
        make()


def test_questions_about_shapes_in_batches(unit_cube):
    poses = random_poses(100, 3, seed=20)
    for shape in SHAPES:
        for other in (SHAPES[1], unit_cube):
            hits = graze.intersects(other, (shape, poses))
            gaps = graze.distance(other, (shape, poses))
            assert np.array_equal(hits, gaps.distance == 0)
            assert hits[:9].tolist() == [graze.intersects(other, (shape, pose)) for pose in poses[:9]]
            assert graze.distance(other, (shape, poses[5])).distance == gaps.distance[5]
            assert np.array_equal(graze.within(other, (shape, poses), 0.5), gaps.distance <= 0.5)


def test_contacts_of_shapes():
    box = graze.Box([1, 1, 1])
    contacts = graze.find_contacts(box, (box, translation(0, 0, 1.5)))
    assert contacts.depth.tolist() == [0.5] * 4 and (contacts.normal == [0, 0, 1]).all()
    assert contacts.feature.shape == (4, 2) and contacts.region.tolist() == [0] * 4
    near = graze.find_contacts(box, (box, translation(0, 0, 2.25)), margin=0.5)
    assert np.allclose(near.depth, -0.25)
    with pytest.raises(graze.InputError, match="margin"):
        graze.find_contacts(box, box, margin=-1)
    with pytest.raises(graze.InputError, match="limit"):
        graze.find_contacts(box, box, limit=1)
    ground = graze.HalfSpace([0, 0, 1])
    with pytest.raises(graze.UnsupportedPairError):
        graze.find_contacts(ground, ground)


def test_a_world_of_thousands(unit_cube):
    grid = np.stack(np.meshgrid(*[np.arange(16.0)] * 3), axis=-1).reshape(-1, 3)
    poses = np.tile(np.eye(4), (4096, 1, 1))
    poses[:, :3, 3] = 2 * grid
    world = graze.World()
    ids = world.add((graze.Sphere([0, 0, 0], 0.9), poses))
    assert ids.shape == (4096,) and ids.dtype == np.uint64 and len(world) == 4096
    assert len(world.update().begun) == 0
    poses[:, :3, 3] = 1.5 * grid
    world.move(ids, poses)
    assert np.array_equal(world.poses(ids), poses)
    update = world.update()
    assert len(update.begun) == 3 * 16 * 16 * 15 and np.array_equal(update.begun, world.pairs())
    contacts = update.contacts
    assert np.array_equal(contacts.pairs, update.begun)
    assert contacts.offsets[-1] == len(contacts.contacts.depth) == len(update.begun)
    assert np.allclose(contacts.contacts.depth, 0.3)
    world.move(ids[0], translation(-100, 0, 0))
    assert len(world.update().ended) == 3
    world.remove(ids[1:])
    assert len(world) == 1 and int(ids[0]) in world and int(ids[1]) not in world
    with pytest.raises(graze.StaleIdError) as caught:
        world.remove(ids[:3])
    assert caught.value.place.index == 1 and len(world) == 1


def test_bad_moves_move_nobody(unit_cube):
    world = graze.World()
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, 0, 3] = 0, 5, 10
    ids = world.add((unit_cube, poses))
    changed = poses + 0
    changed[:, 1, 3] = 1
    changed[2] *= 2
    with pytest.raises(graze.PoseError) as caught:
        world.move(ids, changed)
    assert caught.value.place.index == 2 and np.array_equal(world.poses(ids), poses)
    with pytest.raises(graze.InputError, match="poses: are 2, and there are 3 ids"):
        world.move(ids, poses[:2])
    with pytest.raises(graze.InputError, match="ids"):
        world.move([0.5], poses[:1])
    with pytest.raises(graze.PoseError, match="pose 1 of shape"):
        world.add((unit_cube, np.stack([np.eye(4), 2 * np.eye(4)])))
    assert len(world) == 3
    with pytest.raises(graze.InputError, match="kind"):
        world.add(unit_cube, kind="soft")
    with pytest.raises(graze.InputError, match="margin"):
        world.add(unit_cube, margin=-1)
    with pytest.raises(graze.InputError, match="filter"):
        world.add(unit_cube, filter=(1, 2))


def test_what_a_world_is_asked(unit_cube):
    world = graze.World(islands=True)
    a, b, c = (world.add((unit_cube, translation(x, 0, 0))) for x in (0, 1, 9))
    world.update()
    assert world.find_touching((unit_cube, translation(-1, 0, 0))).tolist() == [a]
    assert world.find_closest((unit_cube, translation(6, 0, 0))).id == c
    assert world.find_within((unit_cube, translation(6, 0, 0)), 4).ids.tolist() == [b, c]
    assert world.find_in_box([[0.4, -1, -1], [0.6, 1, 1]]).tolist() == [a, b]
    hits = world.cast_rays([[-5, 0.1, 0.2], [-5, 5, 0]], [1, 0, 0])
    assert hits.is_hit.tolist() == [True, False] and hits.ids[0] == a and hits.distance[0] == 4.5
    met = world.cast(unit_cube, graze.RigidMotion.between(translation(6, 0, 0), translation(9, 0, 0)))
    assert met.id == c and met.contact.status == "hit"
    assert world.touching(a).tolist() == [b]
    assert [island.tolist() for island in world.islands()] == [[a, b], [c]]
    assert world.bodies().tolist() == [a, b, c]
    snapshot = world.snapshot()
    world.set_kind([a, b], "static")
    assert world.update().ended.tolist() == [[a, b]]
    world.restore(snapshot)
    assert world.pairs().tolist() == [[a, b]]
    world.sleep([a, b])
    assert not world.is_awake(a)
    world.wake(a)
    assert world.is_awake(a)
    world.exclude(a, b)
    assert world.update().ended.tolist() == [[a, b]]
    with pytest.raises(graze.InputError):
        graze.World().islands()


def test_a_filter_of_a_user(unit_cube):
    world = graze.World()
    asked = []

    def lets_pass(a, b):
        asked.append((a, b))
        return len(world) == 3 and a != first

    world.set_pair_filter(lets_pass)
    first, second, third = (world.add(unit_cube) for _ in range(3))
    assert world.update().begun.tolist() == [[second, third]] and len(asked) == 3
    other = graze.World()
    other.set_pair_filter(lambda a, b: 1 / 0)
    other.add((unit_cube, np.tile(np.eye(4), (2, 1, 1))))
    with pytest.raises(ZeroDivisionError):
        other.update()
    with pytest.raises(TypeError, match="filter"):
        world.set_pair_filter(3)


def test_a_body_that_is_swept():
    world = graze.World()
    wall = world.add(graze.Box([0.01, 5, 5]), kind="static")
    bullet = world.add((graze.Sphere([0, 0, 0], 0.1), translation(-5, 0, 0)), detection="continuous")
    world.update()
    world.move(bullet, translation(5, 0, 0))
    update = world.update()
    assert len(update.begun) == 0
    assert update.first_contacts.pairs.tolist() == [[wall, bullet]] and update.first_contacts.is_hit.all()
    assert 0.48 < update.first_contacts.low[0] <= 0.489


def test_boxes():
    random = np.random.default_rng(21)
    low = random.uniform(0, 10, (1000, 3))
    boxes = np.stack([low, low + 1], axis=1)
    phase = graze.BroadPhase(threads=2)
    ids = phase.add(boxes)
    phase.update()
    overlap = ((boxes[:, None, 0] <= boxes[None, :, 1]) & (boxes[None, :, 0] <= boxes[:, None, 1])).all(axis=2)
    assert np.array_equal(phase.pairs(), np.argwhere(np.triu(overlap, 1)))
    phase.move(ids[:500], boxes[:500] + 100)
    phase.update()
    assert len(phase.ended()) > 0 and len(phase.begun()) == 0
    assert np.array_equal(phase.find_overlapping(boxes[600]), np.flatnonzero(overlap[600] & (np.arange(1000) >= 500)))
    phase.remove(ids[0])
    assert len(phase) == 999 and int(ids[0]) not in phase
    with pytest.raises(graze.StaleIdError):
        phase.remove(ids[:2])
    assert len(phase) == 999
    with pytest.raises(graze.InputError, match="box 1") as caught:
        phase.add([boxes[0], boxes[1][::-1]])
    assert caught.value.place.index == 1 and len(phase) == 999
    with pytest.raises(graze.InputError, match=r"boxes: the shape \(3,\)"):
        phase.add([1, 2, 3])


def test_many_bodies_share_a_mesh():
    mesh = cube()
    world = graze.World()
    ids = world.add((mesh, random_poses(50, 3, seed=22)))
    assert world.shape(int(ids[7])) == mesh
    update = world.update()
    poses = world.poses(ids)
    index = {int(body): i for i, body in enumerate(ids)}
    expected = {
        (int(ids[i]), int(ids[j]))
        for i in range(50)
        for j in range(i + 1, 50)
        if graze.intersects((mesh, poses[i]), (mesh, poses[j]))
    }
    assert {(int(a), int(b)) for a, b in update.begun} == expected and len(expected) > 5
    assert all(index[a] < index[b] for a, b in expected)


def test_compounds():
    dumbbell = graze.Compound([graze.Sphere([-1, 0, 0], 0.5), (graze.Box([0.5] * 3), translation(1, 0, 0))])
    assert len(dumbbell) == 2 and dumbbell.parts[1][1][0, 3] == 1
    assert len(pickle.loads(pickle.dumps(dumbbell)).parts) == 2
    world = graze.World()
    bodies = world.add((dumbbell, np.stack([np.eye(4), translation(0, 9, 0)])))
    ball = world.add(graze.Sphere([0, 0, 0], 0.5), kind="kinematic")
    assert len(world.update().begun) == 1  # the box ends where the ball does
    world.move(ball, translation(1, 9.75, 0))
    contacts = world.update().contacts
    assert contacts.pairs.tolist() == [[bodies[1], ball]] and contacts.parts.tolist() == [[1, 0]]
    assert np.allclose(contacts.contacts.depth, 0.25)
    world.set_shape(int(bodies[0]), dumbbell)
    for parts, error, says in (
        ([], graze.InputError, "parts"),
        ([graze.HalfSpace([0, 0, 1])], graze.InputError, "half-space"),
        ([graze.Plane([0, 0, 1])], graze.InputError, "plane"),
        ([graze.Box([1] * 3), (graze.Box([1] * 3), 2 * np.eye(4))], graze.PoseError, r"parts\[1\]"),
        ([3], TypeError, r"parts\[0\]"),
    ):
        with pytest.raises(error, match=says):
            graze.Compound(parts)
