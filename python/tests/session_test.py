"""Sessions: commands, fields, tables, errors."""
import inspect
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest
import warnings

from support import PROGRAM, ROOT, Case, ball, numpy

import velum
from velum import _velum

SMALL = (96, 72)


class Table(Case):
    def test_every_command_is_a_method_with_its_words(self):
        rows = re.findall(r"^## (\S+)\n\n(.*?) For example: `(.*?)`", (ROOT / "docs/COMMANDS.md").read_text(), re.M)
        self.assertGreater(len(rows), 100)
        self.assertEqual([row["name"] for row in _velum.commands()], [name for name, _, _ in rows])
        session = velum.Session()
        for command in _velum.commands():
            target = session
            for part in command["pythonName"].split("."):
                target = getattr(target, part)
            self.assertIn(command["doc"], target.__doc__)
            names = [name for name in inspect.signature(target).parameters]
            heads = list(dict.fromkeys(row["path"].split(".")[0] for row in command["arguments"]))
            self.assertEqual(names, heads, command["name"])

    def test_examples_are_python_that_says_the_same(self):
        """The example of each command, run in a session that takes down the line, is the line of the table."""
        table = dict(re.findall(r"^## (\S+)\n\n.*? For example: `(.*?)`", (ROOT / "docs/COMMANDS.md").read_text(), re.M))
        session = velum.Session()
        lines = []
        session._do = lines.append
        for command in _velum.commands():
            lines.clear()
            exec(command["example"], {"s": session})
            self.assertEqual(len(lines), 1, command["example"])
            self.assertEqual(_velum.asLine(lines[0]), table[command["name"]])

    def test_arguments_are_taken_by_the_names_that_they_had(self):
        session = velum.Session()
        lines = []
        session._do = lines.append
        session.growth.grow(seeds=[(1, 2, 3)], range=(5, 7))
        session.growth.grow(seed=[(1, 2, 3)], range=(5, 7))
        self.assertEqual(lines[0], lines[1])


class Fields(Case):
    def setUp(self):
        super().setUp()
        self.session = velum.open(ball(), unit="HU")

    def test_values_come_back_as_they_were_set(self):
        for field, value in (("rayCast.mode", "mip"), ("rayCast.stepVoxels", 0.75), ("lighting.shadow", 0.0), ("camera.eye", [1.5, -2.0, 300.0]),
                             ("background.top", [0.1, 0.2, 0.3]), ("volume.bodyOnly", False)):
            self.session[field] = value
            self.assertEqual(numpy.round(self.session[field], 6).tolist() if isinstance(value, list) else self.session[field], value)
        self.session["camera.eye"] = numpy.array([1, 2, 3])
        self.assertEqual(self.session["camera.eye"], [1, 2, 3])
        self.session["camera.eye"] = "4,5,6"
        self.assertEqual(self.session["camera.eye"], [4, 5, 6])

    def test_texts_are_texts_whatever_they_hold(self):
        self.session.cut.add("plane")
        for text in ("my cut", "42", "1,2", "true", "", ' "quoted" ', "a\nb", "[1]", "null", "Schläfenbein", "a=b", "#1", "'", "\\"):
            self.session["cuts.0.name"] = text
            self.assertEqual(self.session["cuts.0.name"], text)
            self.session.cut.rename(str(self.session["cuts.0.id"]), text)
            self.assertEqual(self.session["cuts.0.name"], text.strip())

    def test_parts_are_dictionaries(self):
        self.session.cut("box", name="window", face="section", axis=(0, 0, 1))
        cut = self.session["cuts"][0]
        self.assertEqual((cut["name"], cut["shape"], cut["face"], cut["axis"]), ("window", "box", "section", [0, 0, 1]))
        self.assertIn("camera", self.session[""])

    def test_brackets_hold_names_ids_and_places(self):
        for name in ("first", "second"):
            self.session.cut(shape="box", name=name)
        for path in ("cuts[1].face", "cuts.1.face", "cuts[second].face", f"cuts[#{self.session['cuts[1].id']}].face"):
            self.session["cuts[1].face"] = "shaded"
            self.session[path] = "section"
            self.assertEqual([cut["face"] for cut in self.session["cuts"]], ["shaded", "section"], path)
        with self.assertRaisesRegex(velum.ArgumentError, "cuts has 2 items"):
            self.session["cuts[2].face"] = "section"

    def test_what_is_there_is_told(self):
        self.assertEqual(repr(self.session), "<velum.Session <velum.Volume array (32, 32, 32) int16>, 0 cuts>")
        self.assertIn("FilmCommands: at, clear", repr(self.session.film))
        keys = self.session._ipython_key_completions_()
        self.assertIn("camera.eye", keys)
        for key in keys:
            self.session[key]

    def test_a_cut_that_cannot_be_as_asked_is_not_there(self):
        before = self.session.commands()
        with self.assertRaisesRegex(velum.ArgumentError, "axle"):
            self.session.cut("box", face="section", axle=(0, 0, 1))
        self.assertEqual(self.session.commands(), before)


