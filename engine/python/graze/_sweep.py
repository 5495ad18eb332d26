"""One query over more poses than memory holds: in chunks, on threads or on a cluster, to files or to a reduction."""

import concurrent.futures
import pickle
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, Optional, Tuple, Union

import numpy as np

from graze._errors import InputError
from graze._sweep_files import Journal, ResultFiles, digest_of
from graze._sweep_zarr import ZarrStore

_IN_FLIGHT = 16
"""Chunks that an executor has at a time: their poses are in memory."""


class over_poses:
    """A query of a pair, to be asked for poses of `b`: over_poses(query, a, b, **settings)(poses) is
    query(a, (b, poses), **settings). It can be pickled.

    >>> touches = graze.over_poses(graze.intersects, bolt, nut)
    >>> touches(np.stack([pose, far]))
    array([ True, False])
    """

    def __init__(self, query: Callable[..., Any], a: Any, b: Any, **settings: Any) -> None:
        self.query = query
        self.a = a
        self.b = b
        self.settings = settings

    def __call__(self, poses: Any) -> Any:
        return self.query(self.a, (self.b, poses), **self.settings)


class Reduction:
    """What remains of many answers. `of` makes a small JSON value of a chunk's; `join` makes one of two, in whatever
    order they come."""

    def of(self, begin: int, answers: Any) -> Any:
        """The value of a chunk whose first pose has the index `begin`."""
        raise NotImplementedError

    def join(self, a: Any, b: Any) -> Any:
        """The value of two chunks, or of what is made of chunks."""
        raise NotImplementedError

    def is_settled(self, value: Any, next_begin: int) -> bool:
        """Whether poses from `next_begin` on can change nothing."""
        return False

    def result(self, value: Any) -> Any:
        """What the caller gets; `value` is None of no chunks."""
        return value


class count(Reduction):
    """How many answers are true: an int."""

    def of(self, begin: int, answers: Any) -> Any:
        return int(np.count_nonzero(answers))

    def join(self, a: Any, b: Any) -> Any:
        return a + b

    def result(self, value: Any) -> Any:
        return value or 0


class first_hit(Reduction):
    """The index of the first pose whose answer is true, or None. Later poses are not asked."""

    def of(self, begin: int, answers: Any) -> Any:
        hits = np.flatnonzero(answers)
        return [begin + int(hits[0])] if len(hits) else []

    def join(self, a: Any, b: Any) -> Any:
        return [min(a + b)] if a + b else []

    def is_settled(self, value: Any, next_begin: int) -> bool:
        return bool(value)

    def result(self, value: Any) -> Any:
        return value[0] if value else None


class least_distance(Reduction):
    """The least distance and the index of the first pose that has it: (metres, index), or None of no poses."""

    def of(self, begin: int, answers: Any) -> Any:
        distances = np.asarray(getattr(answers, "distance", answers))
        if len(distances) == 0:
            return []
        index = int(np.argmin(distances))
        return [float(distances[index]).hex(), begin + index]

    def join(self, a: Any, b: Any) -> Any:
        if not a or not b:
            return a or b
        return min(a, b, key=lambda found: (float.fromhex(found[0]), found[1]))

    def result(self, value: Any) -> Any:
        return (float.fromhex(value[0]), value[1]) if value else None


def sweep(
    query: Callable[[Any], Any],
    poses: Any,
    *,
    out: Union[str, Path, None] = None,
    reduce: Optional[Reduction] = None,
    journal: Union[str, Path, None] = None,
    chunk: int = 65536,
    executor: Any = None,
    progress: Any = None,
) -> Any:
    """Asks a query for many poses, in chunks.

    `query` takes poses of the shape (k, 4, 4) and returns an array with k rows, or a tuple with names of such arrays;
    over_poses() makes one. `poses` is an array, the name of a `.npy` file, which is mapped, a Dask array, or an
    iterable of poses or of arrays of them. A Zarr array is read in parts, too.

    With `out`, the name of a `.npy` file, answers are written there, those with names to one file each,
    NAME.MEMBER.npy, and the names are returned; a file appears when it is whole. A name that ends in `.zarr` is that of
    a Zarr store instead, an array or a group with an array for each name, whose chunks are those of the sweep: for
    answers that many are to read in parts. That needs the package zarr. With `reduce`, count(), first_hit()
    or least_distance(), that is returned. With neither the answers are returned in memory.

    A sweep that was killed goes on where it was when it is called again with the same arguments: `journal`, by
    default NAME.journal beside `out`, tells which chunks are done, and of what poses. No chunk that is in it is asked
    again.

    Chunks are asked here, on all threads, or by an `executor`: one of concurrent.futures, or mpi4py's, or a client of
    Dask's distributed scheduler. `progress` is called with (done, total), or is a bar with a method update(); a total
    that is not known is None.

    Raises InputError for arguments that do not go together, and for poses or a query other than those of the journal;
    and what the query raises.

    >>> touches = graze.over_poses(graze.intersects, bolt, nut)
    >>> graze.sweep(touches, np.stack([far, pose, pose]), reduce=graze.count())
    2
    >>> graze.sweep(touches, np.stack([far, pose, pose]), reduce=graze.first_hit())
    1
    """
    if out is not None and reduce is not None:
        raise InputError("out: is not taken beside reduce")
    if chunk < 1:
        raise InputError(f"chunk: {chunk} is not above 0")
    if journal is None and out is not None:
        journal = f"{out}.journal"
    if journal is not None and out is None and reduce is None:
        raise InputError("journal: is for answers in a file, or for a reduction")
    total = _length_of(poses)
    record = None if journal is None else Journal(Path(journal), _identity(query, reduce, chunk))
    files: Union[None, ZarrStore, ResultFiles] = None
    try:
        if out is not None and record is not None:
            is_store = Path(out).suffix == ".zarr"
            files = ZarrStore(Path(out), record, chunk, total) if is_store else ResultFiles(Path(out), record)
        run = _Run(query, reduce, files, record, executor, _watch(progress, total))
        run.all_of(_chunks_of(poses, chunk))
        if files is not None:
            return files.finish(run.done)
        return reduce.result(run.value) if reduce is not None else run.joined()
    finally:
        if files is not None:
            files.close()
        if record is not None:
            record.close()


