"""What results are made of, and how they compare."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

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
