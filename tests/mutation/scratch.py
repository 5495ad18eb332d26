"""A copy of the tree in which mutants are made, built and tested."""

import pathlib
import re
import resource
import shutil
import subprocess
import sys

from mutants import Mistake

SECONDS_TO_BUILD = 3600
SECONDS_TO_TEST = 120  # of the processor: a busy machine must not kill a mutant
SECONDS_TO_WAIT = 1800

# What makes little to build: no optimiser worth its time, of the SIMD targets the baseline and AVX2 (kernels
# are compiled once for each), programs that are not run to list their tests, no commands, nothing for FCL.
# Headers are not precompiled if a compiler cache is there, to which a change taken back is nothing new.
CHEAP = ["-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1 -DHWY_DISABLED_TARGETS=0x19C0",
         "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST", "-DGRAZE_BUILD_TESTS=ON", "-DGRAZE_BUILD_SAMPLES=OFF",
         "-DGRAZE_BUILD_BENCHMARKS=OFF", "-DGRAZE_BUILD_CLI=OFF", "-DGRAZE_WITH_FCL=OFF", "-DGRAZE_WITH_VIEW=OFF"]
CACHED = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"]


class Scratch:
    """Copies what git knows of, or does not ignore, and keeps what is built from one run to the next."""

    def __init__(self, root, folder):
        self.root = root
        self.tree = folder / "tree"
        self.build = folder / "build"
        self.passed = set()  # tests that pass without a change

    def __enter__(self):
        self.copy_tree()
        self.configure()
        return self

    def __exit__(self, *_):
        return False

    def copy_tree(self):
        """Files that have not changed are left alone, so that ninja does not build them again."""
        listing = subprocess.run(["git", "-C", self.root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                 capture_output=True, text=True, check=True).stdout
        wanted = {name for name in listing.split("\0") if name and (self.root / name).is_file()}
        self.tree.mkdir(parents=True, exist_ok=True)
        for path in [path for path in self.tree.rglob("*") if path.is_file()]:
            if str(path.relative_to(self.tree)) not in wanted:
                path.unlink()
        for name in wanted:
            source, target = self.root / name, self.tree / name
            if target.is_file() and target.read_bytes() == source.read_bytes():
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            shutil.copymode(source, target)

    def configure(self):
        """Operations are not fused, as ever: the project's own lists say so."""
        run = subprocess.run(["cmake", "-G", "Ninja", "-S", self.tree, "-B", self.build, *CHEAP,
                              *(CACHED if shutil.which("ccache") else [])],
                             capture_output=True, text=True, timeout=SECONDS_TO_BUILD, check=False)
        if run.returncode != 0:
            raise Mistake(f"cmake fails:\n{run.stdout[-2000:]}{run.stderr[-2000:]}")

    def check_baseline(self, tests):
        """Without a change they must pass, or they would kill everything. Each is asked once."""
        tests = [test for test in dict.fromkeys(tests) if test not in self.passed]
        if message := self.build_failure(tests):
            raise Mistake(f"the tree does not build:\n{message}")
        for test in tests:
            if killer := self.failing_test(test):
                raise Mistake(f"{killer} fails before any change")
            self.passed.add(test)

    def killer_of(self, mutant):
        """The test that fails with this change; nothing if all pass. What the first kills is not built for the next."""
        path = self.tree / mutant.file
        original = path.read_text(encoding="utf-8")
        changed = mutant.applied_to(original)
        try:
            for test in mutant.tests:
                if test not in self.passed:
                    write_if_other(path, original)
                    self.check_baseline([test])
                write_if_other(path, changed)
                if message := self.build_failure([test]):
                    raise Mistake(f"{mutant.name} does not build:\n{message}")
                if killer := self.failing_test(test):
                    return killer
            return None
        finally:
            write_if_other(path, original)

    def build_failure(self, tests):
        targets = sorted({f"graze_test_{program_of(test)}" for test in tests if not is_proof(test)})
        if not targets:
            return ""
        run = subprocess.run(["cmake", "--build", self.build, "--target", *targets], capture_output=True, text=True,
                             timeout=SECONDS_TO_BUILD, check=False)
        return (run.stdout + run.stderr)[-3000:] if run.returncode != 0 else ""

    def failing_test(self, test):
        return self.failing_proof(test) if is_proof(test) else self.failing_case(test)

    def failing_proof(self, test):
        name = test.partition("/")[2]
        folder = self.tree / "tests" / "proofs"
        run = subprocess.run([sys.executable, folder / "prove", folder / f"{name}.gappa"], capture_output=True, text=True,
                             check=False)
        if run.returncode == 77:
            raise Mistake(f"{test}: gappa is not installed")
        return f"Proofs.{name}" if run.returncode != 0 else None

    def failing_case(self, test):
        program, _, pattern = test.partition(":")
        found = sorted(path for path in self.build.rglob(f"graze_test_{program}") if path.is_file())
        if len(found) != 1:
            raise Mistake(f"{len(found)} programs are called graze_test_{program}")
        log = self.build / f"{program}.log"
        with open(log, "w", encoding="utf-8") as output:
            try:
                code = subprocess.run([found[0], f"--gtest_filter={pattern or '*'}-*Slow.*", "--gtest_fail_fast"],
                                      cwd=found[0].parent, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                      timeout=SECONDS_TO_WAIT, preexec_fn=limit_processor_time, check=False).returncode
            except subprocess.TimeoutExpired:
                raise Mistake(f"{test}: {last_started(log)} takes longer than {SECONDS_TO_WAIT} s") from None
        text = log.read_text(encoding="utf-8", errors="replace")
        if code == 0:
            if not re.search(r"^\[  PASSED  \] [1-9]", text, flags=re.MULTILINE):
                raise Mistake(f"{test}: no test of graze_test_{program} has run")
            return None
        return last_started(log)


def limit_processor_time():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS_TO_TEST, SECONDS_TO_TEST + 10))


def write_if_other(path, text):
    """What has not changed is not built again."""
    if path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def is_proof(test):
    return test.startswith("proof/")


def program_of(test):
    return test.partition(":")[0]


def last_started(log):
    """With --gtest_fail_fast it is the one that failed, or was running when the program died."""
    text = pathlib.Path(log).read_text(encoding="utf-8", errors="replace")
    if failed := re.search(r"^\[  FAILED  \] ([^\s,]+)", text, flags=re.MULTILINE):
        return failed[1]
    started = re.findall(r"^\[ RUN      \] (\S+)", text, flags=re.MULTILINE)
    return f"{started[-1]} (died)" if started else "start of the program"