class Errors(Case):
    def test_they_are_the_lines_of_the_program(self):
        """What velum-batch says of the same script."""
        path = self.sample()
        for line, call, kind in (
                ("open nowhere.nrrd", lambda s: s.open("nowhere.nrrd"), velum.InputError), ("set rayCast.mode x", lambda s: s.set("rayCast.mode", "x"), velum.ArgumentError),
                ("cut.add cube", lambda s: s.cut.add("cube"), velum.ArgumentError), ("set rayCast.mood mip", lambda s: s.__setitem__("rayCast.mood", "mip"), velum.ArgumentError),
                ("structure.show nobody", lambda s: s.structure.show("nobody"), velum.ArgumentError), ("undo", lambda s: s.undo(), velum.InputError),
                ("cut.remove", lambda s: s.cut.remove(), velum.ArgumentError), ("save /nowhere/a.json", lambda s: s.save("/nowhere/a.json"), velum.InputError)):
            with self.subTest(line=line):
                (self.folder / "script").write_text(line + "\n")
                said = subprocess.run([PROGRAM, "run", "script", path], capture_output=True, text=True, cwd=self.folder)
                expected = said.stderr.strip().splitlines()[-1].removeprefix("velum-batch: script:1: ")
                with velum.open(path) as session, self.assertRaises(kind) as caught:
                    call(session)
                self.assertEqual(str(caught.exception).replace(str(pathlib.Path.cwd()), str(self.folder)), expected)

    def test_python_refuses_names_that_are_none(self):
        session = velum.Session()
        with self.assertRaisesRegex(TypeError, "cut.add: .*'form'.*shape"):
            session.cut.add(form="box")
        with self.assertRaises(AttributeError):
            session.cut.ad("box")
        with self.assertRaises(velum.ArgumentError):
            session["rayCast.mode"] = object()
        self.assertTrue(issubclass(velum.ArgumentError, ValueError) and issubclass(velum.InputError, velum.Error))

    def test_an_array_is_no_file(self):
        with velum.open(ball()) as session:
            with self.assertRaisesRegex(velum.ArgumentError, "array"):
                session.save(self.folder / "scene.json")
            session.voxels.save(self.folder / "ball.nrrd")
        with velum.open(self.folder / "ball.nrrd") as session:
            session.save(self.folder / "scene.json")
        self.assertEqual(json.loads((self.folder / "scene.json").read_text())["volume"]["source"]["path"], "ball.nrrd")

    def test_notes_are_warnings(self):
        path = self.sample()
        with velum.open(path) as session:
            session.cut.add("plane")
            session.mark.add("distance", points=[(0, 0, 0), (1, 2, 3)])
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                session.scene.carry(self.sample("vessels"))
            self.assertTrue(all(issubclass(note.category, velum.Note) for note in caught))

    def test_each_is_one_line_that_says_what_is_expected(self):
        with velum.open(ball()) as session:
            rows = [(lambda: session.render(96.0, 72), "width 96.0: expected a whole number"), (lambda: session.render(96, 2 ** 40), "height"),
                    (lambda: session.render(96, 72, samples="many"), "samples 'many'"), (lambda: session.render(96, 72, section=5), "section 5: expected a text"),
                    (lambda: session.layers(96, numpy.zeros((3, 3))), "height array"), (lambda: session.count("wide"), "width 'wide'"),
                    (lambda: session.render(96, 72, dtype="int16"), "dtype 'int16': expected uint8 or float32"), (lambda: session.render(96, 72, dtype=5), "dtype 5"),
                    (lambda: next(session.frames(1.5, 2)), "width 1.5"), (lambda: session[5], "field 5: expected a text"),
                    (lambda: session.__setitem__(5, 1), "5"), (lambda: velum.Session(5), "context 5"), (lambda: velum.Session("glx"), "egl"),
                    (lambda: velum.Session(progress=5), "progress 5: expected a function"), (lambda: session.voxels.save(5), "path 5"),
                    (lambda: session.__setitem__("volume.source.path", "\ud800"), "command"), (lambda: session.open("a\nb.nrrd"), "a"),
                    (lambda: setattr(session, "labels", numpy.zeros((2, 2, 2), "uint8")), "shape"), (lambda: session.run("\xe9"), "no command")]
            for call, words in rows:
                with self.subTest(words=words), self.assertRaises(velum.Error) as caught:
                    call()
                self.assertIn(words, str(caught.exception))
                self.assertNotIn("\n", str(caught.exception))

    def test_paths_are_those_of_the_system(self):
        folder = os.fsencode(self.folder)
        for name in (b"caf\xe9.nrrd", b"caf\xe9 = \"two\" words,.nrrd", "Sch\u00e4del.nrrd".encode()):
            whole = os.path.join(folder, name)
            velum.Volume(ball(side=8)).save(whole)
            self.assertIn(name, os.listdir(folder))
            for path in (whole, os.fsdecode(whole), pathlib.Path(os.fsdecode(whole))):
                with self.subTest(path=path), velum.open(path) as session:
                    self.assertEqual(session.voxels.array.shape, (8, 8, 8))
                    session.commands(), session.asPython(), session[""]
                    session.add(path)
            with velum.open(ball(side=8)) as session:
                picture = whole.replace(b".nrrd", b".png")
                session.picture("32x24", picture, samples=1)
                self.assertTrue(os.path.exists(picture))
            os.remove(whole)
            with self.assertRaisesRegex(velum.InputError, "no such file"):
                velum.open(whole)

    def test_names_that_are_no_utf8_are_shown_all_the_same(self):
        velum.Labels(ball(inside=1), names={1: "Schadel"}).save(self.folder / "a.seg.nrrd")
        data = (self.folder / "a.seg.nrrd").read_bytes()
        self.assertIn(b"Schadel", data)
        (self.folder / "a.seg.nrrd").write_bytes(data.replace(b"Schadel", b"Sch\xe4del"))
        with velum.open(ball()) as session:
            session.add(self.folder / "a.seg.nrrd")
            self.assertEqual(session.labels.names, {1: "Sch\ufffddel"})
            self.assertEqual(session["labels.structures.0.name"], "Sch\ufffddel")
            self.assertEqual(session[""]["labels"]["structures"][0]["name"], "Sch\ufffddel")
            self.assertIn("\ufffd", session.measure(structures=True)["structures"][0]["name"])
            with self.assertRaises(velum.ArgumentError):
                session.structure.show("Sch\xe4")
            session.asPython(), session.commands()

    def test_a_closed_session_says_so(self):
        session = velum.open(ball())
        session.close()
        session.close()
        with self.assertRaisesRegex(velum.ArgumentError, "closed"):
            session.undo()
        self.assertEqual(repr(session), "<velum.Session closed>")


