"""What queries return: tuples with names. Arrays are of float64 where nothing else is said; lengths are metres."""

from typing import Any, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
Indices = NDArray[np.uint32]
Bools = NDArray[np.bool_]
Offsets = NDArray[np.int64]


def _are_same(a: Any, b: Any) -> bool:
    """Tuples of arrays have no `==`; results compare by all that they hold, to the bit."""
    if type(a) is not type(b):
        return False
    return all(
        np.array_equal(x, y) if isinstance(x, np.ndarray) or isinstance(y, np.ndarray) else bool(x == y)
        for x, y in zip(a, b)
    )


class Topology(NamedTuple):
    """What the triangles of a mesh form once equal positions are one vertex."""

    welded_vertices: int
    """Distinct positions that triangles use."""
    components: int
    """Sets of triangles connected through welded vertices."""
    degenerate_triangles: int
    """Triangles of exactly zero area."""
    duplicate_triangles: int
    """Triangles with the same welded vertices as an earlier one."""
    boundary_edges: int
    """Welded edges with an odd number of triangles."""
    is_closed: bool
    """Every welded edge has an even number of triangles."""


class TrianglePairs(NamedTuple):
    """Pairs of triangles of two meshes, ascending."""

    pairs: Indices
    """Of the shape (k, 2): a triangle of A and one of B."""
    is_complete: bool
    """Whether that is all there is; else a limit was reached."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class TrianglePairLists(NamedTuple):
    """Pairs of triangles for each of many poses."""

    pairs: Indices
    """Of the shape (k, 2): those of all poses, one pose after the other."""
    offsets: Offsets
    """Of the shape (n + 1,): those of pose i are pairs[offsets[i]:offsets[i + 1]]."""
    is_complete: Bools
    """Of the shape (n,): whether that is all there is for the pose."""

    def of(self, pose: int) -> Indices:
        """The pairs of one pose."""
        count = len(self.offsets) - 1
        if not -count <= pose < count:
            raise IndexError(f"pose {pose} of {count}")
        pose %= count
        return self.pairs[self.offsets[pose] : self.offsets[pose + 1]]

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)
