#!/usr/bin/env python3
"""python-fcl behind the pipe, meshes and shapes: needs the packages python-fcl and numpy."""

import fcl
import numpy as np

from graze_peer import Unsupported, serve


def model_of(mesh):
    model = fcl.BVHModel()
    model.beginModel(len(mesh["triangles"]), len(mesh["vertices"]))
    model.addSubModel(np.array(mesh["vertices"]), np.array(mesh["triangles"]))
    model.endModel()
    return model


def placed(geometry, pose, centre=(0, 0, 0)):
    rows = np.array(pose).reshape(3, 4)
    return fcl.CollisionObject(geometry, fcl.Transform(rows[:, :3], rows[:, :3] @ centre + rows[:, 3]))


def ask(question, a, b):
    if question == "any":
        return {"says": fcl.collide(a, b, fcl.CollisionRequest(), fcl.CollisionResult()) > 0}
    return {"distance": fcl.distance(a, b, fcl.DistanceRequest(), fcl.DistanceResult())}


def load(mesh_a, mesh_b):
    model_a, model_b = model_of(mesh_a), model_of(mesh_b)
    return lambda question, pose_a, pose_b, settings: ask(question, placed(model_a, pose_a), placed(model_b, pose_b))


def geometry_of(shape):
    """What it is, and where its middle is; None of what FCL's bindings do not have."""
    ((kind, of),) = shape.items()
    middle = np.zeros(3)
    if kind == "sphere":
        return fcl.Sphere(of["radius"]), np.array(of["centre"])
    if kind == "box":
        return fcl.Box(*(2 * np.array(of["half_extents"]))), middle
    if kind == "capsule":
        return fcl.Capsule(of["radius"], 2 * of["half_length"]), middle
    if kind == "cylinder":
        return fcl.Cylinder(of["radius"], 2 * of["half_height"]), middle
    if kind == "cone":
        return fcl.Cone(of["radius"], 2 * of["half_height"]), middle
    if kind == "ellipsoid":
        return fcl.Ellipsoid(*of["semi_axes"]), np.array(of["centre"])
    return None


def load_shapes(shapes):
    known = [geometry_of(shape) for shape in shapes]

    def body(shape, pose):
        if known[shape] is None:
            raise Unsupported("no such shape")
        geometry, centre = known[shape]
        return placed(geometry, pose, centre)

    return lambda question, shape_a, pose_a, shape_b, pose_b, settings: ask(
        question, body(shape_a, pose_a), body(shape_b, pose_b)
    )


serve("python-fcl", getattr(fcl, "__version__", ""), ["any", "distance"], load, load_shapes)
