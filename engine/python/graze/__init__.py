"""Exact and fast collision detection: meshes, shapes and worlds of them, asked in arrays."""

from graze._errors import (
    CaseError,
    Error,
    ErrorPlace,
    InputError,
    MeshError,
    PoseError,
    StaleIdError,
    UnsupportedPairError,
)
from graze._graze import (
    Mesh,
    PairMemory,
    Work,
    __version__,
    find_triangle_pairs,
    interiors_intersect,
    intersects,
    load_mesh,
    load_poses,
    prepare,
)
from graze._results import Topology, TrianglePairLists, TrianglePairs
