"""Distances, points, rays, contacts and what else two meshes are asked: truths of a cube, and batches as single calls."""

import pickle

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, rotation, translation


def test_the_distance_of_two_cubes(unit_cube):
    gap = graze.distance(unit_cube, (unit_cube, translation(3, 0.25, 0)))
    assert gap.distance == 2
    assert gap.point_a[0] == 0.5 and gap.point_b[0] == 2.5
    assert isinstance(gap.pair[0], int)
    assert pickle.loads(pickle.dumps(gap)) == gap
    assert gap == graze.distance(unit_cube, (unit_cube, translation(3, 0.25, 0)))
    assert gap != graze.distance(unit_cube, (unit_cube, translation(4, 0.25, 0)))


def test_distances_of_many_poses(bolt, nut):
    poses = random_poses(60, 0.05, seed=11)
    many = graze.distance(bolt, (nut, poses))
    assert many.distance.shape == (60,) and many.point_a.shape == many.point_b.shape == (60, 3)
    assert many.pair.shape == (60, 2) and many.pair.dtype == np.uint32
    for i, pose in enumerate(poses):
        one = graze.distance(bolt, (nut, pose))
        assert one.distance == many.distance[i] and tuple(many.pair[i]) == one.pair
        assert np.array_equal(one.point_a, many.point_a[i]) and np.array_equal(one.point_b, many.point_b[i])
    assert pickle.loads(pickle.dumps(many)) == many
    steps = np.stack([translation(0.001 * x, 0.002, 0) for x in range(40)])
    assert graze.distance(bolt, (nut, steps), memory=graze.PairMemory()) == graze.distance(bolt, (nut, steps))
    hinted = graze.distance(bolt, (nut, poses[0]), hint=(0, 0))
    assert hinted == graze.distance(bolt, (nut, poses[0]))


@pytest.mark.parametrize("clearance", [0.0, 0.01, 0.03])
def test_within_is_what_distance_says(bolt, nut, clearance):
    poses = random_poses(60, 0.05, seed=12)
    answers = graze.within(bolt, (nut, poses), clearance)
    assert np.array_equal(answers, graze.distance(bolt, (nut, poses)).distance <= clearance)
    assert graze.within(bolt, (nut, poses[3]), clearance) == answers[3]
    assert np.array_equal(graze.within(bolt, (nut, poses), clearance, memory=graze.PairMemory()), answers)


def test_bad_distances(unit_cube):
    for clearance in (-1, np.nan):
        with pytest.raises(graze.InputError, match="clearance"):
            graze.within(unit_cube, unit_cube, clearance)
    with pytest.raises(graze.InputError, match="clearance: 'far' is not a number"):
        graze.within(unit_cube, unit_cube, "far")
    with pytest.raises(graze.InputError, match="hint"):
        graze.distance(unit_cube, unit_cube, hint=(0, 12))
    with pytest.raises(graze.InputError, match="hint"):
        graze.distance(unit_cube, unit_cube, hint=3)
    with pytest.raises(graze.InputError, match="hint: is for two meshes"):
        graze.distance(unit_cube, graze.Sphere([0, 0, 0], 1), hint=(0, 0))


def test_points_inside_and_near(unit_cube):
    points = np.array([[0, 0, 0], [0.5, 0, 0], [0.75, 0, 0], [-3, 0.5, 0.5]])
    assert graze.contains(unit_cube, points).tolist() == [True, True, False, False]
    assert graze.contains(unit_cube, points[0]) is True
    assert graze.signed_distances(unit_cube, points).tolist() == [-0.5, 0, 0.25, 2.5]
    assert graze.signed_distances(unit_cube, points[2]) == 0.25
    near = graze.nearest_points(unit_cube, points)
    assert near.point[3].tolist() == [-0.5, 0.5, 0.5] and near.distance.tolist() == [0.5, 0, 0.25, 2.5]
    assert graze.nearest_points(unit_cube, points[2]).point.tolist() == [0.5, 0, 0]
    moved = translation(10, 0, 0)
    assert np.array_equal(graze.contains((unit_cube, moved), points + [10, 0, 0]), graze.contains(unit_cube, points))


