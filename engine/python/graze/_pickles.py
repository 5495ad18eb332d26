"""How meshes go to other processes: by their content, so that one that comes again and again is built once."""

import copyreg
import hashlib
import threading
import types
import weakref
from collections import OrderedDict
from typing import Any, Tuple

import numpy as np

from graze import _graze
from graze._graze import Mesh

# Workers let go of a mesh at the end of each task, and would build its trees anew in the next.
_KEPT_AT_MOST = 8

_lock = threading.Lock()
_digests: "weakref.WeakKeyDictionary[Mesh, bytes]" = weakref.WeakKeyDictionary()
_known: "weakref.WeakValueDictionary[bytes, Mesh]" = weakref.WeakValueDictionary()
_kept: "OrderedDict[bytes, Mesh]" = OrderedDict()


def reduce_mesh(mesh: Mesh) -> Tuple[Any, Tuple[bytes, Any, Any, Any]]:
    """What pickle asks for. Arrays go out of band where a protocol allows it."""
    with _lock:
        digest = _digests.get(mesh)
    if digest is None:
        digest = _digest_of(mesh.vertices, mesh.triangles, mesh.materials)
        with _lock:
            _digests[mesh] = digest
            _known.setdefault(digest, mesh)
    return restore_mesh, (digest, np.asarray(mesh.vertices), np.asarray(mesh.triangles), mesh.materials)


def restore_mesh(digest: bytes, vertices: Any, triangles: Any, materials: Any = None) -> Mesh:
    """The mesh of that content which this process has, or a new one."""
    with _lock:
        mesh = _known.get(digest)
        if mesh is None:
            mesh = Mesh(vertices, triangles, materials)
            _known[digest] = mesh
            _digests[mesh] = digest
        _kept[digest] = mesh
        _kept.move_to_end(digest)
        while len(_kept) > _KEPT_AT_MOST:
            _kept.popitem(last=False)
    return mesh


def _digest_of(vertices: Any, triangles: Any, materials: Any) -> bytes:
    digest = hashlib.sha256(b"%d,%d;" % (len(vertices), len(triangles)))
    digest.update(np.ascontiguousarray(vertices).data)
    digest.update(np.ascontiguousarray(triangles).data)
    if materials is not None:
        digest.update(np.ascontiguousarray(materials).data)
    return digest.digest()


def _reduce_function(function: Any) -> Any:
    """Functions of the module go by their names, all others as ever: pickle would ask for what pybind11 has bound them
    to."""
    name = function.__name__
    return name if getattr(_graze, name, None) is function else function.__reduce__()


copyreg.pickle(types.BuiltinFunctionType, _reduce_function)
