"""What queries return: tuples with names. Arrays are of float64 where nothing else is said; lengths are metres."""

from typing import NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from graze._arrays_of_results import Bools, Doubles, Indices, Offsets, result
from graze._contact_results import MeshContacts as MeshContacts
from graze._contact_results import ShapeContacts as ShapeContacts
from graze._contact_results import MeshContactLists as MeshContactLists
from graze._contact_results import ShapeContactLists as ShapeContactLists
from graze._contact_results import SeparatingTranslations as SeparatingTranslations
from graze._contact_results import Casts as Casts
from graze._contact_results import MeshIntersection as MeshIntersection
from graze._contact_results import SeparatingTranslation as SeparatingTranslation
from graze._contact_results import MeshCast as MeshCast
from graze._contact_results import ShapeCast as ShapeCast
from graze._contact_results import RigidContact as RigidContact
from graze._contact_results import RigidContacts as RigidContacts
from graze._world_results import WorldContacts as WorldContacts
from graze._world_results import BodyFirstContacts as BodyFirstContacts
from graze._world_results import WorldUpdate as WorldUpdate
from graze._world_results import BodyDistance as BodyDistance
from graze._world_results import BodyDistanceLists as BodyDistanceLists
from graze._world_results import BodyDistances as BodyDistances
from graze._world_results import BodyLists as BodyLists
from graze._world_results import BodyRayHitLists as BodyRayHitLists
from graze._world_results import BodyRayHits as BodyRayHits
from graze._world_results import BodyCast as BodyCast
from graze._world_results import BodyCastLists as BodyCastLists
from graze._world_results import BodyCasts as BodyCasts
from graze._world_results import BodyPairDistance as BodyPairDistance
from graze._world_results import BodyPairDistances as BodyPairDistances
from graze._world_results import WorldDrawing as WorldDrawing
from graze._motion_results import MeshFirstContact as MeshFirstContact
from graze._motion_results import MeshFirstContacts as MeshFirstContacts
from graze._motion_results import FreedomCertificate as FreedomCertificate


@result
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


@result
class TrianglePairs(NamedTuple):
    """Pairs of triangles of two meshes, ascending."""

    pairs: Indices
    """Of the shape (k, 2): a triangle of A and one of B."""
    is_complete: bool
    """Whether that is all there is; else a limit was reached."""


@result
class TriangleList(NamedTuple):
    """Triangles of a mesh, ascending."""

    triangles: Indices
    """Of the shape (k,)."""
    is_complete: bool
    """Whether that is all there is; else a limit was reached."""


@result
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


@result
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


@result
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


@result
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


@result
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


@result
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


@result
class ShapeSeparations(NamedTuple):
    """The same for each of n poses."""

    distance: Doubles
    """(n,)"""
    point_a: Doubles
    """(n, 3)"""
    point_b: Doubles
    """(n, 3)"""
    normal: Doubles
    """(n, 3)"""
    is_converged: Bools
    """(n,)"""


@result
class NearestPoint(NamedTuple):
    """The point of a placed mesh that is nearest to another."""

    distance: float
    """0 if and only if the point lies on the surface."""
    point: Doubles
    """Of the surface, (3,)."""
    triangle: int
    """In which it lies."""


@result
class NearestPoints(NamedTuple):
    """The same for each of n points."""

    distance: Doubles
    """(n,)"""
    point: Doubles
    """(n, 3)"""
    triangle: Indices
    """(n,)"""


@result
class RayHit(NamedTuple):
    """Where a ray meets something first."""

    distance: float
    """Metres along the ray."""
    point: Doubles
    """(3,)"""
    normal: Doubles
    """Unit, against the ray, (3,)."""
    triangle: Optional[int]
    """Of a mesh or a height field; None for other shapes."""
    material: int
    """Of that triangle, if it has one; else 0."""


@result
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
    """(n,); -1 there, and where a shape without triangles is hit."""
    material: NDArray[np.uint16]
    """(n,), of those triangles; 0 of what has none."""


@result
class RayHitLists(NamedTuple):
    """All that each of n rays meets."""

    hits: RayHits
    """Those of all rays, one ray after the other."""
    offsets: Offsets
    """(n + 1,): those of ray i are hits[offsets[i]:offsets[i + 1]] of each array."""


@result
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


@result
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


@result
class KDop(NamedTuple):
    """The points p with min[i] <= p . directions[i] <= max[i] for each of nine slabs."""

    min: Doubles
    """(9,)"""
    max: Doubles
    """(9,)"""
    directions: NDArray[np.int64]
    """(9, 3), whole numbers that are not normalised."""


@result
class MeshFit(NamedTuple):
    """How well volumes of four kinds fit a mesh."""

    enclosed_volume: Optional[float]
    """Of a closed mesh, m^3; else None."""
    kinds: Tuple[str, ...]
    """Of the volumes: aabb, sphere, obb, kdop."""
    volume: Doubles
    """(4,), m^3."""
    surface: Doubles
    """(4,), m^2."""
    empty_share: Doubles
    """(4,), of a closed mesh from 0 for a perfect fit to 1; NaN where it is not known."""
    relative_volume: Doubles
    """(4,), of an open mesh relative to that of its bounds; else NaN."""
