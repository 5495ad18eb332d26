"""What is returned of meshes that deform, and proofs that nothing touches."""

from typing import NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from graze._arrays_of_results import Bools, Doubles, Indices, result


@result
class MeshFirstContact(NamedTuple):
    """When two meshes that deform meet first, and where."""

    time: float
    """From 0 to 1, never late."""
    is_at_start: bool
    """Whether it is at t = 0 itself."""
    pair: Tuple[int, int]
    """Triangles that have what meets."""
    features: str
    """vertex-face, face-vertex, edge-edge, or at-start for triangles that meet as they are at t = 0."""
    places: Tuple[int, int]
    """The corners of both triangles, 0 to 2; of an edge the one that it leaves, of a face 0."""


@result
class MeshFirstContacts(NamedTuple):
    """The same for each of k contacts."""

    time: Doubles
    """(k,)"""
    is_at_start: Bools
    """(k,)"""
    pair: Indices
    """(k, 2)"""
    features: NDArray[np.str_]
    """(k,)"""
    places: Indices
    """(k, 2)"""


@result
class FreedomCertificate(NamedTuple):
    """A proof that two meshes in rigid motion stay further apart than a clearance: steps that prove something of parts of
    both meshes and of the time, or divide them in two."""

    clearance: float
    """Metres."""
    order_a: Indices
    """A's triangles, each once: parts are stretches of this."""
    order_b: Indices
    """Likewise."""
    kind: NDArray[np.uint8]
    """(s,): 0 planes across the normal keep the parts apart, 1 halves the time, 2 divides A, 3 divides B."""
    size: Indices
    """(s,), how many triangles the first part has; 0 where none is divided."""
    normal: Doubles
    """(s, 3), from A to B; 0 where there is none."""
