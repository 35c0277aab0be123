"""A copy of the working tree: built with a bug, tried, and made good again."""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys

from table import ROOT, cli_file, fail, hash_of, target_of

ITSELF = "the program itself"  # failed, and named no test


class Tree:
    def __init__(self, place, cores):
        self.tree, self.clean, self.cores = place / "tree", place / "clean", cores
        self.build = self.tree / "build" / "dev"
        self.digests, self.confirmed = {}, set()
        self.process, self.is_stopped = None, False
        self.environment = dict(os.environ, CCACHE_BASEDIR=str(self.tree), CCACHE_NOHASHDIR="1",
                                PYTHONDONTWRITEBYTECODE="1")
        self.environment.pop("VELUM_TEST_DATA", None)  # laws need no data from elsewhere

    def sync(self):
        """Makes the copy the same as the working tree; what a run that was killed has left planted goes, too."""
        listing = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                 capture_output=True, check=True).stdout
        wanted = {name.decode() for name in listing.split(b"\0") if name and (ROOT / name.decode()).is_file()}
        for name in wanted:
            source, target = ROOT / name, self.tree / name
            if not target.is_file() or target.read_bytes() != source.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)
                shutil.copymode(source, target)
        for folder, folders, names in os.walk(self.tree):
            if pathlib.Path(folder) == self.tree:
                folders[:] = [f for f in folders if f != "build"]
            for name in names:
                path = pathlib.Path(folder) / name
                if path.relative_to(self.tree).as_posix() not in wanted:
                    path.unlink()

    def run(self, command, limit=None):
        """@return exit code, or None when the time was over; output"""
        if self.is_stopped:
            fail("stopped")
        with subprocess.Popen(command, cwd=self.tree, env=self.environment, text=True, errors="replace",
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True) as self.process:
            try:
                output, _ = self.process.communicate(timeout=limit)
                return self.process.returncode, output
            except subprocess.TimeoutExpired:
                self.kill()
                return None, self.process.communicate()[0]
            except BaseException:
                self.kill()
                raise

    def kill(self):
        """What runs, a display and what is shown on it, too."""
        if self.process and self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)

    def stop(self):
        """From another thread: nothing is to be run any more."""
        self.is_stopped = True
        self.kill()

    def make(self, targets):
        if not (self.build / "build.ninja").is_file():
            code, output = self.run(["cmake", "--preset", "dev"])
            if code:
                fail(f"cmake failed:\n{output[-3000:]}")
        code, output = self.run(["nice", "ninja", "-C", str(self.build), "-j", str(self.cores), *sorted(targets)])
        return code == 0, output

    def program(self, target):
        return self.build / ("bin" if target == "velum-batch" else "tests") / target

    def digest(self, target):
        """Of a program's code and data, whatever is known of its lines."""
        bare = self.clean / "bare"
        subprocess.run(["strip", "-g", "-R", ".note.gnu.build-id", "-o", bare, self.program(target)], check=True)
        return hash_of(bare.read_bytes())

    def make_clean(self, targets):
        """The programs without a bug: what they are like, and to ask whether a test fails by itself."""
        built, output = self.make(targets)
        if not built:
            fail(f"the tree does not build:\n{output[-3000:]}")
        self.clean.mkdir(parents=True, exist_ok=True)
        for target in targets:
            self.digests[target] = self.digest(target)
            shutil.copy2(self.program(target), self.clean / target)

    def check_names(self, suites):
        """A filter that chooses no test is a mistake in a table; it is said before hours are spent."""
        for suite in (s for s in suites if ":" in s):
            target, wanted = suite.split(":", 1)
            command = [str(self.program(target)), "--gtest_list_tests", "--gtest_filter=" + wanted]
            if target == "window-test":
                command = ["env", "QT_QPA_PLATFORM=offscreen", *command]
            if not re.search(r"^  \S", self.run(command)[1], re.MULTILINE):
                fail(f"{suite}: no test is called so")

    def failures_of(self, suite, limit, folder=None, test=None):
        """@param folder  of the program; None: where it is built  @return names of what failed; empty: nothing did"""
        target = target_of(suite)
        program = (folder or self.program(target).parent) / target
        if suite.startswith("cli."):
            self.environment["VELUM_BATCH"] = str(program)
            code, _ = self.run([sys.executable, str(cli_file(self.tree, suite))], limit)
            return [] if code in (0, 77) else [suite]
        command = [str(program), "--gtest_fail_fast"]
        if test or ":" in suite:
            command.append("--gtest_filter=" + (test or suite.split(":", 1)[1]))
        if target == "window-test":
            command = ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24", *command]
        code, output = self.run(command, limit)
        if code == 0 and "Running 0 tests" in output:
            fail(f"{suite} {test or ''}: no test is called so")
        return [] if code == 0 else names_in(output, code)

    def confirm(self, suite, failed):
        """A test that fails without the bug sees nothing."""
        for test in (name.split(" ")[0] for name in failed if name != ITSELF):
            if test in self.confirmed:
                continue
            if self.failures_of(suite, 1200, self.clean, test):
                fail(f"{test} fails without any bug planted: mend that first")
            self.confirmed.add(test)

    def try_mutant(self, mutant, limit):
        """@return what came of it, and the tests that saw it"""
        path = self.tree / mutant["file"]
        good = path.read_text()
        targets = {target_of(suite) for suite in mutant["suites"]}
        try:
            path.write_text(good.replace(mutant["old"], mutant["new"]))
            if not self.make(targets)[0]:
                return "not built", []
            if all(self.digest(target) == self.digests[target] for target in targets):
                return "no effect", []
            # Pictures see much and say little: last.
            for suite in sorted(mutant["suites"], key=lambda s: target_of(s) == "golden-test"):
                if failed := self.failures_of(suite, limit):
                    self.confirm(suite, failed)
                    return "pictures" if target_of(suite) == "golden-test" else "killed", failed
            return "survived", []
        finally:
            path.write_text(good)


def names_in(output, code):
    """Of the tests that failed; of the one that was running where the program did not come to its end."""
    names = re.findall(r"^\[  FAILED  \] ([\w/]+\.[\w/]+)", output, re.M)
    if not names and (last := re.findall(r"^\[ RUN      \] (\S+)", output, re.M)):
        names = [f"{last[-1]} ({'hung' if code is None else 'crashed'})"]
    return list(dict.fromkeys(names))[:3] or [ITSELF]
