#!/usr/bin/env python3
"""An engine that looks at the boxes around two bodies alone: wrong wherever these meet and the bodies do not."""

import sys

from graze_peer import Unsupported, serve


def placed(pose, p):
    return [sum(pose[4 * row + k] * p[k] for k in range(3)) + pose[4 * row + 3] for row in range(3)]


def box_around(points):
    return [(min(values), max(values)) for values in zip(*points)]


def meet(box_a, box_b):
    return all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(box_a, box_b))


def load(mesh_a, mesh_b):
    def box_of(mesh, pose):
        return box_around([placed(pose, p) for p in mesh["vertices"]])

    def answer(question, pose_a, pose_b, settings):
        return {"says": meet(box_of(mesh_a, pose_a), box_of(mesh_b, pose_b))}

    return answer


def load_shapes(shapes):
    def box_of(shape, pose):
        ((kind, of),) = shape.items()
        if kind == "sphere":
            return [(x - of["radius"], x + of["radius"]) for x in placed(pose, of["centre"])]
        if kind == "box":
            h = of["half_extents"]
            corners = [(x, y, z) for x in (-h[0], h[0]) for y in (-h[1], h[1]) for z in (-h[2], h[2])]
            return box_around([placed(pose, p) for p in corners])
        raise Unsupported(f"no {kind}")

    def answer(question, shape_a, pose_a, shape_b, pose_b, settings):
        return {"says": meet(box_of(shapes[shape_a], pose_a), box_of(shapes[shape_b], pose_b))}

    return answer


# A name may be given: so two versions of an engine, each with a program of its own, stand beside each other.
serve(sys.argv[1] if len(sys.argv) > 1 else "boxes", "1", ["any"], load, load_shapes)
