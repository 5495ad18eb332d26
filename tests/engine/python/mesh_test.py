"""Meshes from arrays of all kinds, and what is refused."""

import os
import pickle
from types import SimpleNamespace

import graze
import numpy as np
import pytest
from conftest import MESHES, cube

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


@pytest.mark.parametrize(
    "vertices",
    [
        CORNERS.astype(np.float32),
        CORNERS.astype(">f8"),
        CORNERS.astype(np.float16),
        CORNERS.astype(np.int64),
        CORNERS.astype(np.uint8),
        np.asfortranarray(CORNERS),
        np.repeat(CORNERS, 2, axis=0)[::2],
        np.hstack([CORNERS, CORNERS])[:, :3],
        CORNERS.tolist(),
    ],
)
def test_vertices_of_any_kind_lose_nothing(vertices):
    mesh = graze.Mesh(vertices, FACES)
    assert np.array_equal(mesh.vertices, CORNERS)
    assert mesh.vertices.dtype == np.float64


def test_unaligned_vertices_are_read():
    raw = np.zeros(CORNERS.nbytes + 1, np.uint8)
    unaligned = raw[1:].view(np.float64).reshape(4, 3)
    unaligned[...] = CORNERS
    assert np.array_equal(graze.Mesh(unaligned, FACES).vertices, CORNERS)


@pytest.mark.parametrize("kind", [np.int8, np.uint16, np.int32, np.uint32, np.int64, np.uint64, ">i4", ">u8"])
def test_triangles_of_any_kind_of_whole_number(kind):
    mesh = graze.Mesh(CORNERS, FACES.astype(kind))
    assert np.array_equal(mesh.triangles, FACES)
    assert mesh.triangles.dtype == np.uint32


def test_views_are_of_the_mesh_and_cannot_be_written_to():
    mesh = graze.Mesh(CORNERS, FACES)
    assert not mesh.vertices.flags.writeable and not mesh.triangles.flags.writeable
    assert mesh.vertices.__array_interface__["data"][0] == mesh.vertices.__array_interface__["data"][0]
    with pytest.raises(ValueError):
        mesh.vertices[0, 0] = 1
    vertices = mesh.vertices
    del mesh
    assert np.array_equal(vertices, CORNERS)  # a view keeps the mesh


def test_a_mesh_of_whatever_has_vertices_and_faces():
    like = SimpleNamespace(vertices=CORNERS, faces=FACES)
    assert np.array_equal(graze.Mesh(like).triangles, FACES)
    assert graze.Mesh(graze.Mesh(like)) is not None
    mesh = graze.Mesh(like)
    assert graze.Mesh(mesh) == mesh
    with pytest.raises(TypeError, match="no members vertices and faces"):
        graze.Mesh(CORNERS)


@pytest.mark.parametrize(
    "vertices, triangles, error, says",
    [
        (CORNERS[:, :2], FACES, graze.InputError, r"vertices: the shape \(4, 2\)"),
        (CORNERS.ravel(), FACES, graze.InputError, r"vertices: the shape \(12,\)"),
        (CORNERS, FACES[:, :2], graze.InputError, r"triangles: the shape \(4, 2\)"),
        (CORNERS, FACES.astype(float), graze.InputError, "triangles: numbers of the type float64 are no indices"),
        (CORNERS.astype(complex), FACES, graze.InputError, "vertices: numbers of the type complex128"),
        (CORNERS.astype(bool), FACES, graze.InputError, "vertices: numbers of the type bool"),
        (np.array([["a"] * 3]), FACES, graze.InputError, "vertices"),
        (np.full((4, 3), 2**53 + 1), FACES, graze.InputError, r"vertices: whole numbers beyond 2\^53"),
        ([[0, 0, 0], [1, 1]], FACES, graze.InputError, "vertices"),
        (CORNERS, FACES + 1, graze.MeshError, "triangle 1.*4"),
        (CORNERS, FACES - 1, graze.MeshError, "triangle 0.*-1"),
        (CORNERS, (FACES - 1).astype(np.int32), graze.MeshError, "triangle 0.*-1"),
        (CORNERS, FACES[:0], graze.MeshError, "no triangles"),
        (np.where(CORNERS == 1, np.nan, CORNERS), FACES, graze.MeshError, "vertex 1"),
        (np.where(CORNERS == 1, np.inf, CORNERS), FACES, graze.MeshError, "vertex 1"),
    ],
)
def test_what_is_no_mesh_is_refused_by_name(vertices, triangles, error, says):
    with pytest.raises(error, match=says) as caught:
        graze.Mesh(vertices, triangles)
    assert isinstance(caught.value, graze.Error) and isinstance(caught.value, ValueError)


