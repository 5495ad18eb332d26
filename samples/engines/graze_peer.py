"""An engine of your own beside graze, in Python: copy this page and call serve().

`graze compare A B --engine-command "python3 yours.py"` asks it, judges it, and names what it gets wrong. The protocol
is a JSON object a line (engine/compare/peers/process/README.md).
"""

import json
import os
import sys
import time


class Unsupported(Exception):
    """Raised by an engine that knows no such question, or refuses such meshes or shapes: no error of it."""


def serve(name, version, questions, load, load_shapes=None):
    """Answers until there are no more requests.

    load(mesh_a, mesh_b) gets two dictionaries with "vertices", lists of three metres each, and "triangles", of three
    indices each. It returns a function of (question, pose_a, pose_b, settings), which returns the answer as the
    protocol has it: {"says": True}, or {"distance": 0.25}. A pose is the rows of [R | t], 12 numbers. What it prints
    goes to the standard error; what it raises, but for Unsupported, is an error of the engine.

    load_shapes(shapes) gets a list of shapes as the protocol has them, {"sphere": {"centre": [0, 0, 0], "radius": 1}};
    None: the engine knows none. It returns a function of (question, shape_a, pose_a, shape_b, pose_b, settings), where
    shapes are indices into the list; contacts are {"manifold": [{"point": p, "normal": n, "depth": 0.01}]}. What it
    raises Unsupported for it does not know.
    """
    replies = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())

    def write(line):
        replies.write(json.dumps(line, allow_nan=False) + "\n")
        replies.flush()

    write({"graze_peer": 1, "engine": name, "version": version, "questions": questions})
    meshes = shapes = None  # what is loaded
    for line in sys.stdin:
        request = json.loads(line)
        try:
            if "load" in request:
                meshes = shapes = None
                if "shapes" in request["load"]:
                    shapes = _loaded_shapes(load_shapes, request["load"]["shapes"])
                else:
                    a, b = request["load"]["a"], request["load"]["b"]
                    meshes = load(a, a if "same_as" in b else b)
                reply = {"loaded": True}
            else:
                start = time.perf_counter()
                reply = _about_bodies(shapes, request) if "bodies" in request else _about_meshes(meshes, request)
                reply["us"] = (time.perf_counter() - start) * 1e6
            json.dumps(reply, allow_nan=False)  # what is no number is an error of the engine, too
        except Unsupported as why:
            reply = {"unsupported": str(why)}
        except Exception as error:  # noqa: BLE001: all of them are told
            reply = {"error": f"{type(error).__name__}: {error}"}
        write({"id": request["id"], **reply})


def _loaded_shapes(load_shapes, shapes):
    if load_shapes is None:
        raise Unsupported("shapes other than meshes")
    return load_shapes(shapes)


def _about_meshes(answer, request):
    settings = request.get("settings", {})
    return {"answer": answer(request["question"], request["pose_a"], request["pose_b"], settings)}


def _about_bodies(answer, request):
    """Of two bodies one answer, of pairs of bodies whether each meets, or None for shapes that are not known."""

    def ask(a, b):
        if "motion" in a or "motion" in b:
            raise Unsupported("bodies in motion")
        settings = request.get("settings", {})
        return answer(request["question"], a["shape"], a["pose"], b["shape"], b["pose"], settings)

    def says(a, b):
        try:
            return ask(a, b)["says"]
        except Unsupported:
            return None

    bodies = request["bodies"]
    if "pairs" not in request:
        return {"answer": ask(*bodies)}
    return {"answers": [says(bodies[a], bodies[b]) for a, b in request["pairs"]]}