def test_many_points_in_any_layout_as_single_ones(bolt):
    points = np.random.default_rng(13).uniform(-0.01, 0.01, (3000, 3))
    inside = graze.contains(bolt, points)
    assert 0 < inside.sum() < 3000
    assert np.array_equal(inside, graze.contains(bolt, np.asfortranarray(points), threads=1))
    assert inside[:50].tolist() == [graze.contains(bolt, point) for point in points[:50]]
    assert np.array_equal(graze.signed_distances(bolt, points) <= 0, inside)


@pytest.mark.parametrize("query", [graze.contains, graze.nearest_points, graze.signed_distances])
def test_bad_points_are_named(unit_cube, query):
    points = np.zeros((2000, 3))
    points[1234, 1] = np.nan
    points[1500, 1] = np.inf
    with pytest.raises(graze.InputError, match="point 1234") as caught:
        query(unit_cube, points)
    assert caught.value.place.index == 1234
    with pytest.raises(graze.InputError, match=r"points: the shape \(2, 2\)"):
        query(unit_cube, [[0, 0], [1, 1]])
    with pytest.raises(TypeError, match="mesh: is a shape"):
        query(graze.Sphere([0, 0, 0], 1), points)
    with pytest.raises(graze.InputError, match="mesh: many poses"):
        query((unit_cube, np.tile(np.eye(4), (2, 1, 1))), points)
    if query is not graze.nearest_points:
        with pytest.raises(graze.MeshError, match="boundary edges"):
            query(graze.Mesh(unit_cube.vertices, unit_cube.triangles[1:]), [0, 0, 0])


def test_rays_at_a_cube(unit_cube):
    origins = np.array([[3, 0.1, 0.2], [3, 2, 0], [0, 0, 0]])
    hits = graze.cast_rays(unit_cube, origins, [-2, 0, 0])
    assert hits.is_hit.tolist() == [True, False, True]
    assert hits.distance.tolist() == [2.5, np.inf, 0.5]
    assert hits.normal[0].tolist() == [1, 0, 0] and np.isnan(hits.point[1]).all()
    assert hits.triangle[1] == -1 and hits.triangle[0] in (2, 3)
    assert graze.cast_rays(unit_cube, [3, 2, 0], [-1, 0, 0]) is None
    one = graze.cast_rays(unit_cube, origins[0], [-1, 0, 0])
    assert one.distance == 2.5 and one.triangle == hits.triangle[0]
    assert graze.cast_rays(unit_cube, origins, [-1, 0, 0], [2.0, 9, 9]).is_hit.tolist() == [False, False, True]
    assert len(graze.cast_ray_all(unit_cube, [3, 0.1, 0.2], [-1, 0, 0]).distance) == 2
    ball = graze.cast_rays(graze.Sphere([0, 0, 0], 1), origins, [-1, 0, 0])
    assert np.allclose(ball.distance, [3 - np.sqrt(1 - 0.05), np.inf, 0]) and ball.triangle.tolist() == [-1] * 3


def test_many_rays_as_single_ones(bolt):
    random = np.random.default_rng(14)
    origins = random.normal(size=(2000, 3)) * 0.02
    hits = graze.cast_rays(bolt, origins, -origins)
    for i in range(0, 2000, 100):
        one = graze.cast_rays(bolt, origins[i], -origins[i])
        assert (one is not None) == hits.is_hit[i]
        assert one is None or (one.distance == hits.distance[i] and one.triangle == hits.triangle[i])


def test_bad_rays_are_named(unit_cube):
    directions = np.tile([1.0, 0, 0], (1000, 1))
    directions[777] = 0
    with pytest.raises(graze.InputError, match="ray 777") as caught:
        graze.cast_rays(unit_cube, [0, 0, 0], directions)
    assert caught.value.place.element == "ray" and caught.value.place.index == 777
    with pytest.raises(graze.InputError, match="directions: are 1000, and there are 3 rays"):
        graze.cast_rays(unit_cube, np.zeros((3, 3)), directions)
    with pytest.raises(graze.InputError, match="max_distance"):
        graze.cast_rays(unit_cube, [0, 0, 0], [1, 0, 0], np.ones((2, 2)))


def test_contacts_of_meshes(unit_cube):
    contacts = graze.find_contacts(unit_cube, (cube(0.5), translation(0.625, 0, 0)))
    assert contacts.depth.tolist() == [0.125] and contacts.is_complete
    assert contacts.normal[0].tolist() == [1, 0, 0]
    assert contacts.offsets[-1] == len(contacts.corners) > 2
    assert len(graze.find_contacts(unit_cube, (unit_cube, translation(9, 0, 0))).depth) == 0


