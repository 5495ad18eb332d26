"""Runs commands of pages, and says in what they are not as the table says."""

import json
import os
import re
import subprocess

# Files under the names that the pages use, and which of data/ they are.
MESHES = {"bolt.obj": "meshes/bolt.obj", "nut.stl": "meshes/nut.stl", "gear.ply": "meshes/gear.ply",
          "pinion.off": "meshes/pinion.off", "scene.json": "scenes/shapes.json",
          "odd.json": "regressions/triangles-01.json"}


class Runner:
    """Commands run in `scratch`, which looks like the checkout, but for what is written."""

    def __init__(self, root, build, scratch):
        self.root, self.build, self.scratch = root, build, scratch
        (scratch / "build").mkdir()
        (scratch / "build/release").symlink_to(build)
        for name in ("data", "samples", "tests"):
            if (root / name).exists():
                (scratch / name).symlink_to(root / name)
        for name, file in MESHES.items():
            if (root / "data" / file).exists():
                (scratch / name).symlink_to(root / "data" / file)
        poses = root / "data/poses/bolt-nut.cross.txt"
        if poses.exists():
            lines = poses.read_text(encoding="utf-8").splitlines(keepends=True)
            for name in ("poses.txt", "path.txt"):
                (scratch / name).write_text("".join(lines[:2] + lines[-1:]), encoding="utf-8")

    def run(self, line, folder=None, timeout=240):
        environment = dict(os.environ, LC_ALL="C", PATH=f"{self.build / 'bin'}:{os.environ['PATH']}")
        return subprocess.run(["bash", "-c", line], cwd=folder or self.scratch, env=environment, timeout=timeout,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)

    def helps(self):
        """`graze --help`, and that of each subcommand that it names, by what prints it."""
        text = self.run("graze --help").stdout
        helps = {"graze --help": text}
        listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
        for row in listed.group(1).splitlines() if listed else []:
            name = row.split()[0]
            helps[f"graze {name} --help"] = self.run(f"graze {name} --help").stdout
        return helps

    def breaches_of(self, entry):
        line = entry["line"]
        for before, after in entry.get("small", {}).items():
            if before not in line:
                return [f"`{line}`: has no '{before}' to make smaller"]
            line = line.replace(before, after)
        for earlier in entry.get("before", []):
            made = self.run(earlier)
            if made.returncode != 0:
                return [f"`{earlier}`, before `{line}`: exit code {made.returncode}: {made.stderr.strip()}"]
        return list(self._differences(f"`{line}`", self.run(line), entry))

    def breaches_of_program(self, program, entry):
        (self.scratch / "block").write_text(program, encoding="utf-8")
        return list(self._differences(f"{entry['on']}: `{entry['run']}`", self.run(entry["run"]), entry))

    def breaches_of_turn(self, line, entry):
        return list(self._differences(f"`{line}`", self.run(line, folder=self.root, timeout=900), entry))

    def _differences(self, what, result, entry):
        wanted = entry.get("exit", 0)
        if result.returncode != wanted:
            last = (result.stderr.strip() or result.stdout.strip()).splitlines()[-1:]
            yield f"{what}: exit code {result.returncode}, not {wanted}: {' '.join(last)}"
            return
        for pattern in entry.get("out", []):
            if not re.search(pattern, result.stdout, re.MULTILINE):
                yield f"{what}: no line of the output is like '{pattern}'"
        if "json" in entry:
            yield from self._json_differences(what, result.stdout, entry)
        for name in entry.get("writes", []):
            if not (self.scratch / name).exists():
                yield f"{what}: wrote no {name}"

    @staticmethod
    def _json_differences(what, text, entry):
        lines = text.splitlines()
        if not lines:
            yield f"{what}: printed nothing"
        for number, line in enumerate(lines, 1):
            is_last = number == len(lines) and "last" in entry
            wanted = entry["last"] if is_last else entry["json"]
            keys = list(json.loads(line))
            if keys != wanted:
                yield f"{what}: line {number} has the keys {keys}, not {wanted}"
                return


def benchmark_breaches(root, line):
    """tests/benchmark/run says what it would run: each option must be one that the program reads."""
    commands = [line]
    if line.startswith("tests/benchmark/run"):
        result = subprocess.run(["bash", "-c", line + " --print"], cwd=root, capture_output=True, text=True, check=False)
        commands = result.stdout.splitlines()
        if result.returncode != 0 or not commands:
            return [f"`{line} --print`: exit code {result.returncode}: {result.stderr.strip()}"]
    breaches = []
    for command in commands:
        program, *words = command.split()
        if program == "/usr/bin/python3":
            if not (root / words[0]).exists():
                breaches.append(f"`{line}`: there is no {words[0]}")
            continue
        name = program.rsplit("/", 1)[-1]
        if not name.startswith(("graze_benchmark_", "graze_stress_report")):
            continue
        folder = root / "tests/benchmark" / ("stress" if name == "graze_stress_report" else name[len("graze_benchmark_"):])
        sources = "".join(path.read_text(encoding="utf-8") for path in folder.glob("*.cpp"))
        breaches += [f"`{line}`: {program} knows no {word}" for word in words
                     if word.startswith("--") and f'"{word}"' not in sources]
    return breaches


def key_paths(value, path=""):
    """The names of all members, wherever they are."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield f"{path}/{key}"
            yield from key_paths(inner, f"{path}/{key}")
    elif isinstance(value, list):
        for inner in value:
            yield from key_paths(inner, path)


def shape_breaches(root, entry):
    """What a quick run writes has the members of what the pages' figures were taken from."""
    breaches = []
    for name in entry.get("like", []):
        quick, kept = root / "build/benchmark" / name, root / "data/benchmark" / name
        if not quick.exists():
            breaches.append(f"`{entry['as']}` wrote no {name}")
            continue
        found, wanted = (set(key_paths(json.loads(path.read_text(encoding="utf-8")))) for path in (quick, kept))
        breaches += [f"`{entry['as']}`: {name} has no {path}, as data/benchmark/{name} has"
                     for path in sorted(wanted - found) if not re.search(entry.get("but", "^$"), path)]
    return breaches
