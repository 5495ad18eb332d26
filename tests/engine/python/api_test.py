"""Everything that the public headers declare has a binding, or a line that says why not."""

import importlib.machinery
import importlib.util
import re
from typing import Any, Dict, List, Set, Tuple

import graze
import graze.trimesh
import pytest
from conftest import SOURCES

TABLE = SOURCES / "tests" / "engine" / "python" / "not_bound.txt"
# Functions of a class of C++ are functions of the class of Python that has its name.
OWNERS = {
    "engine/world/world.h": graze.World,
    "engine/world/broad_phase.h": graze.BroadPhase,
    "engine/world/compound.h": graze.Compound,
    "engine/world/height_field.h": graze.HeightField,
    "engine/world/voxel_map.h": graze.VoxelMap,
}


def reader_of_headers() -> Any:
    """The script that finds functions in headers for another check."""
    loader = importlib.machinery.SourceFileLoader("examples_check", str(SOURCES / "tests" / "samples" / "examples_check"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("examples_check", loader))
    loader.exec_module(module)
    return module


def declared() -> List[Tuple[str, str]]:
    """(header, function) for all headers of graze.h."""
    reader = reader_of_headers()
    text = (SOURCES / "engine" / "graze.h").read_text(encoding="utf-8")
    headers = re.findall(r"#include <graze/(.*?)>", text)
    found = []
    for header in headers:
        path = SOURCES / header if (SOURCES / header).is_file() else SOURCES / "engine" / header
        header = str(path.relative_to(SOURCES))
        names = reader.functions_of(path.read_text(encoding="utf-8")) - {"end"}
        found += [(header, name) for name in sorted(names)]
    return found


def table() -> Dict[Tuple[str, str], Tuple[str, str]]:
    """(header or folder, name) to (kind, text)."""
    rows = {}
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        if not line or line.startswith("#"):
            continue
        match = re.fullmatch(r"(\S+)  ([\w* ]+?)  ([=-]) (.+)", line)
        assert match, line
        for name in match[2].split():
            rows.setdefault((match[1], name), (match[3], match[4]))
    return rows


def names_of_the_package() -> Set[str]:
    names = set(graze.__all__)
    for name in graze.__all__:
        value = getattr(graze, name)
        if isinstance(value, type):
            names |= {member for member in dir(value) if not member.startswith("_")}
    return names


DECLARED, ROWS, NAMES = declared(), table(), names_of_the_package()


def row_of(header: str, name: str) -> Any:
    folders = ["/".join(header.split("/")[: i + 1]) + "/" for i in range(header.count("/"))]
    for place in (header, *reversed(folders)):
        for word in (name, "*"):
            if (place, word) in ROWS:
                return (place, word)
    return None


def test_each_function_of_the_library_has_a_binding_or_a_reason():
    assert len(DECLARED) > 300 and ("engine/world/world.h", "find_closest_pair") in DECLARED
    missing = []
    for header, name in DECLARED:
        owner = OWNERS.get(header)
        is_bound = hasattr(owner, name) if owner else name in NAMES
        if not is_bound and row_of(header, name) is None:
            missing.append(f"{header}: {name}()")
    assert not missing, "no binding, and no line in not_bound.txt:\n" + "\n".join(missing)


@pytest.mark.parametrize("row", [row for row, (kind, _) in ROWS.items() if kind == "="], ids=str)
def test_what_the_table_names_is_there(row):
    value: Any = graze
    for part in ROWS[row][1].split("."):
        value = getattr(value, part)


def test_no_line_of_the_table_is_of_nothing():
    used = {row_of(header, name) for header, name in DECLARED}
    unused = [f"{place}  {name}" for place, name in ROWS if (place, name) not in used]
    assert not unused, "of nothing that is declared: " + ", ".join(unused)
