"""A notebook's worth of calls with bad arguments: each is refused by a typed error of one line, and what was given stays
usable. Run under AddressSanitizer, too."""

import gc
import pickle

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation

NAN, INF = float("nan"), float("inf")
EYE = np.eye(4)
MESH = cube()
OPEN = graze.Mesh(MESH.vertices, MESH.triangles[1:])
LARGE = cube(3e307)
BALL = graze.Sphere([0, 0, 0], 1)
GROUND = graze.HalfSpace([0, 0, 1])
MANY = np.tile(EYE, (5, 1, 1))
WORLD = graze.World()
BODY = int(WORLD.add(MESH))
WORLD.update()
BOXES = graze.BroadPhase()
BOX = int(BOXES.add([[0, 0, 0], [1, 1, 1]]))
MOTION = graze.RigidMotion(EYE)
PATH = graze.MeshPath(MESH, MESH)
MEMORY = graze.PairMemory()
BLOCKS = graze.VoxelMap([0, 0, 0], 1, (4, 4, 4))
FIELD = graze.HeightField(np.zeros((3, 3)))
OLD = graze.World().add(MESH) + (7 << 32)


class Liar:
    """Looks like a mesh, and is none."""

    vertices = "many"
    faces = None


class Exploding:
    """An array whose conversion fails."""

    def __array__(self, dtype=None):
        raise RuntimeError("boom")


