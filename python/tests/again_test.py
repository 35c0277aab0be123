"""What was done, copied as Python, does it again: the same scene, and the same bytes of a picture."""
import unittest

from support import PROGRAM, Case

import velum

SCRIPTS = {
    "cuts": """cut.add box "my = \\"cut\\""
set cuts.0.face section
cut.add plane
cut.place 0,0,4 0.5,0.25,1 cut="Plane 1"
view.from oblique
look.background 1,1,1 0.8,0.8,0.8
undo
structure.show "upper sphere" false""",
    "words": """cut.add plane 42
cut.rename 42 "a,b"
set cuts.0.name [1,2]
mark.add label 0,0,0 text="Sch\\u00e4del, \\"oben\\""
caption.add "a caption = 1"
film.key camera.eye 1
film.turn
view.from left""",
    "growth": """growth.grow [[0,0,0]] 100,3000 name=grown
cut.add plane
set rayCast.mode iso""",
}


class Again(Case):
    def expect_again(self, open_lines, script):
        """A script run by the program, and its copy in Python run by Python."""
        tail = f"picture 96x72 samples=1 {self.folder}/scripted.png\nsave {self.folder}/scripted.json\n"
        (self.folder / "script.txt").write_text(f"{open_lines}\n{script}\n{tail}")
        self.run_program(PROGRAM, "run", "script.txt")
        with velum.Session() as session:
            session.run(f"{open_lines}\n{script}")
            program = session.asPython()
        self.run_python(f"{program}\ns.picture('96x72', '{self.folder}/again.png', samples=1)\ns.save('{self.folder}/again.json')\n")
        self.assertEqual((self.folder / "again.json").read_text(), (self.folder / "scripted.json").read_text(), program)
        self.assertEqual((self.folder / "again.png").read_bytes(), (self.folder / "scripted.png").read_bytes(), program)
        return program

    def test_of_scripts(self):
        path = self.sample()
        for name, script in SCRIPTS.items():
            with self.subTest(script=name):
                self.expect_again(f"open {path}\nadd {path.with_name('two-spheres_labels.seg.nrrd')}", script)

    def test_it_reads_as_python(self):
        path = self.sample()
        program = self.expect_again(f"open {path}", "cut.add plane\nset cuts.0.axis 0,0.5,1\nset cuts.0.face section\nlook.mode mip\nview.from left")
        for line in ("import velum", "s = velum.Session()", f's.open("{path}")', "s.cut.add()", 's["cuts.0.axis"] = (0, 0.5, 1)', 's["cuts.0.face"] = "section"',
                     's.look.mode("mip")'):
            self.assertIn(line, program.splitlines())

    def test_of_a_membrane(self):
        path = self.sample("torso", 24)
        self.expect_again(f"open {path}", "membrane.hang 200,3000 axis=0,-1,0")


if __name__ == "__main__":
    unittest.main()
