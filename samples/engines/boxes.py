#!/usr/bin/env python3
"""An engine that looks at the boxes around two meshes alone: wrong wherever these meet and the meshes do not."""

import sys

from graze_peer import serve


def box_of(mesh, pose):
    points = [
        [sum(pose[4 * row + k] * p[k] for k in range(3)) + pose[4 * row + 3] for row in range(3)]
        for p in mesh["vertices"]
    ]
    return [(min(values), max(values)) for values in zip(*points)]


def load(mesh_a, mesh_b):
    def answer(question, pose_a, pose_b, settings):
        pairs = zip(box_of(mesh_a, pose_a), box_of(mesh_b, pose_b))
        return {"says": all(a[0] <= b[1] and b[0] <= a[1] for a, b in pairs)}

    return answer


# A name may be given: so two versions of an engine, each with a program of its own, stand beside each other.
serve(sys.argv[1] if len(sys.argv) > 1 else "boxes", "1", ["any"], load)
