"""The collision manager for those who know trimesh's. Its documented answers, told of our own scenes."""

from types import SimpleNamespace

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation
from graze.trimesh import CollisionManager


def like_trimesh(mesh):
    return SimpleNamespace(vertices=np.asarray(mesh.vertices), faces=np.asarray(mesh.triangles, np.int64))


BOX = like_trimesh(cube())


def test_single_objects():
    manager = CollisionManager()
    manager.add_object("left", BOX, translation(-2, 0, 0))
    manager.add_object("right", BOX, translation(2, 0, 0))
    assert manager.in_collision_single(BOX) is False
    assert manager.in_collision_single(BOX, translation(-1.5, 0, 0), return_names=True) == (True, {"left"})
    hit, names, data = manager.in_collision_single(BOX, translation(1.25, 0, 0), return_names=True, return_data=True)
    assert hit and names == {"right"} and len(data) == 1
    assert data[0].names == {"right", "__external"} and np.isclose(data[0].depth, 0.25)
    assert abs(data[0].normal[0]) == 1 and 0 <= data[0].index("right") < 12
    assert manager.in_collision_single(BOX, return_data=True) == (False, [])


def test_objects_among_themselves():
    manager = CollisionManager()
    assert manager.in_collision_internal(return_names=True) == (False, set())
    manager.add_object("b", BOX)
    manager.add_object("a", BOX, translation(0.5, 0, 0))
    manager.add_object("c", BOX, translation(9, 0, 0))
    assert manager.in_collision_internal() is True
    hit, names, data = manager.in_collision_internal(return_names=True, return_data=True)
    assert hit and names == {("a", "b")} and all(contact.names == {"a", "b"} for contact in data) and data
    manager.set_transform("a", translation(8.5, 0, 0))
    assert manager.in_collision_internal(return_names=True) == (True, {("a", "c")})
    manager.remove_object("c")
    assert manager.in_collision_internal() is False
    manager.add_object("b", BOX, translation(8, 0, 0))  # in place of the former
    assert manager.in_collision_internal(return_names=True) == (True, {("a", "b")})


def test_two_managers():
    one, other = CollisionManager(), CollisionManager()
    for x in range(3):
        one.add_object(f"one {x}", BOX, translation(3 * x, 0, 0))
        other.add_object(f"other {x}", BOX, translation(3 * x + 0.5, 2 * (x == 1), 0))
    hit, names, data = one.in_collision_other(other, return_names=True, return_data=True)
    assert hit and names == {("one 0", "other 0"), ("one 2", "other 2")}
    assert {frozenset(pair) for pair in names} == {contact.names for contact in data}
    other.set_transform("other 0", translation(0, 0, 50))
    other.set_transform("other 2", translation(0, 0, 60))
    assert one.in_collision_other(other, return_names=True) == (False, set())
    distance, names, data = one.min_distance_other(other, return_names=True, return_data=True)
    assert distance == 1 and names == ("one 1", "other 1")
    assert data.point("one 1")[1] == 0.5 and data.point("other 1")[1] == 1.5


def test_distances():
    manager = CollisionManager()
    assert manager.min_distance_single(BOX) == np.inf
    manager.add_object("near", BOX, translation(0, 3, 0))
    manager.add_object("far", BOX, translation(0, 0, 7))
    assert manager.min_distance_single(BOX) == 2
    distance, name, data = manager.min_distance_single(BOX, translation(0, 0, 5), return_name=True, return_data=True)
    assert (distance, name, data.distance) == (1, "far", 1) and data.names == {"far", "__external"}
    assert manager.min_distance_single(BOX, translation(0, 2.5, 0), return_name=True) == (0, "near")
    assert 0 <= data.index("far") < 12 and data.point("__external")[2] == 5.5
    distance, names = manager.min_distance_internal(return_names=True)
    assert names == ("far", "near") and np.isclose(distance, np.hypot(2, 6))
    manager.set_transform("far", translation(0, 4.5, 0))
    assert manager.min_distance_internal() == 0.5


def test_names_and_poses_are_checked_and_not_rounded():
    manager = CollisionManager()
    with pytest.raises(ValueError, match="'none' is no object"):
        manager.set_transform("none", np.eye(4))
    with pytest.raises(ValueError, match="'none' is no object"):
        manager.remove_object("none")
    with pytest.raises(graze.PoseError):
        manager.add_object("bad", BOX, 2 * np.eye(4))
    manager.add_object("box", BOX)
    beyond = np.nextafter(1.0, 2)  # as float32 it would be 1, and touch
    assert manager.in_collision_single(BOX, translation(beyond, 0, 0)) is False
    assert manager.in_collision_single(BOX, translation(1, 0, 0)) is True


def test_many_objects_as_by_pairs():
    mesh, poses = cube(), random_poses(40, 3, seed=30)
    manager = CollisionManager()
    for i, pose in enumerate(poses):
        manager.add_object(f"{i:02}", mesh, pose)
    _, names = manager.in_collision_internal(return_names=True)
    expected = {
        (f"{i:02}", f"{j:02}")
        for i in range(40)
        for j in range(i + 1, 40)
        if graze.intersects((mesh, poses[i]), (mesh, poses[j]))
    }
    assert names == expected and expected
