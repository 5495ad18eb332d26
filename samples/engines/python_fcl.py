#!/usr/bin/env python3
"""python-fcl behind the pipe: needs the packages python-fcl and numpy."""

import fcl
import numpy as np

from graze_peer import serve


def model_of(mesh):
    model = fcl.BVHModel()
    model.beginModel(len(mesh["vertices"]), len(mesh["triangles"]))
    model.addSubModel(np.array(mesh["vertices"]), np.array(mesh["triangles"]))
    model.endModel()
    return model


def placed(model, pose):
    rows = np.array(pose).reshape(3, 4)
    return fcl.CollisionObject(model, fcl.Transform(rows[:, :3], rows[:, 3]))


def load(mesh_a, mesh_b):
    model_a, model_b = model_of(mesh_a), model_of(mesh_b)

    def answer(question, pose_a, pose_b, settings):
        a, b = placed(model_a, pose_a), placed(model_b, pose_b)
        if question == "any":
            return {"says": fcl.collide(a, b, fcl.CollisionRequest(), fcl.CollisionResult()) > 0}
        return {"distance": fcl.distance(a, b, fcl.DistanceRequest(), fcl.DistanceResult())}

    return answer


serve("python-fcl", getattr(fcl, "__version__", ""), ["any", "distance"], load)
