"""Answers of a sweep in a Zarr store: one chunk of it for each chunk of the sweep."""

import importlib
import os
import shutil
from pathlib import Path
from typing import Any, Dict, Optional

import numpy as np

from graze._errors import InputError
from graze._sweep_files import Journal, members_of


class ZarrStore:
    """An array, or a group with an array for each member of a tuple of them: NAME.part until it is whole."""

    def __init__(self, path: Path, journal: Journal, chunk: int, total: Optional[int]) -> None:
        try:
            self._zarr = importlib.import_module("zarr")
        except ImportError:
            raise InputError(f"out: {path} needs the package zarr, python3-zarr of Debian") from None
        self._path = path
        self._part = path.with_name(path.name + ".part")
        self._journal = journal
        self._chunk = chunk
        self._total = total
        self._arrays: Dict[str, Any] = {}
        if path.exists() and journal.layout is None:
            raise InputError(f"out: {path} is there already; remove it to begin anew")

    def write(self, begin: int, answers: Any) -> None:
        members = members_of(answers)
        if self._journal.take_layout(members):
            if self._part.exists():
                shutil.rmtree(self._part)
            self._create(members)
        for name, rows in members.items():
            rows = np.asarray(rows)
            array = self._open(name)
            if array.shape[0] < begin + len(rows):
                _resize(array, begin + len(rows))
            array[begin : begin + len(rows)] = rows
            self._settle(name, begin // self._chunk, rows.ndim)

    def finish(self, length: int) -> Path:
        """Gives the store its length and its name, which is returned."""
        if self._journal.layout is None:
            raise InputError("poses: there are none")
        if self._part.exists():
            for name, _, _ in self._journal.layout:
                _resize(self._open(name), length)
            os.sync()
            os.rename(self._part, self._path)
        elif not self._path.exists():
            raise InputError(f"out: {self._path} is gone, and {self._journal.path} says that it is written")
        return self._path

    def close(self) -> None:
        """What is not finished stays for the next sweep: nothing of it is held."""

    def _create(self, members: Dict[str, Any]) -> None:
        if list(members) != [""]:
            self._zarr.open_group(str(self._part), mode="w")
        for name, rows in members.items():
            rows = np.asarray(rows)
            settings = {"shape": (self._total or 0, *rows.shape[1:]), "chunks": (self._chunk, *rows.shape[1:])}
            self._arrays[name] = self._zarr.open_array(self._place(name), mode="w", dtype=rows.dtype, fill_value=0, **settings)
        os.sync()

    def _place(self, name: str) -> str:
        return str(self._part / name) if name else str(self._part)

    def _open(self, name: str) -> Any:
        if name not in self._arrays:
            if not self._part.exists():
                raise InputError(f"out: {self._part} is gone, and {self._journal.path} says that it is written")
            self._arrays[name] = self._zarr.open_array(self._place(name), mode="r+")
        return self._arrays[name]

    def _settle(self, name: str, index: int, dimensions: int) -> None:
        """The chunk is on the disk, before the journal says so."""
        parts = [str(index)] + ["0"] * (dimensions - 1)
        folder = Path(self._place(name))
        for key in (".".join(parts), "/".join(parts), "/".join(["c", *parts])):
            if (folder / key).is_file():
                for place in (folder / key, (folder / key).parent):
                    descriptor = os.open(place, os.O_RDONLY)
                    try:
                        os.fsync(descriptor)
                    finally:
                        os.close(descriptor)
                return
        os.sync()


def _resize(array: Any, length: int) -> None:
    if array.shape[0] != length:
        array.resize((length, *array.shape[1:]))
