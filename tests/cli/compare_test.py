"""velum-batch compare."""
import unittest

from velum_cli import CliTest


class Compare(CliTest):
    def test_equal_different_and_not_comparable(self):
        path = self.sample()
        self.run_batch("render", path, "-o", "a.png", "--size", "48x48", "--set", "lighting.shaded=false")
        self.run_batch("render", path, "-o", "b.png", "--size", "48x48", "--view", "superior", "--set", "background.top=1,0,0", "--set", "lighting.shaded=false")
        self.run_batch("render", path, "-o", "c.png", "--size", "32x48", "--set", "lighting.shaded=false")
        report = self.report("compare", "a.png", "a.png")
        self.assertKeys(report, "maxDiff", "failingFraction", "rms")
        self.assertEqual((report["maxDiff"], report["failingFraction"], report["rms"]), (0, 0, 0))
        self.run_batch("compare", "a.png", "a.png", "--max-diff", "0", "--max-fraction", "0")
        report = self.report("compare", "a.png", "b.png", "--diff", "d.png", code=4)
        self.assertGreater(report["maxDiff"], 5)
        self.assertGreater(report["failingFraction"], 0.001)
        self.assertTrue((self.folder / "d.png").exists())
        self.run_batch("compare", "a.png", "b.png", "--max-fraction", "1")
        self.refuse("compare", "a.png", "c.png", code=2)
        self.refuse("compare", "a.png", "none.png", code=2, words=["none.png"])
        self.refuse("compare", "a.png", path, code=2)


if __name__ == "__main__":
    unittest.main()
