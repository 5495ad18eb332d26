"""The kinds of shapes: closed and solid, in a frame of their own, metres, with z as their axis; and terrains."""

from typing import Any, List, Tuple, cast

import numpy as np
from numpy.typing import ArrayLike

from graze._graze import Mesh, Shape, _bytes_of_field, _facets_of_hull, _field_with_heights, _mesh_of_field


class _Kind(Shape):
    """What all kinds share: they are pickled, compared and shown by their numbers."""

    def __reduce__(self) -> Tuple[Any, Tuple[Any, ...]]:
        return type(self), tuple(self._arguments())

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(repr(number) for number in self._arguments())})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Kind) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash(self._content())

    def _content(self) -> Tuple[Any, ...]:
        """All numbers, to the bit: the text of a long array leaves some out."""
        return (self.kind, *(_plain(number) for number in self._arguments()))


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

    @property
    def facets(self) -> List[Any]:
        """The corners of each facet, counter-clockwise from outside: an array of indices of vertices for each.

        >>> hull = graze.ConvexHull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> len(hull.facets)
        4
        """
        return _facets_of_hull(self)


class HalfSpace(_Kind):
    """The points x with normal . x <= offset; the normal is of any length but 0."""

    def __init__(self, normal: ArrayLike, offset: float = 0.0) -> None:
        super().__init__("half-space", normal, offset)


class Plane(_Kind):
    """The points x with normal . x == offset: both sides of it are free. The normal is of any length but 0.

    >>> graze.distance(graze.Plane([0, 0, 1]), graze.Sphere([0, 0, -3], 1)).distance
    2.0
    """

    def __init__(self, normal: ArrayLike, offset: float = 0.0) -> None:
        super().__init__("plane", normal, offset)


class HeightField(_Kind):
    """A terrain: heights over a grid, a surface without a triangle in memory.

    `heights` have the shape (rows, columns), uint16 or numbers that float32 holds. The height h in column c and row r is
    the point (c spacing[0], r spacing[1], h height_scale + height_offset), metres. `holes`, of the shape
    (rows - 1, columns - 1), are true for cells that are not there; `materials` likewise are a number from 0 to 255 for
    each cell, which contacts and rays carry.

    Raises InputError, with the row and the column, for a height that is not finite, and for other shapes of arrays.

    >>> hills = graze.HeightField(np.zeros((5, 4)), spacing=(2, 1))
    >>> graze.cast_rays(hills, [3, 2.5, 9], [0, 0, -1]).distance
    9.0
    >>> graze.intersects(hills, graze.Sphere([3, 2, 0.5], 0.5))
    True
    """

    def __init__(
        self,
        heights: Any,
        spacing: Tuple[float, float] = (1.0, 1.0),
        height_scale: float = 1.0,
        height_offset: float = 0.0,
        holes: Any = None,
        materials: Any = None,
    ) -> None:
        super().__init__("height field", heights, spacing, height_scale, height_offset, holes, materials)

    def __repr__(self) -> str:
        rows, columns = self.heights.shape
        return f"HeightField({rows} rows, {columns} columns)"

    @property
    def heights(self) -> Any:
        """A copy of the heights as they are stored, of the shape (rows, columns)."""
        return self._arguments()[0]

    def with_heights(self, first_row: int, first_column: int, heights: Any) -> "HeightField":
        """The field with other heights in a part of it, from that row and column on; it shares all else with this one.

        >>> crater = graze.HeightField(np.zeros((5, 4))).with_heights(1, 1, [[-1, -1]])
        >>> crater.heights[1]
        array([ 0., -1., -1.,  0.], dtype=float32)
        """
        changed: Any = _field_with_heights(self, first_column, first_row, heights)
        return cast("HeightField", changed)

    def mesh(self) -> Mesh:
        """The mesh of the same triangles, without those of holes."""
        return _mesh_of_field(self)

    @property
    def bytes(self) -> int:
        """What the field takes, which fields of with_heights() share."""
        return _bytes_of_field(self)


_CLASSES = (Sphere, Box, Capsule, Cylinder, Cone, Ellipsoid, ConvexHull, HalfSpace, HeightField, Plane)
_NAMES = (
    "sphere",
    "box",
    "capsule",
    "cylinder",
    "cone",
    "ellipsoid",
    "convex hull",
    "half-space",
    "height field",
    "plane",
)


def _plain(number: Any) -> Any:
    if isinstance(number, np.ndarray):
        return number.dtype.str, number.shape, number.tobytes()
    return number


def of_kind(name: str, *arguments: Any) -> Shape:
    """The shape of that kind, as the module calls for it."""
    kind: Any = _CLASSES[_NAMES.index(name)]
    shape: Shape = kind(*arguments)
    return shape


for _type in _CLASSES:
    _type.__module__ = "graze"
del _type
