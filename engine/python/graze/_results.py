"""What queries return: tuples with names. Arrays are of float64 where nothing else is said; lengths are metres."""

from typing import Any, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from graze._graze import Work

Doubles = NDArray[np.float64]
Indices = NDArray[np.uint32]
Bools = NDArray[np.bool_]
Offsets = NDArray[np.int64]
Ids = NDArray[np.uint64]


def _are_same(a: Any, b: Any) -> bool:
    """Tuples of arrays have no `==`; results compare by all that they hold, to the bit."""
    if type(a) is not type(b):
        return False
    return all(
        np.array_equal(x, y, equal_nan=np.asarray(x).dtype.kind == "f") if isinstance(x, np.ndarray) else bool(x == y)
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


class TriangleList(NamedTuple):
    """Triangles of a mesh, ascending."""

    triangles: Indices
    """Of the shape (k,)."""
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


class MeshDistance(NamedTuple):
    """How far apart two placed meshes are, and where."""

    distance: float
    """0 if and only if the surfaces meet."""
    point_a: Doubles
    """The point of A that is nearest to B, (3,)."""
    point_b: Doubles
    """And that of B nearest to A."""
    pair: Tuple[int, int]
    """The triangles that these lie in."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class MeshDistances(NamedTuple):
    """The same for each of n poses."""

    distance: Doubles
    """(n,)"""
    point_a: Doubles
    """(n, 3)"""
    point_b: Doubles
    """(n, 3)"""
    pair: Indices
    """(n, 2)"""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class ShapeDistance(NamedTuple):
    """How far apart two placed shapes are, and where."""

    distance: float
    """0 if and only if intersects() says so."""
    lower_bound: float
    """Proved: the true distance is not less."""
    point_a: Doubles
    """The point of A nearest to B, (3,)."""
    point_b: Doubles
    """And of B nearest to A."""
    normal: Doubles
    """Unit, from A to B, (3,)."""
    is_converged: bool
    """Whether the distance is known to its tolerance."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class ShapeDistances(NamedTuple):
    """The same for each of n poses."""

    distance: Doubles
    """(n,)"""
    lower_bound: Doubles
    """(n,)"""
    point_a: Doubles
    """(n, 3)"""
    point_b: Doubles
    """(n, 3)"""
    normal: Doubles
    """(n, 3)"""
    is_converged: Bools
    """(n,)"""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class ShapeSeparation(NamedTuple):
    """By how much two placed convex shapes are apart, or reach past each other."""

    distance: float
    """Below 0: minus the depth along the normal."""
    point_a: Doubles
    """Of A: the nearest to B, or the deepest in it."""
    point_b: Doubles
    """Of B, likewise."""
    normal: Doubles
    """Unit, from A to B."""
    is_converged: bool
    """Whether the distance, or that the depth is the least, is proved."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class NearestPoint(NamedTuple):
    """The point of a placed mesh that is nearest to another."""

    distance: float
    """0 if and only if the point lies on the surface."""
    point: Doubles
    """Of the surface, (3,)."""
    triangle: int
    """In which it lies."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class NearestPoints(NamedTuple):
    """The same for each of n points."""

    distance: Doubles
    """(n,)"""
    point: Doubles
    """(n, 3)"""
    triangle: Indices
    """(n,)"""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class RayHit(NamedTuple):
    """Where a ray meets something first."""

    distance: float
    """Metres along the ray."""
    point: Doubles
    """(3,)"""
    normal: Doubles
    """Unit, against the ray, (3,)."""
    triangle: Optional[int]
    """Of a mesh; None for other shapes."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class RayHits(NamedTuple):
    """The same for each of n rays."""

    is_hit: Bools
    """(n,)"""
    distance: Doubles
    """(n,); inf where nothing is hit."""
    point: Doubles
    """(n, 3); NaN there."""
    normal: Doubles
    """(n, 3); NaN there."""
    triangle: NDArray[np.int64]
    """(n,); -1 there, and where a shape that is no mesh is hit."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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
    curves: Indices
    """(c, 2), the first segment and how many there are, end to end."""
    is_closed: Bools
    """(c,), whether a curve ends where it began."""
    polygons: NDArray[np.int64]
    """(q, 6), indices of the three to six points of a common piece of plane; -1 beyond them."""
    patches: Indices
    """(r, 2), the first polygon and how many are connected."""
    touching_points: Indices
    """(t,), indices of points that are on nothing else."""
    pairs: Indices
    """(k, 2), the triangles that meet in segments, polygons and points."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class Separation(NamedTuple):
    """A translation of B after which two meshes are apart."""

    distance: float
    """Along the direction."""
    direction: Doubles
    """A unit vector, (3,)."""
    translation: Doubles
    """distance * direction, (3,)."""
    pose_b: Doubles
    """Of B, moved by it, (4, 4)."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


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

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class MeshHealth(NamedTuple):
    """What is wrong with a mesh: every array is empty in a healthy one. Edges are rows of two vertices, the lowest triangle and how many triangles there are."""

    open_edges: Indices
    """(k, 4), where the surface ends."""
    non_manifold_edges: Indices
    """(k, 4), with more than two triangles."""
    turned_edges: Indices
    """(k, 4), where triangles are wound inconsistently."""
    degenerate_triangles: Indices
    """(k,), without area."""
    duplicate_triangles: Indices
    """(k, 2), a triangle and the lowest one with the same vertices."""
    inside_out_parts: Indices
    """(k, 3), the lowest triangle, how many there are, and inside how many other parts."""
    self_intersections: Indices
    """(k, 2), triangles that cross."""

    @property
    def is_healthy(self) -> bool:
        """Closed, manifold at its edges, consistently wound with its front outside, and crossing itself nowhere."""
        return not any(len(faults) for faults in self)

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class Voxels(NamedTuple):
    """Voxels of a grid, ascending."""

    origin: Doubles
    """The grid's least corner, (3,)."""
    edge: float
    """Of a voxel."""
    counts: Tuple[int, int, int]
    """Voxels along x, y and z."""
    indices: NDArray[np.uint16]
    """(k, 3): voxel (i, j, k) is the box from origin + edge (i, j, k) on."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class WorldContacts(NamedTuple):
    """Contacts of pairs of bodies."""

    pairs: Ids
    """(k, 2); a pair with a compound may stand more than once."""
    parts: Indices
    """(k, 2), which part of each is met, if it is a compound; else 0."""
    offsets: Offsets
    """(k + 1,): those of pair i are contacts[offsets[i]:offsets[i + 1]] of each array."""
    contacts: ShapeContacts
    """Normals from the first body of a pair to the second."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class BodyFirstContacts(NamedTuple):
    """Bodies that are swept and not proved to stay apart, from the last update, time 0, to this one, time 1."""

    pairs: Ids
    """(k, 2)"""
    is_hit: Bools
    """(k,); else they come near, and no contact is proved."""
    low: Doubles
    """(k,), no contact before it."""
    high: Doubles
    """(k,), a witness."""
    touches_at_start: Bools
    """(k,)"""
    point: Doubles
    """(k, 3), at `low`, between the two."""
    normal: Doubles
    """(k, 3), from the first to the second."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class WorldUpdate(NamedTuple):
    """What changed between two updates. Pairs are ids, ascending, of the shape (k, 2)."""

    begun: Ids
    """Touch now and did not."""
    ended: Ids
    """Touched and do not now."""
    moved: Ids
    """Touch now, and one of them changed."""
    contacts: WorldContacts
    """Of the solid pairs in `moved`."""
    begun_near: Ids
    """Are within their margin and were not."""
    ended_near: Ids
    """Were within their margin and are not."""
    first_contacts: BodyFirstContacts
    """Of bodies that are swept."""
    work: Work
    """What was done."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class BodyDistance(NamedTuple):
    """A body and how far it is from a shape, A."""

    id: int
    """Of the body, B."""
    distance: float
    point_a: Doubles
    """(3,)"""
    point_b: Doubles
    """(3,)"""
    normal: Doubles
    """(3,), from A to B."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class BodyDistances(NamedTuple):
    """The same for each of k bodies."""

    ids: Ids
    """(k,), ascending."""
    distance: Doubles
    """(k,)"""
    point_a: Doubles
    """(k, 3)"""
    point_b: Doubles
    """(k, 3)"""
    normal: Doubles
    """(k, 3)"""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class BodyRayHits(NamedTuple):
    """The body that each of n rays meets first."""

    is_hit: Bools
    """(n,)"""
    ids: Ids
    """(n,); of no body where nothing is hit."""
    distance: Doubles
    """(n,); inf there."""
    point: Doubles
    """(n, 3); NaN there."""
    normal: Doubles
    """(n, 3); NaN there."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


class BodyCast(NamedTuple):
    """A body that a shape in motion comes to, and when."""

    id: int
    """Of the body."""
    contact: RigidContact
    """Hit or close."""

    def __eq__(self, other: object) -> bool:
        return _are_same(self, other)

    def __ne__(self, other: object) -> bool:
        return not _are_same(self, other)


for _type in list(globals().values()):
    if isinstance(_type, type) and _type.__module__ == __name__:
        _type.__module__ = "graze"
del _type
