"""Meshes that deform in a step, proofs that motions are free, and volumes around meshes."""

import pickle

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation


def moved(mesh, x, y, z):
    return mesh.deformed(mesh.vertices + [x, y, z])


def test_two_meshes_that_deform(unit_cube):
    still = graze.MeshPath(moved(unit_cube, 3, 0.25, 0.125), moved(unit_cube, 3, 0.25, 0.125))
    flying = graze.MeshPath(unit_cube, moved(unit_cube, 4, 0, 0))
    met = graze.first_contact_in_step(flying, still)
    assert met.time == 0.5 and not met.is_at_start and met.features in ("vertex-face", "face-vertex", "edge-edge")
    assert graze.first_contact_in_step(flying, still, clearance=1).time == 0.25
    assert graze.first_contact_in_step(still, still).is_at_start
    apart = graze.MeshPath(unit_cube, moved(unit_cube, -1, 0, 0))
    assert graze.first_contact_in_step(apart, still) is None
    all_of_them = graze.find_contacts_in_step(flying, still)
    assert len(all_of_them.time) > 1 and all_of_them.time.min() == 0.5
    first = np.flatnonzero((all_of_them.pair == met.pair).all(axis=1))[0]
    assert all_of_them.features[first] == met.features and tuple(all_of_them.places[first]) == met.places
    assert pickle.loads(pickle.dumps(all_of_them)) == all_of_them
    again = pickle.loads(pickle.dumps(flying))
    assert np.array_equal(again.start.vertices, unit_cube.vertices) and graze.first_contact_in_step(again, still) == met
    assert flying.bytes > 0


def test_a_mesh_that_folds_into_itself():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 1], [0.3, 0.2, 2], [0.2, 0.3, 2]])
    mesh = graze.Mesh(vertices, [[0, 1, 2], [3, 4, 5]])
    folded = vertices.copy()
    folded[3, 2] = -1
    path = graze.MeshPath(mesh, mesh.deformed(folded))
    met = graze.first_self_contact(path)
    assert met.time == 0.5 and met.pair == (0, 1)
    assert len(graze.find_self_contacts_in_step(path).time) >= 1
    assert graze.first_self_contact(graze.MeshPath(mesh, mesh)) is None


def test_bad_paths(unit_cube):
    with pytest.raises(graze.MeshError):
        graze.MeshPath(unit_cube, graze.Mesh(unit_cube.vertices, unit_cube.triangles[1:]))
    path = graze.MeshPath(unit_cube, unit_cube)
    for clearance in (-1, np.nan, np.inf, "far"):
        with pytest.raises(graze.InputError, match="clearance"):
            graze.first_contact_in_step(path, path, clearance=clearance)
    with pytest.raises(graze.InputError, match="start"):
        graze.first_self_contact(path, start="soon")
    with pytest.raises(TypeError):
        graze.first_contact_in_step(unit_cube, path)
    with pytest.raises(TypeError):
        graze.MeshPath(unit_cube, 3)


def test_proofs_of_freedom(unit_cube):
    rest = np.eye(4)
    motion = graze.RigidMotion.between(translation(3, 0, 0), translation(1.5, 0, 0))
    proof = graze.certify_free(unit_cube, rest, unit_cube, motion)
    assert graze.proves_freedom(proof, unit_cube, rest, unit_cube, motion) is True
    assert sorted(proof.order_a.tolist()) == list(range(12)) and len(proof.kind) == len(proof.normal)
    again = pickle.loads(pickle.dumps(proof))
    assert again == proof and graze.proves_freedom(again, unit_cube, rest, unit_cube, motion)
    into = graze.RigidMotion.between(translation(3, 0, 0), translation(-1, 0, 0))
    assert graze.certify_free(unit_cube, rest, unit_cube, into) is None
    assert graze.proves_freedom(proof, unit_cube, rest, unit_cube, into) is False
    assert graze.proves_freedom(proof._replace(clearance=5.0), unit_cube, rest, unit_cube, motion) is False
    assert graze.proves_freedom(proof._replace(normal=-proof.normal), unit_cube, rest, unit_cube, motion) is False
    assert graze.proves_freedom(proof._replace(order_a=proof.order_a[:-1]), unit_cube, rest, unit_cube, motion) is False
    short = proof._replace(kind=proof.kind[:0], size=proof.size[:0], normal=proof.normal[:0])
    assert graze.proves_freedom(short, unit_cube, rest, unit_cube, motion) is False
    for broken in (proof[:5], "proof", None):
        with pytest.raises(TypeError, match="certificate"):
            graze.proves_freedom(broken, unit_cube, rest, unit_cube, motion)
    with pytest.raises(graze.InputError, match="certificate"):
        graze.proves_freedom(proof._replace(kind=proof.kind + 9), unit_cube, rest, unit_cube, motion)
    with pytest.raises(graze.InputError, match="certificate"):
        graze.proves_freedom(proof._replace(size=proof.size[:0]), unit_cube, rest, unit_cube, motion)
    with pytest.raises(graze.InputError, match="clearance"):
        graze.certify_free(unit_cube, rest, unit_cube, motion, clearance=-1)