CALLS = [
    lambda: graze.Mesh(None, None),
    lambda: graze.Mesh([], []),
    lambda: graze.Mesh(Liar()),
    lambda: graze.Mesh(np.zeros((3, 3)), [[0, 1, 3]]),
    lambda: graze.Mesh(np.zeros((3, 3)), [[0, 1, -1]]),
    lambda: graze.Mesh(np.full((3, 3), NAN), [[0, 1, 2]]),
    lambda: graze.Mesh(np.zeros((3, 3)), [[0, 1, 2]], [1, 2]),
    lambda: graze.Mesh(np.zeros((0, 3)), np.zeros((0, 3), int)),
    lambda: MESH.deformed(MESH.vertices[:3]),
    lambda: MESH.deformed(np.full((8, 3), INF)),
    lambda: graze.load_mesh("/nowhere/none.obj"),
    lambda: graze.load_mesh("/"),
    lambda: graze.load_mesh(b"\xff\xfe.stl"),
    lambda: graze.load_poses("/nowhere"),
    lambda: graze.intersects(MESH, None),
    lambda: graze.intersects(MESH, (MESH,)),
    lambda: graze.intersects(MESH, (MESH, EYE, EYE)),
    lambda: graze.intersects(MESH, (MESH, np.zeros((4, 4)))),
    lambda: graze.intersects(MESH, (MESH, np.full((4, 4), NAN))),
    lambda: graze.intersects(MESH, (LARGE, translation(1.7e308, 0, 0))),
    lambda: graze.intersects(MESH, (MESH, np.zeros((2, 3, 3)))),
    lambda: graze.intersects(MESH, (MESH, np.zeros((1, 1, 4, 4)))),
    lambda: graze.intersects((MESH, MANY), (MESH, MANY[:4])),
    lambda: graze.intersects(MESH, MESH, hit="all"),
    lambda: graze.intersects(MESH, BALL, hit="solid"),
    lambda: graze.intersects(OPEN, MESH, hit="solid"),
    lambda: graze.intersects(MESH, BALL, memory=MEMORY),
    lambda: graze.intersects(MESH, (MESH, MANY), threads=2**40),
    lambda: graze.intersects(MESH, (MESH, MANY), threads="two"),
    lambda: graze.intersects(MESH, (MESH, MANY), progress=5),
    lambda: graze.intersects(MESH, MESH, work={}),
    lambda: graze.find_triangle_pairs(MESH, BALL),
    lambda: graze.find_triangle_pairs(MESH, MESH, limit=-1),
    lambda: graze.find_triangle_pairs(MESH, MESH, touch="maybe"),
    lambda: graze.interiors_intersect(OPEN, MESH),
    lambda: graze.distance(MESH, MESH, hint=(0, 99)),
    lambda: graze.distance(MESH, MESH, hint=(2**33, 0)),
    lambda: graze.within(MESH, MESH, NAN),
    lambda: graze.within(BALL, MESH, -1),
    lambda: graze.find_separation(MESH, BALL),
    lambda: graze.find_contacts(MESH, (MESH, 2 * MANY)),
    lambda: graze.find_contacts(GROUND, GROUND),
    lambda: graze.find_contacts(MESH, BALL, margin=NAN),
    lambda: graze.find_contacts(OPEN, BALL, sides_a="solid"),
    lambda: graze.find_intersection(BALL, MESH),
    lambda: graze.separating_translation(MESH, MESH, [0, 0, 0]),
    lambda: graze.separating_translation(MESH, MESH, [INF, 0, 0]),
    lambda: graze.contains(OPEN, [0, 0, 0]),
    lambda: graze.contains(MESH, [[0, 0]]),
    lambda: graze.contains(MESH, [[0, 0, NAN]]),
    lambda: graze.nearest_points(BALL, [0, 0, 0]),
    lambda: graze.signed_distances((MESH, MANY), [0, 0, 0]),
    lambda: graze.cast_rays(MESH, [0, 0, 0], [0, 0, 0]),
    lambda: graze.cast_rays(MESH, [[0, 0, 0]] * 2, [[1, 0, 0]] * 3),
    lambda: graze.cast_rays(MESH, [0, 0, 0], [1, 0, 0], -1),
    lambda: graze.cast_rays(MESH, [0, 0, 0], [1, 0, 0], "far"),
    lambda: graze.cast_ray_all(MESH, [[0, 0, 0]] * 2, [0, 0, 0]),
    lambda: graze.cast(MESH, (MESH, MANY), [[1, 0, 0]] * 4),
    lambda: graze.cast(BALL, BALL, [[1, 0, 0], [NAN, 0, 0]]),
    lambda: graze.find_intersection(MESH, (MESH, MANY * [[[1], [1], [1], [3]]])),
    lambda: graze.separating_translation(MESH, (MESH, np.full((2, 3, 4), NAN))),
    lambda: graze.find_separation(BALL, (BALL, 3 * MANY)),
    lambda: graze.cast(MESH, MESH, [1, NAN, 0]),
    lambda: graze.cast(MESH, BALL, [1, 0, 0], start="is_left"),
    lambda: graze.first_contact(MESH, EYE, MESH, MOTION, clearance=-1),
    lambda: graze.first_contact(MESH, EYE, MESH, MOTION, tolerance=NAN),
    lambda: graze.first_contact(MESH, EYE, MESH, MOTION, budget=-1),
    lambda: graze.first_contact(MESH, EYE, MESH, [MOTION, 3]),
    lambda: graze.is_free((MESH, EYE), EYE, MESH, MOTION),
    lambda: graze.last_free(MESH, EYE, MESH, 2 * EYE),
    lambda: graze.last_free(BALL, EYE, MESH, EYE),
    lambda: graze.certify_free(MESH, EYE, None, EYE),
    lambda: graze.proves_freedom((1, 2, 3, 4, 5, 6), MESH, EYE, MESH, EYE),
    lambda: graze.RigidMotion(EYE, axis=[0, 0, 0]),
    lambda: graze.RigidMotion(EYE, angle=1e9),
    lambda: graze.RigidMotion.between(EYE, 3 * EYE),
    lambda: MOTION.at(2),
    lambda: MOTION.at([[0.5]]),
    lambda: MOTION.at([NAN]),
    lambda: graze.MeshPath(MESH, OPEN),
    lambda: graze.first_contact_in_step(PATH, PATH, clearance=-1),
    lambda: graze.find_self_contacts_in_step(PATH, start=None),
    lambda: graze.find_triangles(MESH, [[1, 1, 1], [0, 0, 0]]),
    lambda: graze.find_triangles(MESH, graze.Cone(1, 1)),
    lambda: graze.find_voxels(MESH, resolution=0),
    lambda: graze.find_voxels(OPEN, fill="solid"),
    lambda: graze.find_voxels((MESH, MANY)),
    lambda: graze.write_voxels("/nowhere/v.obj", graze.find_voxels(MESH, resolution=2)),
    lambda: graze.prepare(MESH, queries="none"),
    lambda: graze.check(BALL),
    lambda: graze.find_self_pairs(MESH, kind="other"),
    lambda: graze.bounding_kdop([[0, 0, INF]]),
    lambda: graze.bounding_aabb((BALL, MANY)),
    lambda: graze.Sphere([0, 0, 0], NAN),
    lambda: graze.Box([1, 1, -1]),
    lambda: graze.Capsule(-1, 1),
    lambda: graze.Cylinder(1, INF),
    lambda: graze.Ellipsoid([0, 0, 0], [1, 0, 1]),
    lambda: graze.ConvexHull([[0, 0, 0]] * 4),
    lambda: graze.ConvexHull([[NAN, 0, 0]] * 4),
    lambda: graze.Shape("teapot"),
    lambda: graze.Shape("sphere"),
    lambda: graze.Shape("height field", 1),
    lambda: graze.HeightField(np.zeros((1, 1))),
    lambda: FIELD.with_heights(2, 2, np.zeros((2, 2))),
    lambda: graze.Compound([]),
    lambda: graze.Compound([GROUND]),
    lambda: graze.Compound([BALL], filters=[(1, 2)]),
    lambda: BLOCKS.add([[4, 0, 0]]),
    lambda: BLOCKS.voxel(3),
    lambda: BLOCKS.part((0, 0, 0)),
    lambda: WORLD.add(MESH, kind="soft"),
    lambda: WORLD.add((MESH, MANY * 2)),
    lambda: WORLD.add(MESH, filter="all"),
    lambda: WORLD.add(MESH, filter=(1, 2**40, 0)),
    lambda: WORLD.add(MESH, margin=-1),
    lambda: WORLD.add(MESH, sides=("one_sided", 0)),
    lambda: WORLD.add(MESH, user_data=-1),
    lambda: WORLD.add(BLOCKS),
    lambda: WORLD.move(BODY, MANY),
    lambda: WORLD.move([BODY], 2 * MANY[:1]),
    lambda: WORLD.move(OLD, EYE),
    lambda: WORLD.remove(-1),
    lambda: WORLD.remove([BODY, OLD]),
    lambda: WORLD.poses(OLD),
    lambda: WORLD.shape([BODY]),
    lambda: WORLD.set_kind(BODY, 3),
    lambda: WORLD.set_margin(BODY, NAN),
    lambda: WORLD.set_shape(OLD, MESH),
    lambda: WORLD.set_pair_filter(3),
    lambda: WORLD.exclude(BODY, OLD),
    lambda: WORLD.island(BODY),
    lambda: WORLD.find_within(BALL, INF),
    lambda: WORLD.find_in_box([[1, 1, 1], [0, 0, 0]]),
    lambda: WORLD.find_touching((WORLD, 2 * EYE)),
    lambda: WORLD.cast_rays([0, 0, 0], [[1, 0, 0], [NAN, 0, 0]]),
    lambda: WORLD.cast(BALL, 2 * EYE),
    lambda: WORLD.cast(BALL, MANY),
    lambda: WORLD.cast((BALL, EYE), [MOTION]),
    lambda: WORLD.cast_all(BALL, [MOTION], clearance=NAN),
    lambda: WORLD.cast_all(BALL, [MOTION, 3]),
    lambda: WORLD.cast_ray_all([[0, 0, 0]] * 2, [[1, 0, 0], [0, 0, 0]]),
    lambda: WORLD.draw(segments=1),
    lambda: WORLD.restore(3),
    lambda: graze.World(threads=-1),
    lambda: graze.World(number=256),
    lambda: graze.World(sliding_depth=NAN),
    lambda: BOXES.add([[1, 1, 1], [0, 0, 0]]),
    lambda: BOXES.add([[0, 0, 0], [1, 1, NAN]]),
    lambda: BOXES.move(BOX, [[[0, 0, 0], [1, 1, 1]]]),
    lambda: BOXES.move(BOX + (5 << 32), [[0, 0, 0], [1, 1, 1]]),
    lambda: BOXES.remove([BOX, 99]),
    lambda: graze.to_case("all", MESH),
    lambda: graze.to_case("any", (MESH, MANY), MESH),
    lambda: graze.read_case("/nowhere"),
    lambda: graze.parse_pose("1 2"),
    lambda: graze.sweep(graze.over_poses(graze.intersects, MESH, MESH), MANY, chunk=0),
    lambda: graze.sweep(graze.over_poses(graze.intersects, MESH, MESH), np.zeros((5, 2, 2))),
]


