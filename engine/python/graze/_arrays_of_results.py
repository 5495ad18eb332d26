"""What results are made of, and how they compare."""

from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
Indices = NDArray[np.uint32]
Bools = NDArray[np.bool_]
Offsets = NDArray[np.int64]
Ids = NDArray[np.uint64]

_Result = TypeVar("_Result", bound=type)


def result(kind: _Result) -> _Result:
    """Makes a result of a tuple with names: of the package, and compared by all that it holds, to the bit. Tuples of
    arrays have no `==` of their own."""
    setattr(kind, "__eq__", _are_same)
    setattr(kind, "__ne__", lambda a, b: not _are_same(a, b))
    setattr(kind, "__module__", "graze")
    return kind


def _are_same(a: Any, b: Any) -> bool:
    if type(a) is not type(b):
        return False
    return all(
        np.array_equal(x, y, equal_nan=np.asarray(x).dtype.kind == "f") if isinstance(x, np.ndarray) else bool(x == y)
        for x, y in zip(a, b)
    )
