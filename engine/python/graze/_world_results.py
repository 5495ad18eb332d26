"""What worlds return."""

from typing import NamedTuple

from graze._arrays_of_results import Bools, Doubles, Ids, Indices, Offsets, _are_same
from graze._contact_results import RigidContact, ShapeContacts
from graze._graze import Work


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
