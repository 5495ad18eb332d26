"""A collision manager with the names and return values of trimesh's, over graze: exact, on the doubles of its poses.

Meshes are those of trimesh, or anything with `vertices` and `faces`. Meshes are surfaces: one that is wholly inside
another does not touch it. Distances of meshes that touch are 0.
"""

from typing import Any, Dict, FrozenSet, List, Optional, Set, Tuple

import numpy as np
from numpy.typing import NDArray

import graze

__all__ = ["CollisionManager", "ContactData", "DistanceData"]


class ContactData:
    """One connected piece of the intersection of two meshes."""

    def __init__(self, names: Tuple[str, str], triangles: Tuple[int, int], point: Any, normal: Any, depth: float) -> None:
        self.names: FrozenSet[str] = frozenset(names)
        self.point: NDArray[np.float64] = point
        self.normal: NDArray[np.float64] = normal
        self.depth = depth
        self._triangles = dict(zip(names, triangles))

    def index(self, name: str) -> int:
        """The triangle of that object in which its deepest point lies."""
        return self._triangles[name]


class DistanceData:
    """How far apart two meshes are, and where."""

    def __init__(self, names: Tuple[str, str], gap: Any) -> None:
        self.names: FrozenSet[str] = frozenset(names)
        self.distance: float = gap.distance
        self._triangles = dict(zip(names, gap.pair))
        self._points: Dict[str, NDArray[np.float64]] = dict(zip(names, (gap.point_a, gap.point_b)))

    def index(self, name: str) -> int:
        """The triangle of that object in which its nearest point lies."""
        return int(self._triangles[name])

    def point(self, name: str) -> NDArray[np.float64]:
        """The point of that object that is nearest to the other."""
        return self._points[name]


_EXTERNAL = "__external"
"""How the data of a query about a mesh that is no object names it."""


