"""What worlds return."""

from typing import Dict, List, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from graze._arrays_of_results import Bools, Doubles, Ids, Indices, Offsets, result
from graze._contact_results import RigidContact, RigidContacts, ShapeContacts
from graze._graze import Work


@result
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
    ids: Ids
    """(c,), of each contact, the same as long as it goes on: of updates of a world that tracks contacts; else (0,)."""


@result
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
    is_at_start: Bools
    """(k,)"""
    point: Doubles
    """(k, 3), at `low`, between the two."""
    normal: Doubles
    """(k, 3), from the first to the second."""
    parts: Indices
    """(k, 2), which part of each, if it is a compound; else 0."""


@result
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
    counters: Dict[str, int]
    """What pairs of bodies took, and what could be left out, by name."""


@result
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
    part: int
    """Of a compound the nearest part; else 0."""
    lower_bound: float
    """Proved: the true distance is not less."""
    is_converged: bool
    """Whether the distance is known to its tolerance."""


@result
class BodyDistances(NamedTuple):
    """The same for each of k bodies, or for the closest body in each of k poses."""

    ids: Ids
    """(k,), ascending; or one a pose, of no body where there is none."""
    distance: Doubles
    """(k,)"""
    point_a: Doubles
    """(k, 3)"""
    point_b: Doubles
    """(k, 3)"""
    normal: Doubles
    """(k, 3)"""
    part: Indices
    """(k,)"""
    lower_bound: Doubles
    """(k,)"""
    is_converged: Bools
    """(k,)"""


@result
class BodyLists(NamedTuple):
    """Bodies for each of n poses."""

    ids: Ids
    """(k,), those of all poses, one pose after the other."""
    offsets: Offsets
    """(n + 1,): those of pose i are ids[offsets[i]:offsets[i + 1]]."""


@result
class BodyDistanceLists(NamedTuple):
    """Bodies and how far they are, for each of n poses."""

    distances: BodyDistances
    """Those of all poses, one pose after the other."""
    offsets: Offsets
    """(n + 1,): those of pose i are rows offsets[i] to offsets[i + 1] of each array."""


@result
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
    part: Indices
    """(n,), of a compound or a map of voxels; else 0."""
    triangle: Offsets
    """(n,), of a mesh or a height field; else -1."""
    material: NDArray[np.uint16]
    """(n,), of that triangle; 0 of what has none."""


@result
class BodyRayHitLists(NamedTuple):
    """Bodies that each of n rays meets."""

    hits: BodyRayHits
    """Those of all rays, one ray after the other, of each by distance."""
    offsets: Offsets
    """(n + 1,): those of ray i are rows offsets[i] to offsets[i + 1] of each array."""


@result
class BodyCast(NamedTuple):
    """A body that a shape in motion comes to, and when."""

    id: int
    """Of the body."""
    contact: RigidContact
    """Hit or close."""
    part: int
    """Of a compound that which is met first; else 0."""


@result
class BodyCasts(NamedTuple):
    """The body that a shape comes to first in each of n motions."""

    ids: Ids
    """(n,); of no body where the motion is free."""
    contacts: RigidContacts
    """Of n rows."""
    part: Indices
    """(n,), of a compound that which is met first; else 0."""


@result
class BodyCastLists(NamedTuple):
    """Bodies that a shape comes to in each of n motions, each asked as if it were alone."""

    casts: BodyCasts
    """Those of all motions, one motion after the other, of each by time."""
    offsets: Offsets
    """(n + 1,): those of motion i are rows offsets[i] to offsets[i + 1] of each array."""


@result
class BodyPairDistance(NamedTuple):
    """How far two bodies are apart, and where."""

    a: int
    """Of the world that was asked."""
    b: int
    """Of the other one, where there are two."""
    distance: float
    """0 if and only if they touch."""
    point_a: Doubles
    """(3,), in the frame of the world that was asked."""
    point_b: Doubles
    """(3,)"""
    normal: Doubles
    """(3,), from A to B."""
    parts: Tuple[int, int]
    """The nearest part of each, if it is a compound; else 0."""
    lower_bound: float
    """Proved: the true distance is not less."""
    is_converged: bool
    """Whether the distance is known to its tolerance."""


@result
class BodyPairDistances(NamedTuple):
    """The same for each of k pairs."""

    pairs: Ids
    """(k, 2)"""
    distance: Doubles
    """(k,)"""
    point_a: Doubles
    """(k, 3)"""
    point_b: Doubles
    """(k, 3)"""
    normal: Doubles
    """(k, 3)"""
    parts: Indices
    """(k, 2)"""
    lower_bound: Doubles
    """(k,)"""
    is_converged: Bools
    """(k,)"""


@result
class WorldDrawing(NamedTuple):
    """A world as a renderer shows it. For looking, not for deciding."""

    lines: Doubles
    """(k, 2, 3), the ends of segments, metres."""
    shows: NDArray[np.uint8]
    """(k,): 0 a shape, 1 a box, 2 a contact, 3 an island."""
    bodies: Ids
    """(k,), of a contact that of A, of an island its first."""
    points: Doubles
    """(p, 3), of contacts."""
    point_bodies: Ids
    """(p, 2)"""
    labels: List[Tuple[Doubles, str, int]]
    """Places, words and bodies."""
