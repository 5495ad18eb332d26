"""Builds the module by CMake and puts it, with the libraries that it needs, into the wheel.

The whole tree of graze has to be there: a wheel is built from it, not from a source distribution. GRAZE_BUILD_FOLDER
names a folder of the tree to build in; one that is configured already stays as it is.
"""

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface

OFF = ("CLI", "TESTS", "BENCHMARKS", "SAMPLES")


def tree_of(folder: str) -> Path:
    root = Path(folder).resolve().parent.parent
    if not (root / "engine" / "version.h").is_file():
        raise SystemExit(f"{folder}: a wheel of graze is built within its source tree, which is not here")
    return root


class Version(MetadataHookInterface):  # type: ignore[misc]
    """The version is said once, in the header that programs read."""

    def update(self, metadata: Dict[str, Any]) -> None:
        header = (tree_of(self.root) / "engine" / "version.h").read_text(encoding="utf-8")
        metadata["version"] = ".".join(re.findall(r"kVersion(?:Major|Minor|Patch) = (\d+)", header))


class Module(BuildHookInterface):  # type: ignore[misc]
    """The compiled part of the package."""

    def initialize(self, version: str, build_data: Dict[str, Any]) -> None:
        root = tree_of(self.root)
        folder = root / (os.environ.get("GRAZE_BUILD_FOLDER") or "build/wheel")
        if not (folder / "CMakeCache.txt").is_file():
            settings = [f"-DGRAZE_BUILD_{name}=OFF" for name in OFF]
            settings += ["-DGRAZE_WITH_FCL=OFF", "-DGRAZE_WITH_VIEW=OFF", "-DGRAZE_WITH_RECORD=OFF", "-DGRAZE_WITH_REFEREE=OFF", "-DGRAZE_INSTALL=OFF"]
            settings += ["-DGRAZE_BUILD_PYTHON=ON", f"-DGRAZE_PYTHON={sys.executable}", "-DCMAKE_BUILD_TYPE=Release"]
            subprocess.run(["cmake", "-S", root, "-B", folder, "-G", "Ninja", *settings], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "graze_python"], check=True)
        build_data["pure_python"] = False
        build_data["infer_tag"] = True
        for file in sorted((folder / "python" / "graze").glob("*.so*")):
            build_data["force_include"][str(file)] = f"graze/{file.name}"