def test_errors_tell_programs_the_place():
    with pytest.raises(graze.MeshError) as caught:
        graze.Mesh(CORNERS, FACES + 1)
    assert caught.value.place.element == "triangle" and caught.value.place.index == 1
    with pytest.raises(graze.MeshError) as caught:
        graze.load_mesh(MESHES / "none.stl")
    assert caught.value.place.file == str(MESHES / "none.stl")
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.place == caught.value.place and str(again) == str(caught.value)


def test_what_is_known_of_a_mesh():
    mesh = cube(2)
    assert mesh.bounds.tolist() == [[-1, -1, -1], [1, 1, 1]]
    assert mesh.topology == graze.Topology(8, 1, 0, 0, 0, True)
    assert mesh.signed_volume() == 8
    assert repr(mesh) == "Mesh(8 vertices, 12 triangles)"


def test_a_deformed_mesh_has_the_same_triangles():
    mesh = cube()
    moved = mesh.deformed(mesh.vertices + 1)
    assert np.array_equal(moved.triangles, mesh.triangles)
    assert moved.bounds.tolist() == [[0.5] * 3, [1.5] * 3]
    with pytest.raises(graze.MeshError):
        mesh.deformed(mesh.vertices[:-1])


def test_a_mesh_that_is_pickled_often_is_built_once():
    data = pickle.dumps(cube(3))
    first = pickle.loads(data)
    work = graze.Work()
    graze.intersects(first, first, work=work)
    assert all(pickle.loads(data) is first for _ in range(1000))
    before = work.trees_built
    graze.intersects(pickle.loads(data), pickle.loads(data), work=work)
    assert work.trees_built == before
    original = cube(5)
    assert pickle.loads(pickle.dumps(original)) is original


def test_a_pickled_mesh_goes_out_of_band_where_it_can():
    buffers = []
    data = pickle.dumps(cube(7), protocol=5, buffer_callback=buffers.append)
    assert len(buffers) == 2
    assert pickle.loads(data, buffers=buffers).signed_volume() == 343


def test_poses_of_files(tmp_path):
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, 0, 3] = 1, 2, 3
    np.save(tmp_path / "poses.npy", poses)
    assert np.array_equal(graze.load_poses(tmp_path / "poses.npy"), poses)
    (tmp_path / "poses.txt").write_text("1 0 0 5 0 1 0 6 0 0 1 7\n")
    assert graze.load_poses(str(tmp_path / "poses.txt"))[0, :3, 3].tolist() == [5, 6, 7]
    (tmp_path / "bad.txt").write_text("1 0 0 5\n")
    with pytest.raises(graze.PoseError, match="bad.txt:1"):
        graze.load_poses(tmp_path / "bad.txt")


def test_prepare_leaves_nothing_to_build():
    mesh = cube(9)
    graze.prepare(mesh, queries="all")
    work = graze.Work()
    graze.intersects(mesh, (mesh, np.eye(4)), work=work)
    assert work.trees_built == work.treelets_built == 0
    with pytest.raises(graze.InputError, match="queries"):
        graze.prepare(mesh, queries="some")


def test_functions_can_be_pickled():
    assert pickle.loads(pickle.dumps(graze.intersects)) is graze.intersects
    assert pickle.loads(pickle.dumps([len, "a".upper]))[1]() == "A"


def test_files_whose_names_are_no_text(tmp_path, unit_cube):
    name = bytes(tmp_path) + b"/\xff\xfe.obj"
    graze.write_voxels(name, graze.find_voxels(unit_cube, resolution=1))
    assert len(graze.load_mesh(name).triangles) == 12
    with pytest.raises(graze.MeshError) as caught:
        graze.load_mesh(name + b".stl")
    assert caught.value.place.file == os.fsdecode(name + b".stl")
