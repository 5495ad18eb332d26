"""The list of mutants, and the checks that keep it true to the code."""

import re
from dataclasses import dataclass, field


class Mistake(Exception):
    """The list, the build or a test is not what it should be."""


@dataclass
class Mutant:
    name: str
    line: int
    file: str = ""
    tests: list = field(default_factory=list)
    why: str = ""
    equivalent: str = ""
    original: list = field(default_factory=list)
    replacement: list = field(default_factory=list)

    def applied_to(self, text):
        """Blanks and line breaks match any others, so that formatting does not matter."""
        words = " ".join(self.original).split()
        matches = list(re.finditer(r"\s*".join(re.escape(word) for word in words), text))
        if len(matches) != 1:
            raise Mistake(f"{self.name}: its text stands {len(matches)} times in {self.file}: '{' '.join(words)}'")
        start, end = matches[0].span()
        changed = text[:start] + "\n".join(self.replacement) + text[end:]
        if "".join(changed.split()) == "".join(text.split()):
            raise Mistake(f"{self.name}: changes nothing")
        return changed



def read_mutants(path, root):
    mutants = parse(path.read_text(encoding="utf-8"), path)
    for mutant in mutants:
        check(mutant, root)
    names = [mutant.name for mutant in mutants]
    if twice := {name for name in names if names.count(name) > 1}:
        raise Mistake(f"two mutants are called {', '.join(sorted(twice))}")
    if not mutants:
        raise Mistake(f"{path}: no mutants")
    return mutants


def parse(text, path):
    mutants = []
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith("["):
            mutants.append(Mutant(line.strip("[] "), number))
            continue
        if not mutants:
            raise Mistake(f"{path}:{number}: before the first [name]")
        add_line(mutants[-1], line, f"{path}:{number}")
    return mutants


def add_line(mutant, line, place):
    if line.startswith("- "):
        mutant.original.append(line[2:])
    elif line.startswith("+ ") or line == "+":
        mutant.replacement.append(line[2:])
    elif match := re.match(r"(file|tests|why|equivalent): (.+)$", line):
        setattr(mutant, match[1], match[2].split() if match[1] == "tests" else match[2])
    else:
        raise Mistake(f"{place}: not understood: {line}")


def check(mutant, root):
    for what in ("file", "tests", "why", "original", "replacement"):
        if not getattr(mutant, what):
            raise Mistake(f"{mutant.name}: no {what}")
    path = root / mutant.file
    if not path.is_file():
        raise Mistake(f"{mutant.name}: no file {mutant.file}")
    mutant.applied_to(path.read_text(encoding="utf-8"))
