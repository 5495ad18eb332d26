"""What the package raises."""

from typing import NamedTuple, Optional


class ErrorPlace(NamedTuple):
    """Where in its input an error lies, as far as that is known; None for what is not."""

    file: Optional[str] = None
    """As it was named."""
    line: Optional[int] = None
    """Of a text file, counted from 1."""
    byte: Optional[int] = None
    """Of a binary file, counted from 0."""
    element: Optional[str] = None
    """"vertex", "triangle", "pose", ..."""
    index: Optional[int] = None  # type: ignore[assignment]  # a name of tuples, too
    """Of that element, counted from 0."""


class Error(Exception):
    """Everything that graze raises for a bad argument derives from this, but for TypeError where an argument is of
    another kind altogether. The text is one line that names the place; `place` says the same to programs.

    >>> try:
    ...     graze.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, np.nan]], [[0, 1, 2]])
    ... except graze.MeshError as error:
    ...     error.place.element, error.place.index
    ('vertex', 2)
    """

    place: ErrorPlace = ErrorPlace()


class InputError(Error, ValueError):
    """A value that no query can answer for: NaN, infinity, a wrong shape of an array, an unknown word."""


class PoseError(Error, ValueError):
    """A pose that is not rigid, not finite, or moves something out of the range of double."""


class MeshError(Error, ValueError):
    """A mesh that cannot be, or that cannot be read, or that is not closed where it has to be."""


class StaleIdError(Error, LookupError):
    """An id of what was removed, or which was never given out."""


class UnsupportedPairError(Error, ValueError):
    """Two shapes of kinds for which a question has no answer."""


class CaseError(Error, ValueError):
    """A case file that cannot be read or written."""


for _type in (ErrorPlace, Error, InputError, PoseError, MeshError, StaleIdError, UnsupportedPairError, CaseError):
    _type.__module__ = "graze"
del _type