def test_intersections(unit_cube):
    met = graze.find_intersection(unit_cube, (unit_cube, translation(0.75, 0.1, 0.2)))
    assert len(met.curves) == 1 and met.is_closed.all()
    assert set(met.segments.ravel()) <= set(range(len(met.points)))
    assert met.curves[0].tolist() == [0, len(met.segments)]
    face = graze.find_intersection(unit_cube, (unit_cube, translation(1, 0, 0)))
    assert len(face.patches) == 1 and (face.points[:, 0] == 0.5).all()
    corner = graze.find_intersection(unit_cube, (unit_cube, translation(1, 1, 1)))
    assert len(corner.touching_points) == 1 and corner.points[corner.touching_points[0]].tolist() == [0.5] * 3
    assert len(graze.find_intersection(unit_cube, (unit_cube, translation(2, 0, 0))).points) == 0


def test_separations(unit_cube):
    pose = translation(0.75, 0, 0)
    away = graze.separating_translation(unit_cube, (unit_cube, pose))
    assert 0.25 <= away.distance < 0.25 + 1e-9
    assert not graze.intersects(unit_cube, (unit_cube, away.pose_b))
    along = graze.separating_translation(unit_cube, (unit_cube, pose), [0, 0, 7])
    assert 1 <= along.distance < 1 + 1e-9 and along.direction.tolist() == [0, 0, 1]
    with pytest.raises(graze.InputError, match="direction"):
        graze.separating_translation(unit_cube, unit_cube, [0, 0, 0])


def test_a_mesh_by_itself(unit_cube):
    health = graze.check(unit_cube)
    assert health.is_healthy and not graze.self_intersects(unit_cube)
    broken = graze.Mesh(unit_cube.vertices, unit_cube.triangles[1:][:, [0, 2, 1]])
    health = graze.check(broken)
    assert not health.is_healthy and len(health.open_edges) == 3
    crossing = graze.Mesh(
        np.vstack([unit_cube.vertices, unit_cube.vertices + 0.5]), np.vstack([unit_cube.triangles, unit_cube.triangles + 8])
    )
    assert graze.self_intersects(crossing) and len(graze.check(crossing).self_intersections) > 0
    assert len(graze.find_self_pairs(crossing, kind="intersecting").pairs) > 0
    assert not graze.find_self_pairs(crossing, limit=1).is_complete
    assert len(graze.find_self_pairs(unit_cube, kind="neighbour").pairs) > 18
    told = []
    graze.check(crossing, progress=lambda done, total: told.append(done))
    assert told[-1] == 24


def test_voxels_and_volumes(unit_cube):
    voxels = graze.find_voxels(unit_cube, resolution=4)
    assert voxels.counts == (4, 4, 4) and len(voxels.indices) == 4**3 - 2**3
    assert len(graze.find_voxels(unit_cube, resolution=4, fill="solid").indices) == 4**3
    assert voxels.edge == 0.25 and voxels.origin.tolist() == [-0.5] * 3
    for resolution in (0, 65536, -1, 1.5):
        with pytest.raises(graze.InputError, match="resolution"):
            graze.find_voxels(unit_cube, resolution=resolution)
    centre, radius = graze.bounding_sphere(unit_cube)
    assert np.allclose(centre, 0) and np.isclose(radius, np.sqrt(0.75))
    turned = graze.Mesh(unit_cube.vertices @ rotation([1, 2, 3], 0.5)[:3, :3].T, unit_cube.triangles)
    _, half_extents = graze.bounding_obb(turned)
    assert np.allclose(half_extents, 0.5)


def test_cases_are_kept_and_asked_again(unit_cube, tmp_path):
    pose = translation(0.75, 0.1, 0.2)
    for ask in ("any", "pairs", "distance", "contacts", "intersection", "separation"):
        case = graze.to_case(ask, unit_cube, (unit_cube, pose), note="a cube")
        case.write(tmp_path / "case.json")
        again = graze.read_case(tmp_path / "case.json")
        assert again.ask == ask and again.note == "a cube"
        assert again.is_answered_the_same() and again.answer == case.answer == case.ask_again()
        assert pickle.loads(pickle.dumps(case)).to_json() == case.to_json()
    assert graze.to_case("within", unit_cube, (unit_cube, translation(2, 0, 0)), clearance=1).answer["says"] is True
    assert graze.to_case("self_any", unit_cube).answer["says"] is False
    ball = graze.Sphere([0, 0, 0], 1)
    assert graze.to_case("distance", ball, (ball, translation(3, 0, 0))).answer["distance"] == 1
    with pytest.raises(graze.InputError, match="ask"):
        graze.to_case("nothing", unit_cube)
    (tmp_path / "bad.json").write_text("{}")
    with pytest.raises(graze.CaseError, match="bad.json:1"):
        graze.read_case(tmp_path / "bad.json")


