"""Exit codes and errors of the command line itself."""
import json
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

from velum_cli import PROGRAM, CliTest

WINDOW_COMPLETIONS = pathlib.Path(__file__).parents[2] / "resources/completions"

VERBS = ["info", "render", "film", "bench", "compare", "sample", "convert", "view"]


class Usage(CliTest):
    def test_wrong_command_lines_exit_1_with_one_line(self):
        for arguments in ([], ["paint"], ["info", "--no-such-option"], ["render", "a.nrrd"], ["compare", "one.png"], ["sample"],
                          ["render", "a.nrrd", "-o", "x.png", "--samples", "0"], ["render", "a.nrrd", "-o", "x.png", "--samples", "many"],
                          ["bench", "a.nrrd", "--frames", "0"], ["compare", "a", "b", "--max-diff", "300"],
                          ["render", "a.nrrd", "-o", "x.png", "--context", "vulkan"], ["info"]):
            with self.subTest(arguments=arguments):
                self.refuse(*arguments, code=1)

    def test_an_unknown_verb_is_named_with_the_one_that_is_meant(self):
        self.refuse("rendre", "a.nrrd", code=1, words=["'rendre'", "is 'render' meant?", "compare"])
        self.refuse("paint", code=1, words=["'paint'", "render"])

    def test_help_says_the_exit_codes(self):
        said = self.run_batch("--help").stdout.decode()
        for words in ("Exit codes", "0 ", "1 ", "2 ", "3 ", "4 "):
            self.assertIn(words, said)

    def test_completions_know_every_option_of_every_verb(self):
        table = json.loads(self.run_batch("completion", "bash", "--json").stdout)
        for verb in VERBS:
            options = set(re.findall(r"^ +(?:-\w,)?(--[\w-]+)", self.run_batch(verb, "--help").stdout.decode(), re.M))
            self.assertGreater(len(options), 1, verb)
            self.assertLessEqual(options - {"--help"}, set(table[verb]), verb)
        self.assertEqual(sorted(table["render"]["--context"]), ["auto", "egl", "osmesa"])
        for shell, check in (("bash", ["bash", "-n"]), ("zsh", ["zsh", "-n"]), ("fish", ["fish", "-n"])):
            script = self.run_batch("completion", shell).stdout
            self.assertIn(b"--size" if shell != "fish" else b"-l size", script)
            if shutil.which(check[0]):
                subprocess.run(check, input=script, check=True, timeout=60)
        # What a shell makes of it.
        script = self.run_batch("completion", "bash").stdout.decode()
        for words, at, wanted in (("ren", 1, ["render"]), ("render --sam", 2, ["--samples"]), ("info --context e", 3, ["egl"])):
            done = subprocess.run(["bash", "-c", script + f'COMP_WORDS=(velum-batch {words}); COMP_CWORD={at}; _velum_batch; '
                                   'printf "%s\\n" "${COMPREPLY[@]}"'], capture_output=True, timeout=60)
            self.assertEqual(done.stdout.decode().split(), wanted, done.stderr)

    def typed_in_zsh(self, setup, keys, wanted):
        """What a fresh zsh shows after lines of setup and keys, as soon as it shows what is wanted."""
        process, terminal = pty.fork()
        if process == 0:
            os.environ.update(PS1="> ", TERM="dumb", HOME=str(self.folder), ZDOTDIR=str(self.folder))
            os.chdir(self.folder)
            os.execlp("zsh", "zsh", "-f", "-i")
        said, end = "", time.monotonic() + 30
        try:
            # The ready mark is put together by the shell, as what is typed is shown, too.
            os.write(terminal, f"{setup}; print re''ady\n".encode())
            typed = False
            while time.monotonic() < end and not (typed and wanted in said):
                if select.select([terminal], [], [], 0.1)[0]:
                    said += os.read(terminal, 4096).decode(errors="replace")
                if not typed and "ready\r\n" in said:
                    typed, said = True, ""
                    os.write(terminal, keys.encode())
            return said
        finally:
            os.kill(process, 9)
            os.waitpid(process, 0)
            os.close(terminal)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_completes_at_the_first_tab_however_it_learns_it(self):
        functions = self.folder / "functions"
        functions.mkdir()
        (functions / "_velum-batch").write_bytes(self.run_batch("completion", "zsh").stdout)
        shutil.copy(WINDOW_COMPLETIONS / "_velum", functions)
        loaded = f"fpath=({functions} $fpath); autoload -U compinit; compinit -D -u"
        told = f"autoload -U compinit; compinit -D -u; eval \"$({PROGRAM} completion zsh)\""
        for setup in (loaded, told):
            for keys, wanted in (("velum-batch rend\t", "velum-batch render "), ("velum-batch render --sam\t", "--samples"),
                                 ("velum-batch info --context e\t", "--context egl")):
                with self.subTest(setup=setup, keys=keys):
                    self.assertIn(wanted, self.typed_in_zsh(setup, keys, wanted))
        self.assertIn("--screenshot", self.typed_in_zsh(loaded, "velum --scr\t--sh\t", "--screenshot"))

    def test_completions_of_the_window_know_its_options(self):
        help = subprocess.run([os.environ["VELUM"], "--help"], capture_output=True, timeout=60).stdout.decode()
        options = set(re.findall(r"^ +(?:-\w, )?(--[\w-]+)", help, re.M))
        self.assertGreater(len(options), 5)
        for name, form in (("velum.bash", r"--[a-z-]+(?=[ '])"), ("_velum", r"--[a-z-]+(?=[}\[])"), ("velum.fish", r"-l [a-z-]+")):
            text = (WINDOW_COMPLETIONS / name).read_text()
            told = set(re.findall(form, "\n".join(line for line in text.splitlines() if not line.startswith("#") and "    --lang" not in line)))
            self.assertEqual({word.replace("-l ", "--") for word in told}, options, name)
        script = (WINDOW_COMPLETIONS / "velum.bash").read_text()
        for words, at, wanted in (("--scr", 1, ["--screenshot", "--script"]), ("--language d", 2, ["de"])):
            done = subprocess.run(["bash", "-c", script + f'COMP_WORDS=(velum {words}); COMP_CWORD={at}; _velum; '
                                   'printf "%s\n" "${COMPREPLY[@]}"'], capture_output=True, timeout=60)
            self.assertEqual(done.stdout.decode().split(), wanted, done.stderr)
        for shell, name in (("fish", "velum.fish"), ("zsh", "_velum")):
            if shutil.which(shell):
                subprocess.run([shell, "-n", WINDOW_COMPLETIONS / name], check=True, timeout=60)

    def test_data_comes_from_standard_input(self):
        path = self.sample()
        wanted = self.report("info", path)
        with open(path, "rb") as data:
            done = subprocess.run([os.environ["VELUM_BATCH"], "info", "-", "--json"], stdin=data, capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        got = json.loads(done.stdout)
        self.assertEqual({**got, "name": ""}, {**wanted, "name": ""})
        piped = subprocess.run(["sh", "-c", f"cat {path} | {os.environ['VELUM_BATCH']} convert - out.nii.gz"], cwd=self.folder,
                               capture_output=True, timeout=60)
        self.assertEqual(piped.returncode, 0, piped.stderr)
        self.assertEqual(self.report("info", "out.nii.gz")["dims"], wanted["dims"])
        for arguments, code in ((["info", "-"], 2), (["render", "-", "-o", "a.png", "--save-scene", "a.json"], 1)):
            empty = subprocess.run([os.environ["VELUM_BATCH"], *arguments], stdin=subprocess.DEVNULL, cwd=self.folder,
                                   capture_output=True, timeout=60)
            self.assertEqual(empty.returncode, code, empty.stderr)
            self.assertIn(b"standard input", empty.stderr)

    def test_help_and_version_exit_0(self):
        self.assertIn(b"render", self.run_batch("--help").stdout)
        self.assertRegex(self.run_batch("--version").stdout, rb"\d+\.\d+\.\d+")
        for verb in VERBS:
            self.assertIn(b"--json", self.run_batch(verb, "--help").stdout, verb)

    def test_the_window_says_its_options_without_a_display(self):
        away = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "QT_QPA_PLATFORM": "xcb"}
        for option, word in (("--help", b"--screenshot"), ("--version", b"velum")):
            done = subprocess.run([os.environ["VELUM"], option], capture_output=True, timeout=60, env={**os.environ, **away})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(word, done.stdout)

    def test_a_missing_input_exits_2_and_is_named(self):
        for verb in (["info"], ["render", "-o", "x.png"], ["bench"], ["convert"]):
            with self.subTest(verb=verb):
                more = ["out.nrrd"] if verb == ["convert"] else []
                self.refuse(verb[0], "none.nrrd", *more, *verb[1:], code=2, words=["none.nrrd"])

    def test_sizes_views_and_presets_that_are_none_exit_1(self):
        path = self.sample()
        for size in ("0x0", "10", "axb", "-5x5", "10x10x10", "99999x2", "10x"):
            self.refuse("render", path, "-o", "x.png", "--size", size, code=1, words=[size, "WIDTHxHEIGHT"])
        self.refuse("render", path, "-o", "x.png", "--section", "oblique", code=1, words=["oblique", "coronal"])
        self.refuse("render", path, "-o", "x.png", "--section", "axial", "--layers", code=1, words=["--layers"])
        self.refuse("render", path, "-o", "x.png", "--view", "front", code=1, words=["front", "anterior"])
        self.refuse("render", path, "-o", "x.png", "--preset", "bones", code=1, words=["bones", "ct-bone"])

    def test_wrong_transfer_files_exit_2_and_are_named(self):
        path = self.sample()
        (self.folder / "bad.vp").write_text("1\n2\n")
        (self.folder / "bad.velum-transfer.json").write_text('{"velumTransfer": 1, "opacities": 5}')
        for name, word in (("bad.vp", "9 lines"), ("bad.velum-transfer.json", "opacities"), ("none.vp.json", "No such file"),
                           ("two-spheres.nrrd", ".vp")):
            with self.subTest(name=name):
                self.refuse("render", path, "-o", "x.png", "--transfer", name, code=2, words=[name, word])
        self.refuse("convert", path, "out.vp", code=2, words=["two-spheres.nrrd", "neither a scene"])
        self.refuse("convert", "bad.vp", "out.vp.json", code=2, words=["bad.vp"])
        self.assertFalse((self.folder / "out.vp").exists())

    def test_set_errors_name_path_value_and_choices(self):
        path = self.sample()
        for change, words in (("rayCast.mode=cube", ["rayCast.mode", "cube", "mip"]), ("rayCats.mode=mip", ["rayCats", "rayCast"]),
                              ("rayCast.stepVoxels=99", ["rayCast.stepVoxels", "99"]), ("rayCast", ["rayCast", "path=value"]),
                              ("camera.eye=1,2", ["camera.eye"]), ("=5", ["camera"]), ("cuts.7.shape=box", ["cuts", "7"])):
            with self.subTest(change=change):
                self.refuse("render", path, "-o", "x.png", "--set", change, code=1, words=words)
        self.assertFalse((self.folder / "x.png").exists())

    def test_streams_that_take_nothing_are_no_crash(self):
        """A disk that is full under stdout is an error; under stderr it changes nothing; nor do streams that are closed."""
        path = self.sample()
        program = os.environ["VELUM_BATCH"]
        for command, code in (("info {path} >/dev/full", 2), ("info {path} --json >/dev/full", 2), ("info none 2>/dev/full", 2),
                              ("--no-such-option 2>/dev/full", 1), ("info {path} 2>&-", 0), ("info none 2>&-", 2),
                              ("convert {path} b.nrrd >&- 2>&- <&-", 0)):
            with self.subTest(command=command):
                done = subprocess.run(["sh", "-c", f"exec {program} {command.format(path=path)}"], cwd=self.folder,
                                      capture_output=True, timeout=60)
                self.assertEqual(done.returncode, code, done.stderr)
                if ">/dev/full" in command and code == 2 and "none" not in command:
                    self.assertIn(b"cannot be written", done.stderr)
        self.run_batch("info", "b.nrrd")

    def test_a_wrong_raw_layout_exits_1(self):
        (self.folder / "a.raw").write_bytes(bytes(64))
        for raw in ("4x4", "4x4x4:float16", "0x4x4:uint8", "4x4x4:uint8:+x"):
            with self.subTest(raw=raw):
                self.refuse("info", "a.raw", "--raw", raw, code=1, words=["--raw"])


if __name__ == "__main__":
    unittest.main()