class Tables(Case):
    def test_measure_tells_what_the_program_tells(self):
        path = self.sample("torso")
        labels = path.with_name("torso_labels.seg.nrrd")
        with velum.open(path) as session:
            session.add(labels)
            session.mark.add("distance", points=[(0, 0, 0), (30, 40, 0)])
            table = session.measure(structures=True)
            self.assertAlmostEqual(table["marks"][0]["length"]["value"], 50)
            session.save(self.folder / "scene.json")
        batch = json.loads(self.run_program(PROGRAM, "measure", "scene.json", "--structures", "--json"))
        self.assertEqual(table, batch)

    def test_count_tells_what_the_program_tells(self):
        path = self.folder / "virion.cif"
        self.run_program(PROGRAM, "sample", "virion", "-o", path)
        with velum.open(path) as session:
            session.cut.add("plane")
            rows = session.count(*SMALL)
            session.save(self.folder / "scene.json")
        batch = json.loads(self.run_program(PROGRAM, "count", "scene.json", "--size", "96x72", "--json"))
        kinds = ("name", "path", "visible", "hidden", "clipped", "total")
        for key, is_compartment in (("perType", False), ("perCompartment", True)):
            mine = [{kind: row[kind] for kind in kinds} for row in rows if row["isCompartment"] == is_compartment]
            self.assertEqual(mine, [{kind: row[kind] for kind in kinds} for row in batch[key]])
        with velum.open(self.sample()) as session, self.assertRaises(velum.InputError):
            session.count(*SMALL)

    def test_a_range_grows(self):
        with velum.open(ball(side=32)) as session:
            session.grow((15.5, 15.5, 15.5), range=(500, 1500), name="ball")
            numpy.testing.assert_array_equal(session.labels.array > 0, ball() > 0)
            self.assertIn("ball", session.labels.names.values())


if __name__ == "__main__":
    unittest.main()
