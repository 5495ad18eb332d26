"""What a sweep leaves on disk: its answers, and a journal of the chunks that are done."""

import hashlib
import json
import os
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from graze._errors import InputError

_HEADER_BYTES = 128


def digest_of(content: Any) -> str:
    """Of bytes, or of an array with its shape."""
    if isinstance(content, bytes):
        return hashlib.blake2b(content, digest_size=16).hexdigest()
    shape = f"{content.shape} {content.dtype.str};".encode()
    return hashlib.blake2b(shape + np.ascontiguousarray(content).tobytes(), digest_size=16).hexdigest()


def members_of(answers: Any) -> Dict[str, Any]:
    """The arrays of a tuple by their names; one that is no tuple has the name \"\"."""
    names = getattr(answers, "_fields", None)
    return {"": answers} if names is None else dict(zip(names, answers))


class Journal:
    """Lines of JSON: what is asked, the layout of the answers, then a line for each chunk that is done. A line that a
    kill has cut short does not count."""

    def __init__(self, path: Path, identity: Dict[str, Any]) -> None:
        self.path = path
        self.layout: Optional[List[Any]] = None
        self._known: Dict[int, List[Any]] = {}
        lines = self._whole_lines()
        if lines and lines[0] != identity:
            raise InputError(f"journal: {path} is of another query, reduction or chunk; remove it to begin anew")
        for line in lines[1:]:
            if "layout" in line:
                self.layout = line["layout"]
            else:
                self._known[line["begin"]] = [line["length"], line["poses"], line["value"]]
        self._file = open(path, "ab")
        if not lines:
            self._append(identity)

    def _whole_lines(self) -> List[Dict[str, Any]]:
        if not self.path.exists():
            return []
        content = self.path.read_bytes()
        whole = content[: content.rfind(b"\n") + 1]
        if len(whole) != len(content):
            os.truncate(self.path, len(whole))
        try:
            return [json.loads(line) for line in whole.splitlines()]
        except ValueError:
            raise InputError(f"journal: {self.path} is no journal of a sweep") from None

    def known(self, begin: int, length: int, digest: str) -> Optional[Tuple[Any]]:
        """The value of a chunk that is done. Throws if it was of other poses."""
        if begin not in self._known:
            return None
        if self._known[begin][:2] != [length, digest]:
            raise InputError(f"poses: those from {begin} on are others than those of {self.path}; remove it to begin anew")
        return (self._known[begin][2],)

    def add(self, begin: int, length: int, digest: str, value: Any) -> None:
        self._append({"begin": begin, "length": length, "poses": digest, "value": value})

    def take_layout(self, members: Dict[str, Any]) -> bool:
        """Whether these are the first answers: names, types and shapes are then those of all. Throws if others were."""
        layout = [[name, np.asarray(rows).dtype.str, list(np.shape(rows)[1:])] for name, rows in members.items()]
        if self.layout is None:
            self.layout = layout
            self._append({"layout": layout})
            return True
        if self.layout != layout:
            raise InputError(f"query: its answers have the layout {layout}, and earlier ones {self.layout}")
        return False

    def _append(self, line: Dict[str, Any]) -> None:
        self._file.write(json.dumps(line).encode() + b"\n")
        self._file.flush()
        os.fsync(self._file.fileno())

    def close(self) -> None:
        self._file.close()


class ResultFiles:
    """A `.npy` file for an array, or one for each member of a tuple of them: NAME.part until it is whole."""

    def __init__(self, path: Path, journal: Journal) -> None:
        self._path = path
        self._journal = journal
        self._files: Dict[str, Any] = {}

    def write(self, begin: int, answers: Any) -> None:
        members = members_of(answers)
        if self._journal.take_layout(members):
            for name in members:
                self._part(name).unlink(missing_ok=True)
        for name, rows in members.items():
            rows = np.ascontiguousarray(rows)
            file = self._open(name)
            file.seek(_HEADER_BYTES + begin * (rows.nbytes // max(len(rows), 1)))
            file.write(rows.tobytes())
            file.flush()
            os.fsync(file.fileno())  # before the journal says so

    def finish(self, length: int) -> Any:
        """Writes headers and gives the files their names. Returns these."""
        if self._journal.layout is None:
            raise InputError("poses: there are none")
        paths: Dict[str, Path] = {}
        for name, dtype, shape in self._journal.layout:
            paths[name] = self._named(name)
            if self._part(name).exists():
                file = self._open(name)
                file.seek(0)
                file.write(_header(dtype, (length, *shape)))
                file.flush()
                os.fsync(file.fileno())
                file.close()
                os.replace(self._part(name), paths[name])
            elif not paths[name].exists():
                raise InputError(f"out: {paths[name]} is gone, and {self._journal.path} says that it is written")
        return paths[""] if list(paths) == [""] else paths

    def close(self) -> None:
        """What is not finished stays for the next sweep."""
        for file in self._files.values():
            file.close()

    def _open(self, name: str) -> Any:
        if name not in self._files or self._files[name].closed:
            part = self._part(name)
            part.touch()
            self._files[name] = open(part, "r+b")
        return self._files[name]

    def _named(self, name: str) -> Path:
        return self._path if not name else self._path.with_name(f"{self._path.stem}.{name}.npy")

    def _part(self, name: str) -> Path:
        named = self._named(name)
        return named.with_name(named.name + ".part")


def _header(dtype: str, shape: Tuple[int, ...]) -> bytes:
    """Version 1.0 of numpy's format, always of the same length."""
    start = b"\x93NUMPY\x01\x00" + (_HEADER_BYTES - 10).to_bytes(2, "little")
    text = repr({"descr": dtype, "fortran_order": False, "shape": shape}).encode()
    return start + text.ljust(_HEADER_BYTES - 10 - 1) + b"\n"
