"""Every example of the documents runs as it stands there, one after the other, in one folder; pictures are made small."""
import os
import re
import shutil
import unittest

from support import ROOT, Case, ball

import velum


def examples(text):
    return re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S)


class Guide(Case):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        shutil.copy(self.sample("torso"), "ct.nrrd")
        shutil.copy("torso_labels.seg.nrrd", "ct_labels.seg.nrrd")

    def test_examples_run(self):
        blocks = examples((ROOT / "docs/PYTHON.md").read_text())
        self.assertGreater(len(blocks), 6)
        names = {}
        for block in blocks:
            block = re.sub(r"(render|layers|count)\(\d+, \d+", r"\1(96, 72", block).replace("1920x1080", "96x72")
            with self.subTest(example=block):
                exec(compile(block, "docs/PYTHON.md", "exec"), names)
        for name in ("head.png", "work.json", "filtered.nrrd"):
            self.assertTrue(os.path.exists(name), name)

    def test_the_one_of_the_package_runs(self):
        velum.Volume(ball()).save("head.nii.gz")
        names = {}
        example = [line[4:] for line in velum.__doc__.splitlines() if line.startswith("    ")]
        exec("\n".join(example).replace("1280, 960", "96, 72"), names)
        self.assertEqual(names["image"].shape, (72, 96, 3))


if __name__ == "__main__":
    unittest.main()
