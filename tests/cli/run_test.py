"""velum-batch run and help: scripts without a window."""
import json
import unittest

from velum_cli import CliTest


class Run(CliTest):
    def script(self, *lines):
        path = self.folder / "script.txt"
        path.write_text("\n".join(lines) + "\n")
        return path

    def test_a_script_opens_cuts_saves_and_draws(self):
        path = self.sample()
        labels = self.folder / "two-spheres_labels.seg.nrrd"
        script = self.script("# a comment", "", f"open {path}", f"add {labels}", "cut.add plane name=front", "set rayCast.samplesPerPixel 1",
                             "structure.spare \"upper sphere\"", "cut.flip front", "undo", "save s.json", "picture 48x36 p.png")
        self.run_batch("run", script)
        scene = json.loads((self.folder / "s.json").read_text())
        self.assertEqual([cut["name"] for cut in scene["cuts"]], ["front"])
        self.assertEqual(len(scene["cuts"][0]["spares"]), 1)
        # The same bytes as by the verb.
        self.run_batch("render", "s.json", "-o", "q.png", "--size", "48x36")
        self.assertEqual((self.folder / "p.png").read_bytes(), (self.folder / "q.png").read_bytes())

    def test_films_are_those_of_the_verb(self):
        path = self.sample()
        self.run_batch("run", self.script("cut.add plane", "set cuts[0].face section", "set rayCast.samplesPerPixel 1", "set timeline.framesPerSecond 4",
                                          "film.turn 1", "save s.json", "film.save mine.gif 48x36", "film.save one/ 48x36 part=2/4 blur=2"), path)
        self.run_batch("film", "s.json", "-o", "theirs.gif", "--size", "48x36")
        self.run_batch("film", "s.json", "-o", "two/", "--size", "48x36", "--part", "2/4", "--blur", "2")
        for mine, theirs in (("mine.gif", "theirs.gif"), ("one/frame-00001.png", "two/frame-00001.png")):
            self.assertEqual((self.folder / mine).read_bytes(), (self.folder / theirs).read_bytes(), mine)
        self.assertIn(b"timeline.duration", self.run_batch("run", self.script("film.save a.gif seconds=3"), "s.json", code=1).stderr)

    def test_a_film_says_what_does_not_fit_also_where_it_fails(self):
        path = self.sample()
        (self.folder / "out/frame-00001.png/in the way").mkdir(parents=True)
        lost = 'set timeline.tracks.+ {"path":"cuts[#9].centre","keys":[{"time":0,"value":[0,0,0]}]}'
        film = ["set timeline.framesPerSecond 4", "film.turn 1", lost]
        said = self.run_batch("run", self.script(*film, "film.save out/ 48x36 samples=1"), path, code=2).stderr.decode().splitlines()
        self.assertTrue(said[-2].startswith("warning: timeline: "), said)
        self.assertIn("script.txt:4: 1 of 4 frames could not be drawn: 1 (", said[-1])
        said = self.run_batch("run", self.script(*film, "film.save whole/ 48x36 samples=1"), path).stderr.decode().splitlines()
        self.assertEqual(len([line for line in said if line.startswith("warning: timeline: ")]), 1, said)

    def test_sheets_come_to_rest_as_by_the_verb(self):
        path = self.sample()
        self.run_batch("run", self.script("cut.add membrane", "set rayCast.samplesPerPixel 1", "save s.json", "picture 48x36 p.png"), path)
        self.run_batch("render", "s.json", "-o", "q.png", "--size", "48x36")
        self.assertEqual((self.folder / "p.png").read_bytes(), (self.folder / "q.png").read_bytes())

    def test_the_commands_so_far_are_a_script(self):
        path = self.sample()
        first = self.script(f"open {path}", "cut.add box", "set camera.eye 1,2,3", "look.mode mip", "save a.json", "commands")
        second = self.folder / "again.txt"
        second.write_bytes(self.run_batch("run", first).stdout + b"save b.json\n")
        self.run_batch("run", second)
        self.assertEqual((self.folder / "a.json").read_bytes(), (self.folder / "b.json").read_bytes())

    def test_answers_go_to_stdout(self):
        path = self.sample()
        done = self.run_batch("run", self.script("set rayCast.mode mip", "get rayCast.mode", "get volume.visible"), path)
        self.assertEqual(done.stdout.decode().splitlines(), ["mip", "true"])

    def test_refusals_name_the_line(self):
        path = self.sample()
        for lines, code, word in ((["sing"], 1, "script.txt:1: 'sing' is no command"), (["", "open /nowhere/a.nrrd"], 2, "script.txt:2:"),
                                  (["cut.remove"], 1, "there is no cut"), (["set camera.eye 4"], 1, "camera.eye"), (["undo"], 2, "nothing to undo"),
                                  (["picture 48x36 /nowhere/p.png"], 2, "/nowhere"), (["picture 48 p.png"], 1, "48")):
            with self.subTest(lines=lines):
                self.refuse("run", self.script(*lines), *([] if "open" in lines[-1] else [path]), code=code, words=[word])
        self.refuse("run", "gone.txt", code=2, words=["gone.txt"])

    def test_help_tells_of_each_command(self):
        names = [line.split()[0] for line in self.run_batch("help").stdout.decode().splitlines()[:-1]]
        self.assertIn("structure.show", names)
        for name in names:
            self.assertIn("e.g. " + name, self.run_batch("help", name).stdout.decode())
        self.refuse("help", "structure.shwo", code=1, words=["structure.show"])


if __name__ == "__main__":
    unittest.main()
