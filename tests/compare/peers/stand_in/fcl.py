"""Stands in for the package python-fcl, of which it has the names that samples/engines/python_fcl.py calls.

What is called with arguments that the package would not take is refused. The answers are FCL's own: a program that speaks
the protocol of engines is asked, which the environment names as FCL_ENGINE.
"""

import json
import os
import subprocess

import numpy

__version__ = "stand-in"


class CollisionRequest:
    def __init__(self, num_max_contacts=1, enable_contact=False):
        self.num_max_contacts = num_max_contacts
        self.enable_contact = enable_contact


class CollisionResult:
    def __init__(self):
        self.is_collision = False
        self.contacts = []


class DistanceRequest:
    def __init__(self, enable_nearest_points=False, enable_signed_distance=False):
        self.enable_nearest_points = enable_nearest_points
        self.enable_signed_distance = enable_signed_distance


class DistanceResult:
    def __init__(self):
        self.min_distance = float("inf")


class Transform:
    def __init__(self, rotation, translation):
        rotation, translation = numpy.array(rotation), numpy.array(translation).squeeze()
        if rotation.shape != (3, 3) or translation.shape != (3,):
            raise ValueError("Transform(): a matrix and a vector")
        self.rows = numpy.hstack([rotation, translation[:, None]]).astype(float).ravel().tolist()


class CollisionGeometry:
    pass


def _shape_class(kind, *names, halved=()):
    """Whose constructor takes these numbers; those of `halved` are whole lengths, and half as long in the protocol."""

    class Shape(CollisionGeometry):
        def __init__(self, *numbers):
            if len(numbers) != len(names):
                raise TypeError(f"{kind}: {len(names)} numbers, not {len(numbers)}")
            given = dict(zip(names, (float(each) for each in numbers)))
            self.numbers = {halved[name] if name in halved else name: value / 2 if name in halved else value
                            for name, value in given.items()}

        def shape(self):
            return {kind: self.numbers}

    return Shape


Capsule = _shape_class("capsule", "radius", "lz", halved={"lz": "half_length"})
Cylinder = _shape_class("cylinder", "radius", "lz", halved={"lz": "half_height"})
Cone = _shape_class("cone", "radius", "lz", halved={"lz": "half_height"})
_Ball = _shape_class("sphere", "radius")
_Block = _shape_class("box", "x", "y", "z", halved={"x": "x", "y": "y", "z": "z"})
_Axes = _shape_class("ellipsoid", "a", "b", "c")


class Sphere(_Ball):
    def shape(self):
        return {"sphere": {"centre": [0, 0, 0], **self.numbers}}


class Box(_Block):
    def shape(self):
        return {"box": {"half_extents": list(self.numbers.values())}}


class Ellipsoid(_Axes):
    def shape(self):
        return {"ellipsoid": {"centre": [0, 0, 0], "semi_axes": list(self.numbers.values())}}


class BVHModel(CollisionGeometry):
    def __init__(self):
        self.state = "empty"

    def beginModel(self, num_tris_=0, num_vertices_=0):
        self.counts = int(num_tris_), int(num_vertices_)
        self.state = "begun"
        return 0

    def addSubModel(self, verts, triangles):
        if self.state != "begun":
            raise ValueError("BVH construction does not follow correct sequence")
        self.mesh = {
            "vertices": [vertex.astype(numpy.float64).tolist() for vertex in verts],
            "triangles": [[int(t[0]), int(t[1]), int(t[2])] for t in triangles],
        }
        if self.counts != (len(triangles), len(verts)):
            raise ValueError("beginModel() was told other numbers")
        return True

    def endModel(self):
        if self.state != "begun" or not hasattr(self, "mesh"):
            raise ValueError("BVH geometry is not prepared")
        self.state = "ended"
        return 0


class CollisionObject:
    def __init__(self, geom, tf):
        if not isinstance(geom, CollisionGeometry) or not isinstance(tf, Transform):
            raise TypeError("CollisionObject(geometry, transform)")
        if isinstance(geom, BVHModel) and geom.state != "ended":
            raise ValueError("a model that is not ended")
        self.geometry = geom
        self.pose = tf.rows


def collide(o1, o2, request=None, result=None):
    says = _ask("any", o1, o2)["says"]
    if result is not None:
        result.is_collision = result.is_collision or says
    return int(says)


def distance(o1, o2, request=None, result=None):
    found = _ask("distance", o1, o2)["distance"]
    if result is not None:
        result.min_distance = min(result.min_distance, found)
    return found


class _Engine:
    def __init__(self):
        self.program = subprocess.Popen(
            [os.environ["FCL_ENGINE"]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self.read()  # who it is
        self.loaded = None
        self.asked = 0

    def read(self):
        return json.loads(self.program.stdout.readline())

    def request(self, body):
        self.asked += 1
        self.program.stdin.write(json.dumps({"id": self.asked, **body}) + "\n")
        self.program.stdin.flush()
        return self.read()

    def load(self, a, b):
        if self.loaded == (a, b):
            return
        if isinstance(a, BVHModel) and isinstance(b, BVHModel):
            what = {"a": a.mesh, "b": b.mesh}
        else:
            what = {"shapes": [a.shape(), b.shape()]}
        self.request({"load": what})
        self.loaded = (a, b)


_engine = None


def _ask(question, o1, o2):
    global _engine
    if not isinstance(o1, CollisionObject) or not isinstance(o2, CollisionObject):
        raise TypeError("two objects")
    _engine = _engine or _Engine()
    _engine.load(o1.geometry, o2.geometry)
    if isinstance(o1.geometry, BVHModel):
        reply = _engine.request({"question": question, "pose_a": o1.pose, "pose_b": o2.pose})
        return reply["answer"]
    bodies = [{"shape": i, "pose": each.pose} for i, each in enumerate((o1, o2))]
    if question == "any":
        return {"says": _engine.request({"question": "any", "bodies": bodies, "pairs": [[0, 1]]})["answers"][0]}
    return _engine.request({"question": question, "bodies": bodies})["answer"]
