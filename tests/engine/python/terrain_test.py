"""Terrains and maps of voxels: as the meshes and boxes that they stand for."""

import pickle

import graze
import numpy as np
import pytest
from conftest import cube, random_poses, translation


def hills(kind=np.float32):
    heights = np.random.default_rng(40).integers(0, 5, (9, 7)).astype(kind)
    return graze.HeightField(heights, spacing=(0.5, 0.25), height_scale=0.125, height_offset=-0.25)


@pytest.mark.parametrize("kind", [np.float32, np.uint16])
def test_a_field_is_its_mesh(kind, unit_cube):
    field = hills(kind)
    mesh = field.mesh()
    assert isinstance(mesh, graze.Mesh) and len(mesh.triangles) == 8 * 6 * 2
    bounds = graze.bounding_aabb(field)
    assert (bounds[0] <= mesh.bounds[0]).all() and (bounds[1] >= mesh.bounds[1]).all() and np.allclose(bounds, mesh.bounds)
    poses = random_poses(60, 1.5, seed=41)
    for shape in (graze.Box([0.3, 0.2, 0.1]), graze.Sphere([0, 0, 0], 0.3), unit_cube):
        hits = graze.intersects(field, (shape, poses))
        assert np.array_equal(hits, graze.intersects(mesh, (shape, poses))) and 0 < hits.sum() < 60
    origins = np.random.default_rng(42).uniform([0, 0, 5], [3, 2, 5], (200, 3))
    hits, expected = (graze.cast_rays(of, origins, [0.1, 0.05, -1]) for of in (field, mesh))
    assert hits == expected and hits.is_hit.any()


def test_fields_are_values(unit_cube):
    field = hills()
    again = pickle.loads(pickle.dumps(field))
    assert again == field and hash(again) == hash(field) and type(again) is graze.HeightField
    assert repr(field) == "HeightField(9 rows, 7 columns)" and field.kind == "height field"
    assert field.heights.dtype == np.float32 and hills(np.uint16).heights.dtype == np.uint16
    changed = field.with_heights(2, 3, [[7, 7]])
    assert changed != field and changed.heights[2].tolist()[3:5] == [7, 7]
    assert np.array_equal(np.delete(changed.heights, 2, 0), np.delete(field.heights, 2, 0))
    world = graze.World()
    assert world.shape(world.add(field, kind="static")) == field and field.bytes > 0


def test_holes_and_materials():
    holes = np.zeros((8, 6), bool)
    holes[0, 0] = True
    materials = np.arange(48).reshape(8, 6)
    field = graze.HeightField(np.zeros((9, 7)), holes=holes, materials=materials)
    assert graze.cast_rays(field, [0.5, 0.4, 1], [0, 0, -1]) is None
    hit = graze.cast_rays(field, [2.5, 3.4, 1], [0, 0, -1])
    assert hit.material == materials[3, 2] and hit.triangle == 2 * (3 * 6 + 2)
    again = pickle.loads(pickle.dumps(field))
    assert again == field and graze.cast_rays(again, [0.5, 0.4, 1], [0, 0, -1]) is None
    contacts = graze.find_contacts(field, (graze.Sphere([0, 0, 0], 0.5), translation(2.5, 3.4, 0.4)))
    assert contacts.material.tolist() == [[20, 0]]
    world = graze.World()
    world.add(field, kind="static")
    world.update()
    seen = world.cast_rays([2.5, 3.4, 1], [[0, 0, -1], [0, 0, 1]])
    assert seen.material.tolist() == [20, 0] and seen.triangle.tolist() == [hit.triangle, -1]


@pytest.mark.parametrize(
    "arguments, says",
    [
        (([1, 2, 3],), r"heights: the shape \(3,\)"),
        (([[0, 1]],), "row"),
        (([[0, 1], [2, np.nan]],), "row 1"),
        (([[0, 1], [2, 1 / 3]],), "row 1, column 1: 0.333"),
        (([["a", "b"], ["c", "d"]],), "heights"),
        ((np.zeros((2, 2)), (1,)), "spacing"),
        ((np.zeros((2, 2)), (0, 1)), "spacing"),
        ((np.zeros((2, 2)), (1, 1), np.nan), "scale"),
        ((np.zeros((2, 2)), (1, 1), 1, 0, [[True]]), "hole"),
        ((np.zeros((3, 3)), (1, 1), 1, 0, [[True]]), "holes: the shape"),
        ((np.zeros((2, 2)), (1, 1), 1, 0, None, [[256]]), "materials: are not all from 0 to 255"),
    ],
)
def test_what_is_no_field_is_refused(arguments, says):
    with pytest.raises(graze.InputError, match=says):
        graze.HeightField(*arguments)


def test_bad_parts_of_a_field():
    field = hills()
    with pytest.raises(graze.InputError):
        field.with_heights(8, 0, np.zeros((2, 1)))
    with pytest.raises(graze.InputError):
        field.with_heights(0, 0, np.zeros((1, 1), np.uint16))
    with pytest.raises(graze.InputError, match="first_row"):
        field.with_heights(-1, 0, np.zeros((1, 1)))


