"""An engine of your own beside graze, in Python: copy this page and call serve().

`graze compare A B --engine-command "python3 yours.py"` asks it, judges it, and names what it gets wrong. The protocol
is a JSON object a line (engine/compare/peers/process/README.md).
"""

import json
import os
import sys
import time


class Unsupported(Exception):
    """Raised by an engine that knows no such question, or refuses such meshes: no error of it."""


def serve(name, version, questions, load):
    """Answers until there are no more requests.

    load(mesh_a, mesh_b) gets two dictionaries with "vertices", lists of three metres each, and "triangles", of three
    indices each. It returns a function of (question, pose_a, pose_b, settings), which returns the answer as the
    protocol has it: {"says": True}, or {"distance": 0.25}. A pose is the rows of [R | t], 12 numbers. What it prints
    goes to the standard error; what it raises, but for Unsupported, is an error of the engine.
    """
    replies = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())

    def write(line):
        replies.write(json.dumps(line, allow_nan=False) + "\n")
        replies.flush()

    write({"graze_peer": 1, "engine": name, "version": version, "questions": questions})
    answer = None
    for line in sys.stdin:
        request = json.loads(line)
        try:
            reply = {}
            if "load" in request:
                meshes = request["load"]
                if "a" not in meshes:
                    raise Unsupported("shapes other than meshes")
                mesh_a, mesh_b = meshes["a"], meshes["b"]
                answer = load(mesh_a, mesh_a if "same_as" in mesh_b else mesh_b)
                reply["loaded"] = True
            else:
                start = time.perf_counter()
                reply["answer"] = answer(
                    request["question"], request["pose_a"], request["pose_b"], request.get("settings", {})
                )
                reply["us"] = (time.perf_counter() - start) * 1e6
            json.dumps(reply, allow_nan=False)  # what is no number is an error of the engine, too
        except Unsupported as why:
            reply = {"unsupported": str(why)}
        except Exception as error:  # noqa: BLE001: all of them are told
            reply = {"error": f"{type(error).__name__}: {error}"}
        write({"id": request["id"], **reply})