@pytest.mark.parametrize("call", CALLS, ids=[str(i) for i in range(len(CALLS))])
def test_a_bad_argument_is_refused_by_a_typed_error(call):
    with pytest.raises((graze.Error, TypeError, IndexError)) as caught:
        call()
    text = str(caught.value)
    assert text
    if isinstance(caught.value, graze.Error):
        assert "\n" not in text
        again = pickle.loads(pickle.dumps(caught.value))
        assert type(again) is type(caught.value) and again.place == caught.value.place


def test_what_an_argument_raises_by_itself_comes_out():
    with pytest.raises(RuntimeError, match="boom"):
        graze.intersects(MESH, (MESH, Exploding()))


def test_what_was_given_stays_usable():
    assert graze.intersects(MESH, MESH) and len(WORLD) == 1 and len(BOXES) == 1 and len(BLOCKS) == 0
    assert WORLD.update().begun.shape == (0, 2)


def test_results_outlive_what_they_came_from():
    mesh = cube(3)
    vertices, triangles, welded = mesh.vertices, mesh.triangles, mesh.welded()
    found = graze.find_triangle_pairs(mesh, (mesh, random_poses(20, 1, seed=70)))
    world = graze.World()
    world.add((mesh, random_poses(20, 3, seed=71)))
    update = world.update()
    snapshot = world.snapshot()
    del mesh, world
    gc.collect()
    assert vertices.max() == 1.5 and triangles.max() == 7 and welded.tolist() == list(range(8))
    assert found.pairs.max() < 12 and len(update.contacts.contacts.depth) == update.contacts.offsets[-1]
    other = graze.World()
    other.restore(snapshot)
    assert len(other) == 20


def test_callbacks_that_meddle():
    """Filters and reports of progress that change or ask what they are called from."""
    world = graze.World()
    asked = []

    def filter_that_asks(a, b):
        asked.append(len(world))
        if len(asked) == 1:
            with pytest.raises(graze.InputError):
                world.move(a, EYE)
        return True

    world.set_pair_filter(filter_that_asks)
    world.add((MESH, MANY))
    assert len(world.update().begun) == 10 and len(asked) == 10
    nested = []

    def report(done, total):
        nested.append(graze.intersects(MESH, (MESH, MANY)).sum())

    poses = random_poses(300, 1, seed=72)
    assert graze.intersects(MESH, (MESH, poses), progress=report).shape == (300,) and nested[-1] == 5