def test_how_far_a_motion_is_free(unit_cube):
    rest = np.eye(4)
    into = graze.RigidMotion.from_velocities(translation(3, 0, 0), [-2, 0, 0], duration=2)
    assert into.shift.tolist() == [-4, 0, 0] and into.angle == 0 and into.centre.tolist() == [3, 0, 0]
    last = graze.last_free(unit_cube, rest, unit_cube, into)
    assert 0.5 - 1e-5 < last <= 0.5
    assert graze.last_free(unit_cube, rest, unit_cube, rest) is None
    assert graze.last_free(unit_cube, rest, unit_cube, translation(3, 0, 0)) == 1
    turning = graze.RigidMotion.from_velocities(rest, [0, 0, 0], angular=[0, 0, 2], duration=0.5)
    assert turning.angle == 1 and np.allclose(turning.axis, [0, 0, 1])


def test_volumes_around_meshes_and_points(unit_cube):
    slabs = graze.bounding_kdop(unit_cube)
    along = unit_cube.vertices @ slabs.directions.T
    assert np.array_equal(slabs.min, along.min(axis=0)) and np.array_equal(slabs.max, along.max(axis=0))
    assert graze.bounding_kdop(unit_cube.vertices) == slabs
    centre, radius = graze.bounding_sphere(unit_cube.vertices)
    assert (centre == graze.bounding_sphere(unit_cube)[0]).all() and radius == graze.bounding_sphere(unit_cube)[1]
    points = np.random.default_rng(43).normal(size=(500, 3))
    pose, half = graze.bounding_obb(points)
    inside = (points - pose[:3, 3]) @ pose[:3, :3]
    assert (np.abs(inside) <= half + 1e-12).all()
    fit = graze.measure_fit(unit_cube)
    assert fit.enclosed_volume == 1 and fit.volume[0] == 1 and fit.empty_share[0] == 0 and fit.surface[0] == 6
    opened = graze.measure_fit(graze.Mesh(unit_cube.vertices, unit_cube.triangles[1:]))
    assert opened.enclosed_volume is None and np.isnan(opened.empty_share).all() and opened.relative_volume[0] == 1
    for query in (graze.bounding_sphere, graze.bounding_obb, graze.bounding_kdop):
        with pytest.raises(graze.InputError):
            query(np.empty((0, 3)))
        with pytest.raises(graze.InputError):
            query([[0, 0, np.nan]])
        with pytest.raises(graze.InputError):
            query([0, 0, 0])


def test_poses_as_text():
    for pose in random_poses(20, 3, seed=44):
        assert np.array_equal(graze.parse_pose(graze.pose_text(pose)), pose)
    with pytest.raises(graze.PoseError, match="text"):
        graze.parse_pose("1 2 3")
    with pytest.raises(graze.PoseError):
        graze.pose_text(2 * np.eye(4))


def test_hulls_have_facets_and_compare_by_all_their_points():
    points = np.random.default_rng(45).normal(size=(3000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    hull = graze.ConvexHull(points)
    moved_points = points.copy()
    moved_points[1500] *= 1.001
    other = graze.ConvexHull(moved_points)
    assert repr(hull) == repr(other) or hull != other
    assert hull != other and hash(hull) == hash(graze.ConvexHull(points)) and hull == graze.ConvexHull(points)
    corners = np.concatenate(hull.facets)
    assert set(corners.tolist()) == set(range(len(hull.vertices)))
    assert len(graze.ConvexHull(cube().vertices).facets) == 6


def test_meshes_within_their_sides():
    box = graze.Box([0.1, 0.1, 0.1])
    room = cube(4)
    assert len(graze.find_contacts(room, box).depth) == 0
    inside = graze.find_contacts(room, box, sides_a="solid")
    assert len(inside.depth) > 0 and inside.depth.max() > 1.9
    floor = graze.Mesh([[-9, -9, 0], [9, -9, 0], [0, 9, 0]], [[0, 1, 2]])
    below = translation(0, 0, -0.5)
    assert len(graze.find_contacts(floor, (box, below)).depth) == 0
    under = graze.find_contacts(floor, (box, below), sides_a=("one_sided", 1.0))
    assert np.allclose(under.depth.max(), 0.6) and under.normal[0].tolist() == [0, 0, 1]
    for sides in ("hollow", ("one_sided", -1.0), ("one_sided", "thick"), ("solid", 1.0), 3):
        with pytest.raises(graze.InputError):
            graze.find_contacts(floor, (box, below), sides_a=sides)
    with pytest.raises(graze.Error):
        graze.find_contacts(box, (box, below), sides_a="solid")
