"""What is returned of contacts, intersections and motions."""

from typing import NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from graze._arrays_of_results import Bools, Doubles, Indices, Offsets, result


@result
class MeshContacts(NamedTuple):
    """Contacts of two meshes, the deepest first."""

    point: Doubles
    """(k, 3), midway between the next two."""
    point_a: Doubles
    """(k, 3), the point of A that is deepest in B, along the normal."""
    point_b: Doubles
    """(k, 3), the point of B that is deepest in A."""
    normal: Doubles
    """(k, 3), unit, from A to B."""
    depth: Doubles
    """(k,), not negative."""
    corners: Doubles
    """(c, 3), of the intersections that contacts stand for."""
    offsets: Offsets
    """(k + 1,): those of contact i are corners[offsets[i]:offsets[i + 1]]."""
    is_complete: bool
    """Whether these are all contacts."""


@result
class ShapeContacts(NamedTuple):
    """Contacts of two shapes, region by region: of each at most four, its deepest first."""

    point: Doubles
    """(k, 3), midway between the next two."""
    point_a: Doubles
    """(k, 3), on A's surface."""
    point_b: Doubles
    """(k, 3), on B's."""
    normal: Doubles
    """(k, 3), unit, from A to B."""
    depth: Doubles
    """(k,), how far the two reach past each other; negative only where there is a margin."""
    feature: NDArray[np.uint64]
    """(k, 2), which parts of A and of B meet: the same from step to step."""
    region: Indices
    """(k,); contacts of one region share a way out."""
    material: NDArray[np.uint16]
    """(k, 2), of the triangle or cell of A and of B that is nearest there; 0 of what has none."""


@result
class MeshContactLists(NamedTuple):
    """Contacts of two meshes in each of n poses."""

    contacts: MeshContacts
    """Those of all poses, one pose after the other; `is_complete` if all are."""
    offsets: Offsets
    """(n + 1,): those of pose i are contacts[offsets[i]:offsets[i + 1]] of each array."""
    is_complete: Bools
    """(n,), whether these are all contacts of the pose."""


@result
class ShapeContactLists(NamedTuple):
    """Contacts of two shapes in each of n poses."""

    contacts: ShapeContacts
    """Those of all poses, one pose after the other."""
    offsets: Offsets
    """(n + 1,): those of pose i are contacts[offsets[i]:offsets[i + 1]] of each array."""


@result
class MeshIntersection(NamedTuple):
    """Where the surfaces of two placed meshes meet."""

    points: Doubles
    """(p, 3), ascending."""
    feature_a: NDArray[np.uint8]
    """(p,), in what of A each lies: 0 a vertex, 1 an edge, 2 a face."""
    feature_b: NDArray[np.uint8]
    """(p,), of B."""
    segments: Indices
    """(s, 2), indices of points."""
    segment_pairs: Indices
    """(s, 2), the first of `pairs` that meets in each and how many there are."""
    curves: Indices
    """(c, 2), the first segment and how many there are, end to end."""
    is_closed: Bools
    """(c,), whether a curve ends where it began."""
    polygons: NDArray[np.int64]
    """(q, 6), indices of the three to six points of a common piece of plane; -1 beyond them."""
    polygon_pairs: Indices
    """(q, 2), likewise."""
    patches: Indices
    """(r, 2), the first polygon and how many are connected."""
    touching_points: Indices
    """(t,), indices of points that are on nothing else."""
    touching_pairs: Indices
    """(t, 2), likewise."""
    pairs: Indices
    """(k, 2), the triangles that meet in segments, polygons and points."""


@result
class SeparatingTranslation(NamedTuple):
    """A translation of B after which two meshes are apart."""

    distance: float
    """Along the direction."""
    direction: Doubles
    """A unit vector, (3,)."""
    translation: Doubles
    """distance * direction, (3,)."""
    pose_b: Doubles
    """Of B, moved by it, (4, 4)."""


@result
class SeparatingTranslations(NamedTuple):
    """The same for each of n poses."""

    distance: Doubles
    """(n,)"""
    direction: Doubles
    """(n, 3)"""
    translation: Doubles
    """(n, 3)"""
    pose_b: Doubles
    """(n, 4, 4)"""


@result
class MeshCast(NamedTuple):
    """Where a mesh that goes straight meets another one first."""

    time: float
    """From 0 to 1, never late."""
    is_at_start: bool
    """Whether it is at t = 0 itself."""
    pair: Tuple[int, int]
    """Triangles that meet then."""
    point: Doubles
    """Where, on A, (3,)."""
    normal: Doubles
    """Unit, from A to B, (3,)."""


@result
class ShapeCast(NamedTuple):
    """Where a shape that goes straight meets another one first."""

    time: float
    """From 0 to 1, never late."""
    is_at_start: bool
    """Whether it is at t = 0 itself."""
    point: Doubles
    """Where, on A, (3,)."""
    normal: Doubles
    """Unit, from A to B, (3,)."""


@result
class Casts(NamedTuple):
    """The same of meshes or shapes for each of n poses or ways."""

    is_hit: Bools
    """(n,)"""
    time: Doubles
    """(n,); NaN where nothing is met."""
    is_at_start: Bools
    """(n,)"""
    pair: Optional[NDArray[np.int64]]
    """(n, 2), triangles that meet; -1 where none do, and None of shapes."""
    point: Doubles
    """(n, 3); NaN where nothing is met."""
    normal: Doubles
    """(n, 3); NaN there."""


@result
class RigidContact(NamedTuple):
    """When two rigid motions meet first."""

    status: str
    """free, hit or close."""
    low: float
    """There is no contact before it; 1 for what is free."""
    high: float
    """A witness: here they meet. 1 where there is none."""
    is_out_of_budget: bool
    """The search ended at `low`, whatever lies there."""


@result
class RigidContacts(NamedTuple):
    """The same for each of n motions."""

    status: NDArray[np.str_]
    """(n,)"""
    low: Doubles
    """(n,)"""
    high: Doubles
    """(n,)"""
    is_out_of_budget: Bools
    """(n,)"""