class CollisionManager:
    """Meshes by name, each in a pose, and which of them touch.

    >>> from graze.trimesh import CollisionManager
    >>> manager = CollisionManager()
    >>> manager.add_object("bolt", bolt)
    >>> manager.add_object("nut", nut, pose)
    >>> manager.in_collision_internal(return_names=True)
    (True, {('bolt', 'nut')})
    >>> manager.set_transform("nut", far)
    >>> manager.in_collision_internal()
    False
    """

    def __init__(self) -> None:
        self._world = graze.World(contacts=False)
        self._ids: Dict[str, int] = {}
        self._names: Dict[int, str] = {}
        self._meshes: Dict[str, Tuple[Any, graze.Mesh]] = {}

    def add_object(self, name: str, mesh: Any, transform: Any = None) -> None:
        """Adds a mesh under a name, or replaces the one that has it."""
        made = _mesh_of(mesh)
        pose = _pose_of(transform)
        if name in self._ids:
            self.remove_object(name)
        body = self._world.add((made, pose))
        self._ids[name] = body
        self._names[body] = name
        self._meshes[name] = mesh, made

    def remove_object(self, name: str) -> None:
        """Raises ValueError for a name that is not there."""
        body = self._id(name)
        self._world.remove(body)
        del self._ids[name], self._names[body], self._meshes[name]

    def set_transform(self, name: str, transform: Any) -> None:
        """Takes an object to a pose. Raises ValueError for a name that is not there."""
        self._world.move(self._id(name), _pose_of(transform))

    def in_collision_single(
        self, mesh: Any, transform: Any = None, return_names: bool = False, return_data: bool = False
    ) -> Any:
        """Whether a mesh touches any object; then the set of their names, and a list of ContactData."""
        placed = _mesh_of(mesh), _pose_of(transform)
        names = {self._names[int(body)] for body in self._world.find_touching(placed)}
        data = []
        if return_data:
            for name in sorted(names):
                data += _contacts((name, _EXTERNAL), self._placed(name), placed)
        return _told(bool(names), names, data, return_names, return_data)

    def in_collision_internal(self, return_names: bool = False, return_data: bool = False) -> Any:
        """Whether any two objects touch; then the set of pairs of names, each ascending, and a list of ContactData."""
        self._world.update()
        names: Set[Tuple[str, str]] = set()
        for a, b in self._world.pairs():
            first, second = sorted((self._names[int(a)], self._names[int(b)]))
            names.add((first, second))
        return self._told_pairs(names, self, return_names, return_data)

    def in_collision_other(
        self, other_manager: "CollisionManager", return_names: bool = False, return_data: bool = False
    ) -> Any:
        """Whether an object touches one of another manager; then the set of pairs of names, this manager's first."""
        names = set()
        for name in other_manager._ids:
            for body in self._world.find_touching(other_manager._placed(name)):
                names.add((self._names[int(body)], name))
        return self._told_pairs(names, other_manager, return_names, return_data)

    def min_distance_single(
        self, mesh: Any, transform: Any = None, return_name: bool = False, return_data: bool = False
    ) -> Any:
        """The least distance of a mesh to any object, metres; then the name of that, and a DistanceData."""
        placed = _mesh_of(mesh), _pose_of(transform)
        found = self._world.find_closest(placed)
        if found is None:
            return _told(float("inf"), None, None, return_name, return_data)
        name = self._names[found.id]
        gap = graze.distance(self._placed(name), placed)
        return _told(gap.distance, name, DistanceData((name, _EXTERNAL), gap), return_name, return_data)

    def min_distance_internal(self, return_names: bool = False, return_data: bool = False) -> Any:
        """The least distance of any two objects, metres; then their names, ascending, and a DistanceData."""
        names = sorted(self._ids)
        pairs = [(a, b) for i, a in enumerate(names) for b in names[i + 1 :]]
        return self._least(pairs, self, return_names, return_data)

    def min_distance_other(
        self, other_manager: "CollisionManager", return_names: bool = False, return_data: bool = False
    ) -> Any:
        """The least distance to an object of another manager; then the names, this manager's first."""
        pairs = [(a, b) for a in sorted(self._ids) for b in sorted(other_manager._ids)]
        return self._least(pairs, other_manager, return_names, return_data)

    def _id(self, name: str) -> int:
        if name not in self._ids:
            raise ValueError(f"{name!r} is no object of this manager")
        return self._ids[name]

    def _placed(self, name: str) -> Tuple[graze.Mesh, Any]:
        return self._meshes[name][1], self._world.poses(self._ids[name])

    def _told_pairs(self, names: Set[Tuple[str, str]], other: "CollisionManager", with_names: bool, with_data: bool) -> Any:
        data = []
        if with_data:
            for pair in sorted(names):
                data += _contacts(pair, self._placed(pair[0]), other._placed(pair[1]))
        return _told(bool(names), names, data, with_names, with_data)

    def _least(self, pairs: List[Tuple[str, str]], other: "CollisionManager", with_names: bool, with_data: bool) -> Any:
        """Nearer boxes before others, so that few meshes are measured."""
        boxes_a = {name: graze.bounding_aabb(self._placed(name)) for name, _ in pairs}
        boxes_b = {name: graze.bounding_aabb(other._placed(name)) for _, name in pairs}
        gaps = [(_gap(boxes_a[a], boxes_b[b]), (a, b)) for a, b in pairs]
        least: Optional[Any] = None
        names: Optional[Tuple[str, str]] = None
        for gap, pair in sorted(gaps):
            if least is not None and gap > least.distance:
                break
            found = graze.distance(self._placed(pair[0]), other._placed(pair[1]))
            if least is None or found.distance < least.distance:
                least, names = found, pair
        if least is None or names is None:
            return _told(float("inf"), None, None, with_names, with_data)
        return _told(least.distance, names, DistanceData(names, least), with_names, with_data)


def _mesh_of(mesh: Any) -> graze.Mesh:
    return mesh if isinstance(mesh, graze.Mesh) else graze.Mesh(mesh)


def _pose_of(transform: Any) -> Any:
    return np.eye(4) if transform is None else transform


def _contacts(names: Tuple[str, str], placed_a: Any, placed_b: Any) -> List[ContactData]:
    found = graze.find_contacts(placed_a, placed_b)
    if len(found.depth) == 0:
        return []
    triangles_a = graze.nearest_points(placed_a, found.point_a).triangle
    triangles_b = graze.nearest_points(placed_b, found.point_b).triangle
    return [
        ContactData(names, (int(triangles_a[i]), int(triangles_b[i])), found.point[i], found.normal[i], float(depth))
        for i, depth in enumerate(found.depth)
    ]


def _gap(a: Any, b: Any) -> float:
    """No more than the distance of what the boxes hold: of the largest gap along an axis, in doubles."""
    return float(max(0.0, *(np.maximum(a[0] - b[1], b[0] - a[1])))) * (1 - 1e-15)


def _told(first: Any, names: Any, data: Any, with_names: bool, with_data: bool) -> Any:
    """A value alone, or a tuple of what was asked for."""
    if not with_names and not with_data:
        return first
    return (first,) + ((names,) if with_names else ()) + ((data,) if with_data else ())
