"""A notebook that uses the package is executed, and shows its pictures."""
import base64
import json
import os
import shutil
import subprocess
import sys
import unittest

from support import Case, read_png

CELLS = ["import numpy, velum",
         "z, y, x = numpy.ogrid[:32, :32, :32]\nball = ((x - 16) ** 2 + (y - 16) ** 2 + (z - 16) ** 2 < 100) * numpy.uint8(200)",
         "s = velum.open(ball, spacing=(1, 1, 1))\ns.cut('plane', face='section')\ns.render(96, 72, samples=1)",
         "try:\n    s.cut.add('cube')\nexcept velum.ArgumentError as error:\n    print(error)"]


def has_jupyter():
    found = subprocess.run([sys.executable, "-c", "import nbconvert, ipykernel"], capture_output=True)
    return found.returncode == 0 and shutil.which("jupyter") is not None


if not has_jupyter():
    print("jupyter-nbconvert and python3-ipykernel are not installed: skipped")
    sys.exit(77)


class Notebook(Case):
    def test_it_is_executed_and_shows_the_picture(self):
        cells = [{"cell_type": "code", "execution_count": None, "id": str(number), "metadata": {}, "outputs": [], "source": text}
                 for number, text in enumerate(CELLS)]
        kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
        (self.folder / "a.ipynb").write_text(json.dumps({"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}))
        # The kernel is the interpreter that runs this.
        kernels = self.folder / "share/kernels/python3"
        kernels.mkdir(parents=True)
        (kernels / "kernel.json").write_text(json.dumps({"argv": [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"],
                                                         "display_name": "Python 3", "language": "python"}))
        home = {**os.environ, "HOME": str(self.folder), "JUPYTER_PATH": str(self.folder / "share")}
        self.run_program(sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "a.ipynb", "--output", "done.ipynb", env=home)
        outputs = [cell["outputs"] for cell in json.loads((self.folder / "done.ipynb").read_text())["cells"]]
        self.assertEqual(outputs[:2], [[], []])
        picture = read_png(base64.b64decode(outputs[2][0]["data"]["image/png"]))
        self.assertEqual(picture.shape, (72, 96, 3))
        self.assertGreater(picture.std(), 5)
        self.assertIn("cube", outputs[3][0]["text"][0])


if __name__ == "__main__":
    unittest.main()
