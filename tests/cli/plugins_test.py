"""What the readers' libraries cost whoever does not need them: nothing; and what is said where one is missing."""
import pathlib
import shutil
import unittest

from velum_cli import PROGRAM, CliTest

LIBRARIES = pathlib.Path(PROGRAM).resolve().parents[1] / "lib"
HEAVY = ("libOpenImageIO", "libgdcm", "libvelum-io-hdf5", "libvelum-io-tiff", "libopenvdb", "libvtk")


class Plugins(CliTest):
    def loaded(self, *arguments):
        """Those of the heavy libraries that a run loads."""
        said = self.run_batch(*arguments, env={"LD_DEBUG": "files"}).stderr.decode(errors="replace")
        self.assertIn("libvelum-core", said)
        return {name for name in HEAVY if f"/{name}" in said}

    def test_nothing_is_loaded_before_it_is_needed(self):
        self.assertEqual(self.loaded("--version"), set())
        self.assertEqual(self.loaded("help"), set())
        volume = self.sample(file="spheres.nrrd")
        self.assertEqual(self.loaded("info", volume), set())
        self.assertEqual(self.loaded("convert", volume, "spheres.nii.gz"), set())

    def test_each_is_loaded_by_itself(self):
        volume = self.sample(file="spheres.nrrd")
        self.assertEqual(self.loaded("convert", volume, "spheres.vdb"), {"libopenvdb"})
        self.assertEqual(self.loaded("convert", volume, "spheres.vti"), {"libvtk"})
        self.assertEqual(self.loaded("info", "spheres.vdb"), {"libopenvdb"})
        self.assertEqual(self.loaded("info", "spheres.vti"), set())

    def test_a_missing_one_is_one_line_and_all_else_works(self):
        libraries = self.folder / "lib"
        libraries.mkdir()
        for path in LIBRARIES.glob("libvelum-*.so*"):
            shutil.copy(path, libraries, follow_symlinks=False)
        environment = {"LD_LIBRARY_PATH": str(libraries)}
        volume = self.sample(file="spheres.nrrd")
        self.run_batch("convert", volume, "spheres.vdb")
        said = self.run_batch("info", "spheres.vdb", code=2, env=environment).stderr.decode()
        self.assertEqual(said.strip(), "velum-batch: cannot read or write OpenVDB: libvelum-io-vdb.so was not found in "
                         f"{libraries}/velum")
        self.run_batch("info", volume, env=environment)
        # One that is there, but cannot be loaded.
        (libraries / "velum").mkdir()
        (libraries / "velum/libvelum-io-vdb.so").write_bytes(b"none")
        said = self.run_batch("info", "spheres.vdb", code=2, env=environment).stderr.decode()
        self.assertEqual(len(said.splitlines()), 1)
        self.assertIn("velum-batch: cannot read or write OpenVDB: ", said)


if __name__ == "__main__":
    unittest.main()
