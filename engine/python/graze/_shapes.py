"""The kinds of shapes: closed and solid, in a frame of their own, metres, with z as their axis."""

from typing import Any, Tuple

from numpy.typing import ArrayLike

from graze._graze import Shape


class _Kind(Shape):
    """What all kinds share: they are pickled, compared and shown by their numbers."""

    def __reduce__(self) -> Tuple[Any, Tuple[Any, ...]]:
        return type(self), tuple(self._arguments())

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(repr(number) for number in self._arguments())})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Kind) and self.kind == other.kind and repr(self) == repr(other)

    def __hash__(self) -> int:
        return hash(repr(self))


class Sphere(_Kind):
    """The points at most `radius` from `centre`.

    >>> graze.intersects(graze.Sphere([0, 0, 0], 1), graze.Sphere([2, 0, 0], 1))
    True
    >>> graze.Sphere([0, 0, 0], -1)
    Traceback (most recent call last):
        ...
    graze.InputError: sphere: the radius is not positive
    """

    def __init__(self, centre: ArrayLike, radius: float) -> None:
        super().__init__("sphere", centre, radius)


class Box(_Kind):
    """[-half_extents, half_extents]."""

    def __init__(self, half_extents: ArrayLike) -> None:
        super().__init__("box", half_extents)


class Capsule(_Kind):
    """The points at most `radius` from the segment between z = -half_length and z = half_length."""

    def __init__(self, radius: float, half_length: float) -> None:
        super().__init__("capsule", radius, half_length)


class Cylinder(_Kind):
    """Between z = -half_height and z = half_height around the z axis."""

    def __init__(self, radius: float, half_height: float) -> None:
        super().__init__("cylinder", radius, half_height)


class Cone(_Kind):
    """The apex is at z = half_height, the base, of that radius, at z = -half_height."""

    def __init__(self, radius: float, half_height: float) -> None:
        super().__init__("cone", radius, half_height)


class Ellipsoid(_Kind):
    """Its axes are the coordinate axes."""

    def __init__(self, centre: ArrayLike, semi_axes: ArrayLike) -> None:
        super().__init__("ellipsoid", centre, semi_axes)


class ConvexHull(_Kind):
    """The convex hull of points of the shape (n, 3). Raises InputError for points without a volume."""

    def __init__(self, points: ArrayLike) -> None:
        super().__init__("convex hull", points)

    @property
    def vertices(self) -> Any:
        """Its corners, of the shape (k, 3), in the order of the points that they were."""
        return self._arguments()[0]


class HalfSpace(_Kind):
    """The points x with normal . x <= offset; the normal is of any length but 0."""

    def __init__(self, normal: ArrayLike, offset: float = 0.0) -> None:
        super().__init__("half-space", normal, offset)


_CLASSES = (Sphere, Box, Capsule, Cylinder, Cone, Ellipsoid, ConvexHull, HalfSpace)
_NAMES = ("sphere", "box", "capsule", "cylinder", "cone", "ellipsoid", "convex hull", "half-space")


def of_kind(name: str, *arguments: Any) -> Shape:
    """The shape of that kind, as the module calls for it."""
    kind: Any = _CLASSES[_NAMES.index(name)]
    shape: Shape = kind(*arguments)
    return shape


for _type in _CLASSES:
    _type.__module__ = "graze"
del _type