def test_a_mesh_straight_at_another(unit_cube):
    met = graze.cast(unit_cube, (unit_cube, translation(3, 0.25, 0)), [-4, 0, 0])
    assert met.time == 0.5 and not met.is_at_start and met.normal.tolist() == [1, 0, 0]
    assert graze.cast(unit_cube, (unit_cube, translation(3, 0, 0)), [-1, 0, 0]) is None
    resting = (unit_cube, translation(1, 0, 0))
    assert graze.cast(unit_cube, resting, [1, 0, 0]).is_at_start
    assert graze.cast(unit_cube, resting, [1, 0, 0], start="is_left") is None
    ball = graze.cast(graze.Sphere([0, 0, 0], 1), (graze.Sphere([0, 0, 0], 1), translation(4, 0, 0)), [-4, 0, 0])
    assert np.isclose(ball.time, 0.5) and ball.time <= 0.5
    with pytest.raises(graze.InputError, match="displacement"):
        graze.cast(unit_cube, resting, [np.nan, 0, 0])


def test_rigid_motions(unit_cube):
    rest = np.eye(4)
    motion = graze.RigidMotion.between(translation(3, 0, 0), translation(1.5, 0, 0))
    assert graze.is_free(unit_cube, rest, unit_cube, motion)
    into = graze.RigidMotion.between(translation(3, 0, 0), translation(-1, 0, 0))
    met = graze.first_contact(unit_cube, rest, unit_cube, into)
    assert met.status == "hit" and 0.5 - 1e-5 < met.low <= 0.5 <= met.high
    many = graze.first_contact(unit_cube, rest, unit_cube, [motion, into, motion])
    assert many.status.tolist() == ["free", "hit", "free"] and many.low[1] == met.low
    assert graze.is_free(unit_cube, rest, unit_cube, [motion, into]).tolist() == [True, False]
    assert graze.is_free(graze.Sphere([0, 0, 0], 0.5), rest, unit_cube, motion)
    assert np.array_equal(into.at(0), translation(3, 0, 0)) and into.at([0, 1]).shape == (2, 4, 4)
    assert pickle.loads(pickle.dumps(into)) == into
    turn = graze.RigidMotion(rest, axis=[0, 0, 2], angle=np.pi / 2)
    assert np.allclose(turn.at(1), rotation([0, 0, 1], np.pi / 2))
    with pytest.raises(graze.PoseError, match=r"motion_b\[1\]"):
        graze.is_free(unit_cube, rest, unit_cube, [motion, 2 * rest])
    with pytest.raises(graze.InputError):
        into.at(1.5)
    with pytest.raises(TypeError, match="a: has no pose"):
        graze.is_free((unit_cube, rest), rest, unit_cube, motion)
    assert graze.first_contact(cube(), rest, unit_cube, motion, clearance=0.6).status != "free"


def test_triangles_in_a_volume(unit_cube):
    box = graze.find_triangles(unit_cube, [[0.25, -0.1, -0.1], [2, 0.1, 0.1]])
    turned = graze.find_triangles(unit_cube, (graze.Box([0.75, 0.1, 0.1]), translation(1.25, 0, 0)))
    ball = graze.find_triangles(unit_cube, (graze.Sphere([0, 0, 0], 0.5), translation(1, 0.1, 0)))
    assert box.triangles.tolist() == turned.triangles.tolist() == [2, 3] and box.is_complete
    assert set(ball.triangles.tolist()) <= {2, 3} and len(ball.triangles) > 0
    assert not graze.find_triangles(unit_cube, unit_cube.bounds, limit=5).is_complete
    with pytest.raises(graze.InputError, match="volume: is a cone"):
        graze.find_triangles(unit_cube, graze.Cone(1, 1))
    with pytest.raises(graze.InputError, match="volume"):
        graze.find_triangles(unit_cube, [0, 0, 0])