def _ask(query: Any, reduce: Optional[Reduction], begin: int, poses: Any) -> Any:
    """What a worker does: of a reduction it sends back little."""
    answers = query(poses)
    rows = len(answers[0]) if isinstance(answers, tuple) else len(answers)
    if rows != len(poses):
        raise InputError(f"query: has {rows} answers to {len(poses)} poses")
    return answers if reduce is None else reduce.of(begin, answers)


class _Run:
    def __init__(self, query: Any, reduce: Any, files: Any, record: Any, executor: Any, watch: Any) -> None:
        self.query, self.reduce, self.files, self.record = query, reduce, files, record
        self.executor = executor.get_executor() if hasattr(executor, "get_executor") else executor
        self.watch = watch
        self.value: Any = None
        self.done = 0
        self.answers: Dict[int, Any] = {}

    def all_of(self, chunks: Iterator[Tuple[int, Any]]) -> None:
        waiting: Dict[Any, Tuple[int, int, str]] = {}
        try:
            for begin, poses in chunks:
                if self.value is not None and self.reduce.is_settled(self.value, begin):
                    break
                digest = "" if self.record is None else digest_of(poses)
                known = None if self.record is None else self.record.known(begin, len(poses), digest)
                if known is not None:
                    self._take_value(known[0], len(poses))
                elif self.executor is None:
                    self._take(_ask(self.query, self.reduce, begin, poses), begin, len(poses), digest)
                else:
                    waiting[self.executor.submit(_ask, self.query, self.reduce, begin, poses)] = begin, len(poses), digest
                    self._collect(waiting, _IN_FLIGHT - 1)
            self._collect(waiting, 0)
        finally:
            for future in waiting:
                future.cancel()

    def _collect(self, waiting: Dict[Any, Tuple[int, int, str]], remaining: int) -> None:
        while len(waiting) > remaining:
            finished, _ = concurrent.futures.wait(waiting, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in finished:
                begin, length, digest = waiting.pop(future)
                self._take(future.result(), begin, length, digest)

    def _take(self, answer: Any, begin: int, length: int, digest: str) -> None:
        if self.files is not None:
            self.files.write(begin, answer)
        elif self.reduce is None:
            self.answers[begin] = answer
        value = answer if self.reduce is not None else None
        if self.record is not None:
            self.record.add(begin, length, digest, value)
        self._take_value(value, length)

    def _take_value(self, value: Any, length: int) -> None:
        if self.reduce is not None:
            self.value = value if self.value is None else self.reduce.join(self.value, value)
        self.done += length
        self.watch(self.done, length)

    def joined(self) -> Any:
        parts = [self.answers[begin] for begin in sorted(self.answers)]
        if not parts:
            return self.query(np.empty((0, 4, 4)))
        if isinstance(parts[0], tuple):
            columns = [np.concatenate(column) for column in zip(*parts)]
            return parts[0]._make(columns)  # type: ignore[attr-defined]
        return np.concatenate(parts)


def _identity(query: Any, reduce: Any, chunk: int) -> Dict[str, Any]:
    kind = None if reduce is None else type(reduce).__name__
    try:
        content = pickle.dumps(query, protocol=4)
    except Exception as error:
        raise InputError(f"query: cannot be pickled, so that a journal could not tell it from others: {error}") from None
    return {"query": digest_of(content), "reduce": kind, "chunk": chunk}


def _length_of(poses: Any) -> Optional[int]:
    if isinstance(poses, (str, Path)):
        return len(np.load(poses, mmap_mode="r"))
    return len(poses) if hasattr(poses, "__len__") else None


def _chunks_of(poses: Any, size: int) -> Iterator[Tuple[int, Any]]:
    """Where each chunk begins, and its poses."""
    if isinstance(poses, (str, Path)):
        poses = np.load(poses, mmap_mode="r")
    if hasattr(poses, "shape"):
        if len(poses.shape) != 3 or poses.shape[1:] not in ((4, 4), (3, 4)):
            raise InputError(f"poses: the shape {tuple(poses.shape)} is neither (n, 4, 4) nor (n, 3, 4)")
        for begin in range(0, len(poses), size):
            part = poses[begin : begin + size]
            yield begin, np.asarray(part.compute() if hasattr(part, "compute") else part)
        return
    begin = 0
    kept: Any = []
    for poses_or_pose in poses:
        part = np.asarray(poses_or_pose)
        kept.extend(part if part.ndim == 3 else [part])
        while len(kept) >= size:
            yield begin, np.stack(kept[:size])
            begin += size
            del kept[:size]
    if kept:
        yield begin, np.stack(kept)


def _watch(progress: Any, total: Optional[int]) -> Callable[[int, int], None]:
    if progress is None:
        return lambda done, more: None

    def tell(done: int, more: int) -> None:
        progress.update(more) if hasattr(progress, "update") else progress(done, total)

    return tell