def test_materials_of_meshes():
    shape = cube()
    mesh = graze.Mesh(shape.vertices, shape.triangles, materials=np.arange(12))
    assert mesh.materials.tolist() == list(range(12)) and mesh.materials.dtype == np.uint16
    assert shape.materials is None and not mesh.materials.flags.writeable
    hits = graze.cast_rays(mesh, [[3, 0.1, 0.2], [9, 9, 9]], [-1, 0, 0])
    assert hits.material.tolist() == [hits.triangle[0], 0]
    again = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(again.materials, mesh.materials)
    plain = pickle.loads(pickle.dumps(cube()))
    assert plain.materials is None and plain != again
    signed = graze.Mesh(shape.vertices, shape.triangles.astype(np.int32), materials=[5] * 12)
    assert signed.materials.tolist() == [5] * 12
    for materials in ([1] * 11, [-1] * 12, [65536] * 12, [0.5] * 12, [[1] * 12]):
        with pytest.raises((graze.InputError, graze.MeshError), match="material"):
            graze.Mesh(shape.vertices, shape.triangles, materials=materials)
    with pytest.raises(graze.MeshError, match="-1"):
        graze.Mesh(shape.vertices, np.full((1, 3), -1, np.int32), materials=[1])


def test_what_is_known_of_vertices():
    mesh = graze.Mesh(np.zeros((3, 3)) + [[0, 0, 0], [1, 0, 0], [0, 0, 0]], [[0, 1, 2]])
    assert mesh.welded().tolist() == [0, 1, 0] and len(mesh.component_vertices()) == 1


def test_a_map_of_voxels_is_its_boxes(unit_cube):
    voxels = graze.find_voxels(unit_cube, resolution=4)
    blocks = graze.VoxelMap(*voxels)
    assert len(blocks) == 56 and np.array_equal(blocks.indices(), voxels.indices)
    assert blocks.counts == (4, 4, 4) and blocks.edge == 0.25 and blocks.origin.tolist() == [-0.5] * 3
    world = graze.World()
    body = world.add(blocks, kind="static")
    balls = world.add((graze.Sphere([0, 0, 0], 0.1), np.stack([np.eye(4), translation(0.5, 0.1, 0.1)])))
    update = world.update()
    assert update.begun.tolist() == [[body, balls[1]]]
    parts = {tuple(blocks.voxel(int(part))) for part in update.contacts.parts[:, 0]}
    assert parts <= {tuple(row) for row in voxels.indices.tolist()} and parts
    assert all(blocks.part(voxel) in update.contacts.parts[:, 0] for voxel in parts)
    blocks.add_block((1, 1, 1), (2, 2, 2))
    assert len(world.update().begun) == 0  # the body has the map as it was
    world.set_shape(body, blocks)
    assert world.update().begun.tolist() == [[body, balls[0]]]
    kept = world.shape(body)
    assert isinstance(kept, graze.VoxelMap) and len(kept) == 64
    assert isinstance(kept.box(), graze.Box)


def test_maps_change_and_are_pickled():
    blocks = graze.VoxelMap([1, 2, 3], 0.5, (10, 10, 10))
    blocks.add([[1, 2, 3], [1, 2, 4], [1, 2, 3]])
    blocks.remove([1, 2, 4])
    assert blocks.contains([[1, 2, 3], [1, 2, 4]]).tolist() == [True, False]
    blocks.add_block([0, 0, 0], [9, 9, 0])
    blocks.remove_block([0, 0, 0], [9, 4, 0])
    assert len(blocks) == 51
    again = pickle.loads(pickle.dumps(blocks))
    assert np.array_equal(again.indices(), blocks.indices()) and again.origin.tolist() == [1, 2, 3]
    with pytest.raises(graze.StaleIdError):
        blocks.part((5, 0, 0))
    for call in (
        lambda: blocks.add([[1, 2, 10]]),
        lambda: blocks.add([[1, 2, -1]]),
        lambda: blocks.add([[1.5, 2, 3]]),
        lambda: blocks.add_block((5, 5, 5), (4, 5, 5)),
        lambda: blocks.part([[1, 2, 3], [1, 2, 4]]),
        lambda: graze.VoxelMap([0, 0, np.inf], 1, (1, 1, 1)),
        lambda: graze.VoxelMap([0, 0, 0], 0, (1, 1, 1)),
        lambda: graze.VoxelMap([0, 0, 0], 1, (1, 1)),
        lambda: graze.VoxelMap([0, 0, 0], 1, (1, 1, 65536)),
        lambda: graze.World().add(graze.VoxelMap([0, 0, 0], 1, (1, 1, 1))),
    ):
        with pytest.raises(graze.InputError):
            call()


def test_voxels_go_to_files(unit_cube, tmp_path):
    voxels = graze.find_voxels(unit_cube, resolution=3)
    told = []
    graze.write_voxels(tmp_path / "voxels.ply", voxels, progress=lambda done, total: told.append(done / total))
    mesh = graze.load_mesh(tmp_path / "voxels.ply")
    assert len(mesh.triangles) == 12 * 26 and told[-1] == 1
    assert np.allclose(mesh.bounds, unit_cube.bounds)
    with pytest.raises(graze.MeshError, match="voxels.txt"):
        graze.write_voxels(tmp_path / "voxels.txt", voxels)
    with pytest.raises(graze.InputError):
        graze.write_voxels(tmp_path / "none.obj", voxels._replace(indices=voxels.indices[:0]))
    with pytest.raises(graze.InputError):
        graze.write_voxels(tmp_path / "none.obj", voxels._replace(indices=voxels.indices[::-1]))
    with pytest.raises(TypeError, match="voxels"):
        graze.write_voxels(tmp_path / "none.obj", [1, 2, 3])
    assert not (tmp_path / "none.obj").exists()
    with pytest.raises(graze.InputError, match="resolution"):
        graze.find_voxels(unit_cube, resolution=9, max_voxels=10)
