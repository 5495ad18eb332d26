"""Arguments that are not yet arrays as the library takes them. Nothing is rounded here: what would be is refused."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from graze._errors import InputError, MeshError

_LARGEST_EXACT = 2**53


def doubles(value: Any, name: str) -> Any:
    """The value as native float64, of any strides."""
    array = _array_of(value, name)
    kind, size = array.dtype.kind, array.dtype.itemsize
    if array.size == 0 and array.dtype == np.float64:
        return array
    if kind == "f" and size <= 8:
        return np.require(array, np.float64, "A")
    if kind in "iu":
        if size == 8 and array.size and (int(array.max()) > _LARGEST_EXACT or int(array.min()) < -_LARGEST_EXACT):
            raise InputError(f"{name}: whole numbers beyond 2^53 would be rounded")
        return array.astype(np.float64)
    raise InputError(f"{name}: numbers of the type {array.dtype} are not taken; float64 is")


def rows_of_doubles(value: Any, name: str) -> Any:
    """The same of the shape (n, 3), row after row in memory."""
    array = doubles(value, name)
    _check_rows(array, name)
    return np.ascontiguousarray(array)


def rows_of_indices(value: Any, name: str) -> Any:
    """Whole numbers of the shape (n, 3) as int32 or uint32, row after row in memory."""
    array = _array_of(value, name)
    _check_rows(array, name)
    if array.dtype in (np.int32, np.uint32):
        return np.require(array, array.dtype.newbyteorder("="), ["C", "A"])
    if array.dtype.kind not in "iu":
        if array.size:
            raise InputError(f"{name}: numbers of the type {array.dtype} are no indices")
        array = array.astype(np.int64)
    outside = (array < 0) | (array > 0xFFFFFFFF) if array.dtype.itemsize == 8 else array < 0
    if outside.any():
        row, column = (int(place) for place in np.argwhere(outside)[0])
        error = MeshError(f"triangle {row}: index {array[row, column]} is out of range")
        error.place = error.place._replace(element="triangle", index=row)
        raise error
    return np.ascontiguousarray(array, np.uint32)




def _array_of(value: Any, name: str) -> Any:
    try:
        with np.errstate(all="ignore"):
            return np.asarray(value)
    except (ValueError, TypeError) as error:
        raise InputError(f"{name}: is no array of numbers: {error}") from None


def _check_rows(array: Any, name: str) -> None:
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"{name}: the shape {array.shape} is not (n, 3)")


def ids(value: Any) -> NDArray[np.uint64]:
    """Ids of bodies or boxes, one after the other in memory."""
    array = _array_of(value, "ids")
    if array.size == 0 and array.ndim == 1:
        return np.empty(0, np.uint64)
    if array.dtype.kind not in "iu" or array.ndim > 1:
        raise InputError(f"ids: are neither a whole number nor an array of the shape (n,), but {array.dtype} {array.shape}")
    if array.dtype.kind == "i" and (array < 0).any():
        raise InputError("ids: below 0 there are none")
    return np.ascontiguousarray(array, np.uint64).reshape(array.shape)
