"""What the package says of itself: docstrings whose examples run, types that hold, a file for each name."""

import doctest
import importlib
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import graze
import graze.trimesh
import numpy as np
import pytest
from conftest import MESHES, SOURCES, translation

MODULES = [graze, graze.trimesh]
NAMES = [(module, name) for module in MODULES for name in module.__all__ if name != "__version__"]


@pytest.mark.parametrize("module, name", NAMES)
def test_each_name_has_a_docstring_and_its_examples_hold(module, name, bolt, nut):
    text = inspect.getdoc(getattr(module, name))
    assert text and text[-1] in ".:)" or ">>>" in text
    known = {"graze": graze, "np": np, "bolt": bolt, "nut": nut, "pose": translation(0, 0, 0.002)}
    known.update(far=translation(1, 0, 0), raised=translation(0, 0, 1.5))
    test = doctest.DocTestParser().get_doctest(text, known, name, None, 0)
    said = []
    failed, _ = doctest.DocTestRunner(optionflags=doctest.IGNORE_EXCEPTION_DETAIL).run(test, out=said.append)
    assert failed == 0, "".join(said)


def test_the_page_of_the_package_holds(bolt, nut):
    known = {"graze": graze, "np": np, "bolt": bolt, "nut": nut, "pose": translation(0, 0, 0.002)}
    test = doctest.DocTestParser().get_doctest(graze.__doc__, known, "graze", None, 0)
    failed, tried = doctest.DocTestRunner().run(test)
    assert failed == 0 and tried > 0


@pytest.mark.parametrize("type", [value for value in vars(graze).values() if isinstance(value, type)])
def test_each_member_has_a_docstring(type):
    for name, member in vars(type).items():
        if name.startswith("_") or hasattr(type, "_fields") and name in type._fields:
            continue
        if type is not graze.Work:
            assert inspect.getdoc(member), f"{type.__name__}.{name}"


def run(*command):
    environment = {**os.environ, "MYPYPATH": str(Path(graze.__file__).parents[1])}
    done = subprocess.run([sys.executable, *command], capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.outside
def test_the_stub_is_of_the_module(tmp_path):
    pytest.importorskip("mypy")
    allowed = SOURCES / "engine" / "python" / "stubtest_allowlist.txt"
    run("-m", "mypy.stubtest", "graze._graze", "--allowlist", str(allowed), "--ignore-unused-allowlist")


@pytest.mark.outside
def test_the_package_and_the_samples_have_types_that_hold(tmp_path):
    pytest.importorskip("mypy")
    samples = sorted(map(str, (SOURCES / "samples" / "python").glob("*.py")))
    assert samples
    run("-m", "mypy", "--strict", "--cache-dir", str(tmp_path), "-p", "graze")
    run("-m", "mypy", "--strict", "--cache-dir", str(tmp_path), *samples)


@pytest.mark.parametrize("page", ["README.md", "engine/python/README.md"])
def test_the_programs_of_the_pages_run(page, bolt, nut, tmp_path, monkeypatch):
    for name in ("bolt.obj", "nut.stl"):
        (tmp_path / name).symlink_to(MESHES / name)
    monkeypatch.chdir(tmp_path)
    programs = re.findall(r"^```python\n(.*?)^```$", (SOURCES / page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert programs
    known = {"graze": graze, "np": np, "bolt": bolt, "nut": nut, "pose": translation(0, 0, 0.002)}
    known["poses"] = np.stack([translation(0, 0, 0.002), translation(1, 0, 0)])
    for program in programs:
        exec(program, known)
    assert known.get("hits", [True, False])[0]


@pytest.mark.slow
def test_a_wheel_needs_nothing_but_numpy(tmp_path):
    """Built by pip, as it is at its users', and found in another place than the build tree."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}

    def call(*command):
        done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=tmp_path, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    call(sys.executable, "-m", "venv", "--system-site-packages", "venv")
    python = str(tmp_path / "venv" / "bin" / "python")
    settings = ["--disable-pip-version-check", "--no-build-isolation", "--no-deps", "--no-index"]
    call(python, "-m", "pip", "install", *settings, str(SOURCES / "engine" / "python"))
    where = call(python, "-c", "import graze; print(graze.__file__)").strip()
    package = Path(where).parent
    assert tmp_path in package.parents
    needed = call("ldd", str(next(package.glob("_graze*.so"))))
    ours = re.findall(r"lib(?:tbb|ccd|hwy)\S* => (\S+)", needed)
    assert len(ours) >= 3 and all(str(package) in path for path in ours) and "not found" not in needed
    metadata = call(python, "-m", "pip", "show", "--verbose", "graze")
    assert "Requires: numpy" in metadata
    assert "5858 of 10000 poses touch" in call(python, str(SOURCES / "samples" / "python" / "first_steps.py"))


@pytest.mark.outside
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("sample", sorted((SOURCES / "samples" / "python").glob("*.py")), ids=lambda path: path.name)
def test_the_samples_run(sample):
    run(str(sample))


@pytest.mark.outside
def test_a_part_of_a_sweep_is_asked_by_its_number(bolt, nut, tmp_path):
    """As a task of Slurm or a pod of Kubernetes asks: by the line that the page has for both."""
    page = (SOURCES / "samples" / "python" / "at_scale.md").read_text(encoding="utf-8")
    lines = re.findall(r"python3 (part_of_sweep.py .*poses.npy) (\S+) 100", page)
    assert [number.strip('"') for _, number in lines] == ["$SLURM_ARRAY_TASK_ID", "$JOB_COMPLETION_INDEX"]
    poses = np.stack([translation(0, 0, 0.002), translation(1, 0, 0), translation(0, 0, 0.002)] * 3)
    np.save(tmp_path / "poses.npy", poses)
    for part in range(4):
        run(str(SOURCES / "samples" / "python" / "part_of_sweep.py"), str(tmp_path / "poses.npy"), str(part), "4")
    hits = np.concatenate([np.load(tmp_path / f"hits.{part:05}.npy") for part in range(4)])
    assert np.array_equal(hits, graze.intersects(bolt, (nut, poses))) and hits.sum() == 6


def test_all_names_are_listed():
    public = {name for name, value in vars(graze).items() if not name.startswith("_") and not inspect.ismodule(value)}
    assert public == set(graze.__all__) - {"__version__"}
    assert importlib.import_module("graze").__version__ == graze.__version__
