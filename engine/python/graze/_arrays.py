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


def rows_of_unsigned(value: Any, name: str) -> Any:
    """The same as uint32."""
    array = _array_of(value, name)
    return rows_of_indices(array.astype(np.int64) if array.dtype.kind == "i" else array, name)


def shorts(value: Any, name: str) -> Any:
    """Whole numbers of the shape (n,) from 0 to 65535, one after the other in memory."""
    return _small_numbers(value, name, np.uint16, 1)


def heights(value: Any, name: str) -> Any:
    """Heights of the shape (rows, columns), row after row in memory: uint16 as they are, others as float32, which
    must hold them."""
    array = _array_of(value, name)
    if array.ndim != 2:
        raise InputError(f"{name}: the shape {array.shape} is not (rows, columns)")
    if array.dtype == np.uint16:
        return np.require(array, np.uint16, ["C", "A"])
    if array.dtype.kind not in "fiu":
        raise InputError(f"{name}: numbers of the type {array.dtype} are no heights")
    with np.errstate(all="ignore"):
        floats = np.require(array, np.float32, ["C", "A"])
        changed = (floats.astype(np.float64) != array.astype(np.float64)) & ~np.isnan(array.astype(np.float64))
    if changed.any():
        row, column = (int(place) for place in np.argwhere(changed)[0])
        raise InputError(f"{name}: row {row}, column {column}: {array[row, column]} is no number of 32 bits; round them")
    return floats


def bytes_of_cells(value: Any, name: str) -> Any:
    """For each cell a whole number from 0 to 255, or a bool: of the shape (rows, columns), row after row."""
    array = _array_of(value, name)
    return _small_numbers(array.astype(np.uint8) if array.dtype == np.bool_ else array, name, np.uint8, 2)


def voxels(value: Any, name: str) -> Any:
    """Rows of three whole numbers from 0 to 65535; one of the shape (3,) becomes a row."""
    array = _array_of(value, name)
    array = array.reshape(1, -1) if array.ndim == 1 and array.size == 3 else array
    _check_rows(array, name)
    return _small_numbers(array, name, np.uint16, 2)


def _small_numbers(value: Any, name: str, kind: Any, dimensions: int) -> Any:
    array = _array_of(value, name)
    if array.size == 0 and array.dtype == np.float64:
        array = array.astype(kind)
    if array.ndim != dimensions or array.dtype.kind not in "iu":
        raise InputError(f"{name}: are no whole numbers in {dimensions} dimensions, but {array.dtype} {array.shape}")
    most = np.iinfo(kind).max
    if array.size and (int(array.min()) < 0 or int(array.max()) > most):
        raise InputError(f"{name}: are not all from 0 to {most}")
    return np.require(array, kind, ["C", "A"])


def _array_of(value: Any, name: str) -> Any:
    try:
        with np.errstate(all="ignore"):
            return np.asarray(value)
    except (ValueError, TypeError) as error:
        raise InputError(f"{name}: is no array of numbers: {error}") from None


def _check_rows(array: Any, name: str) -> None:
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"{name}: the shape {array.shape} is not (n, 3)")


def ids(value: Any, name: str = "ids") -> NDArray[np.uint64]:
    """Ids of bodies or boxes, or other whole numbers of 64 bits, one after the other in memory."""
    array = _array_of(value, name)
    if array.size == 0 and array.ndim == 1:
        return np.empty(0, np.uint64)
    if array.dtype.kind in "fO" and all(isinstance(number, int) for number in np.ravel(np.array(value, object))):
        try:
            array = np.array(value, np.uint64)  # of large and small ones numpy would make float64
        except (OverflowError, ValueError):
            raise InputError(f"{name}: are not all from 0 to 2^64 - 1") from None
    if array.dtype.kind not in "iu" or array.ndim > 1:
        raise InputError(f"{name}: are neither a whole number nor an array of the shape (n,), but {array.dtype} {array.shape}")
    if array.dtype.kind == "i" and (array < 0).any():
        raise InputError(f"{name}: {array[array < 0].flat[0]} is negative")
    return np.ascontiguousarray(array, np.uint64).reshape(array.shape)
