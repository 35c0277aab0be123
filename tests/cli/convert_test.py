"""velum-batch convert: what goes in comes out."""
import json
import resource
import shutil
import struct
import unittest

from velum_cli import CliTest

KEPT = ["dims", "type", "spacingMm", "direction", "originMm", "range", "scale", "offset"]


class Convert(CliTest):
    def close(self, a, b, what):
        if isinstance(a, list):
            for x, y in zip(a, b, strict=True):
                self.close(x, y, what)
        elif isinstance(a, float) or isinstance(b, float):
            self.assertAlmostEqual(a, b, delta=1e-4 * max(1.0, abs(a)), msg=what)
        else:
            self.assertEqual(a, b, what)

    def test_every_writable_format_keeps_the_volume(self):
        path = self.sample("torso", 32)
        before = self.report("info", path)
        for extension in ("nrrd", "nii", "nii.gz", "vti"):
            with self.subTest(extension=extension):
                self.run_batch("convert", path, f"b.{extension}")
                after = self.report("info", f"b.{extension}")
                for key in KEPT:
                    self.close(before[key], after[key], f"{key} in {extension}")
                self.run_batch("convert", f"b.{extension}", "c.nrrd")
                self.close(before["range"], self.report("info", "c.nrrd")["range"], "there and back")

    def test_stores_give_back_what_they_were_given(self):
        path = self.sample("torso", 32)
        before = self.report("info", path)
        for name, options in (("b.ome.zarr", []), ("b.ozx", []), ("old.zarr", ["--zarr", "0.4"])):
            with self.subTest(name=name):
                self.run_batch("convert", path, name, *options)
                self.run_batch("convert", name, "again.zarr")  # from store to store
                for store in (name, "again.zarr"):
                    self.run_batch("convert", store, "c.nrrd")
                    after = self.report("info", "c.nrrd")
                    for key in KEPT:
                        self.close(before[key], after[key], f"{key} in {store}")
                self.refuse("convert", path, "again.zarr", code=2, words=["is there already"])
                shutil.rmtree(self.folder / "again.zarr")
        self.refuse("convert", path, "old.ozx", "--zarr", "0.4", code=2, words=["0.5"])

    def test_what_is_streamed_is_said_by_a_size_with_its_unit(self):
        self.run_batch("convert", self.sample("torso", 160), "a.zarr")
        self.assertFalse(self.report("info", "a.zarr")["isStreamed"])
        self.assertTrue(self.report("info", "a.zarr", "--read-whole", "100kB")["isStreamed"])
        self.assertFalse(self.report("info", "a.zarr", "--read-whole", "1GiB")["isStreamed"])
        self.refuse("info", "a.zarr", "--read-whole", "3 elephants", code=1)
        report = self.report("render", "a.zarr", "-o", "a.png", "--size", "64x48", "--samples", "1", "--read-whole", "100kB",
                             "--gpu-brick-memory", "64MiB", "--brick-memory", "64MiB")
        self.assertEqual(report["streaming"]["budgetBytes"], 64 << 20)
        self.assertEqual(report["streaming"]["missing"], 0)
        self.assertAlmostEqual(sum(report["streaming"]["shares"]), 1.0, delta=1e-9)

    def test_a_streamed_volume_is_written_at_its_finest_level_and_so_is_a_box_of_it(self):
        path, streamed = self.sample("torso", 160), ["--read-whole", "100kB"]
        before = self.report("info", path)
        self.run_batch("convert", path, "a.zarr")

        def voxels(name):
            return (self.folder / name).read_bytes().split(b"\n\n", 1)[1]

        self.run_batch("convert", path, "whole.nrrd")
        self.run_batch("convert", "a.zarr", "streamed.nrrd", *streamed)
        self.assertEqual(voxels("whole.nrrd"), voxels("streamed.nrrd"))
        box = ["--box", "10,20,30,60,50,70"]
        self.run_batch("convert", path, "box.nrrd", *box)
        self.run_batch("convert", "a.zarr", "streamed-box.nrrd", *box, *streamed)
        self.run_batch("convert", "a.zarr", "box.zarr", *box, *streamed)
        self.run_batch("convert", "box.zarr", "stored-box.nrrd")
        for name in ("box", "streamed-box", "stored-box"):
            info = self.report("info", f"{name}.nrrd")
            self.assertEqual(info["dims"], [50, 30, 40])
            self.assertEqual(voxels("box.nrrd"), voxels(f"{name}.nrrd"))
            rows = [before["direction"][3 * i:3 * i + 3] for i in range(3)]
            for row, origin, first in zip(rows, before["originMm"], info["originMm"]):
                steps = [n * cosine * edge for n, cosine, edge in zip((10, 20, 30), row, before["spacingMm"])]
                self.assertAlmostEqual(first, origin + sum(steps), delta=1e-3)
        self.refuse("convert", "a.zarr", "c.nrrd", "--box", "10,20,30,60,50,7000", code=1, words=["does not lie in"])
        self.refuse("convert", "a.zarr", "c.nrrd", "--box", "10,20,30,60,20,70", code=1, words=["does not lie in"])

    def test_stores_of_others_become_pyramids(self):
        for level, factor in (("s0", 1), ("s1", 2)):
            folder = self.folder / "a.n5" / level
            (folder / "0" / "0").mkdir(parents=True)
            dims = [16 // factor, 12 // factor, 10]
            (folder / "attributes.json").write_text(json.dumps({
                "dimensions": dims, "blockSize": dims, "dataType": "uint16", "compression": {"type": "raw"},
                "downsamplingFactors": [factor, factor, 1]}))
            values = range(dims[0] * dims[1] * dims[2])
            (folder / "0/0/0").write_bytes(struct.pack(f">2H3I{len(values)}H", 0, 3, *dims, *values))
        (self.folder / "a.n5/attributes.json").write_text(
            json.dumps({"n5": "4.0.0", "pixelResolution": {"unit": "um", "dimensions": [0.5, 0.5, 2]}}))
        report = self.report("info", "a.n5")
        self.assertEqual([level["dims"] for level in report["levels"]], [[16, 12, 10], [8, 6, 10]])
        self.close(report["spacingMm"], [5e-4, 5e-4, 2e-3], "spacing")
        self.run_batch("convert", "a.n5", "b.ome.zarr")
        self.run_batch("convert", "b.ome.zarr", "c.nrrd")
        self.run_batch("convert", "a.n5", "d.nrrd")
        written, direct = self.report("info", "c.nrrd"), self.report("info", "d.nrrd")
        for key in KEPT:
            self.close(written[key], direct[key], key)
        self.assertEqual(direct["range"], [0, 1919])
        self.run_batch("render", "a.n5", "-o", "a.png", "--size", "40x30")

    def test_a_large_file_becomes_a_store_and_is_never_held(self):
        with open(self.folder / "large.raw", "wb") as file:
            file.truncate(1024 * 1024 * 1500)  # nothing is on the disk of what is not written
            file.seek(1024 * 1024 * 1499 + 5)
            file.write(b"!")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.run_batch("convert", "large.raw", "large.zarr", "--raw", "1024x1024x1500:uint8", "--spacing", "1,1,2")
        most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(most, max(before, 1_000_000), "KiB")
        report = self.report("info", "large.zarr")
        self.assertEqual(report["dims"], [1024, 1024, 1500])
        self.close(report["spacingMm"], [1, 1, 2], "spacing")

    def test_there_and_back_draws_the_same_picture(self):
        path = self.sample("vessels", 32)
        self.run_batch("convert", path, "b.nii.gz")
        self.run_batch("convert", "b.nii.gz", "c.nrrd")
        look = ["--size", "40x40", "--preset", "angiography", "--samples", "1", "--set", "lighting.shaded=false"]
        self.run_batch("render", path, "-o", "x.png", *look)
        self.run_batch("render", "c.nrrd", "-o", "y.png", *look)
        self.run_batch("compare", "x.png", "y.png", "--max-diff", "1", "--max-fraction", "0")

    def test_vdb_keeps_values_and_place(self):
        path = self.sample("two-spheres", 32)
        self.run_batch("convert", path, "b.vdb")
        before, after = self.report("info", path), self.report("info", "b.vdb")
        self.assertEqual(after["type"], "float32")
        self.close(before["spacingMm"], after["spacingMm"], "spacing")
        self.close(before["range"][1], after["range"][1], "range")

    def test_labels_keep_their_names(self):
        self.sample("torso", 32)
        before = self.report("info", "torso_labels.seg.nrrd")
        for name in ("b_labels.nii.gz", "b.seg.nrrd", "b.zarr"):
            self.run_batch("convert", "torso_labels.seg.nrrd", name)
            if name == "b.zarr":  # of a store `info` tells levels, and reads no labels
                self.run_batch("convert", name, name := "c.seg.nrrd")
            after = self.report("info", name)
            self.assertEqual(after["kind"], "labels", name)
            self.assertEqual([s["name"] for s in before["structures"]], [s["name"] for s in after["structures"]], name)

    def test_a_look_goes_through_every_kind_of_file_and_draws_the_same(self):
        path = self.sample("torso", 32)
        draw = ["--size", "40x40", "--samples", "1", "--set", "lighting.shaded=false"]
        self.run_batch("render", path, "-o", "a.png", *draw, "--preset", "ct-bone", "--save-scene", "a.json")
        self.run_batch("convert", "a.json", "b.vp")  # from the scene, the data is not read
        self.run_batch("convert", "b.vp", "c.vp.json")
        self.run_batch("convert", "c.vp.json", "d.velum-transfer.json")
        self.run_batch("convert", "a.png", "e.velum-transfer.json")
        for name in ("b.vp", "c.vp.json", "d.velum-transfer.json", "e.velum-transfer.json"):
            with self.subTest(name=name):
                self.run_batch("render", path, "-o", "x.png", *draw, "--preset", "ct-skin", "--transfer", name)
                # The presets' grey windows differ, and with them where the steps of the table lie.
                self.run_batch("compare", "a.png", "x.png", "--max-diff", "2", "--max-fraction", "0")

    def test_what_shows_of_a_model_is_written(self):
        self.run_batch("sample", "virion", "-o", "v.cif.gz")
        half = ["--set", 'cuts=[{"shape": "plane", "centre": [0, 0, 0]}]']
        whole = self.report("convert", "v.cif.gz", "a.csv")
        cut = self.report("convert", "v.cif.gz", "b.csv", *half)
        self.assertEqual((whole["kind"], whole["output"]), ("model", "a.csv"))
        for name, told in (("a.csv", whole), ("b.csv", cut)):
            lines = (self.folder / name).read_text().splitlines()
            self.assertEqual(len(lines) - 1, told["instances"])
        self.assertLess(abs(cut["instances"] / whole["instances"] - 0.5), 0.1)
        self.assertTrue(any("atoms" in line for line in cut["warnings"]), cut["warnings"])
        self.report("convert", "v.cif.gz", "b.cif", *half)
        self.assertEqual(self.report("info", "b.cif")["instances"], cut["instances"])
        # A scene is written as it shows.
        self.run_batch("render", "v.cif.gz", "-o", "x.png", "--section", "axial", "--size", "16x16", *half,
                       "--save-scene", "s.json")
        for name in ("c.glb", "c.ply", "c.csv"):
            self.assertEqual(self.report("convert", "s.json", name)["instances"], cut["instances"])
        self.assertEqual((self.folder / "b.csv").read_bytes(), (self.folder / "c.csv").read_bytes())

    def test_of_a_model_what_cannot_be_is_one_line(self):
        self.run_batch("sample", "virion", "-o", "v.cif.gz")
        both = ["--set", 'cuts=[{"shape": "plane"}, {"shape": "plane", "axis": [0, 1, 0]}]']
        self.refuse("convert", "v.cif.gz", "a.nrrd", code=2, words=[".glb"])
        self.refuse("convert", "v.cif.gz", "none/a.glb", code=2, words=["none/a.glb"])
        self.refuse("convert", "v.cif.gz", "a\nb/a.glb", code=2)
        self.refuse("convert", "v.cif.gz", "a.cif", *both, code=2, words=["shows"])
        self.refuse("convert", self.sample(), "a.nii", "--set", "rayCast.mode=mip", code=1, words=["--set"])

    def test_what_a_format_cannot_hold_is_said(self):
        path = self.sample("torso", 32)
        done = self.run_batch("convert", path, "b.nii", "--json")
        said = done.stderr.decode().splitlines()
        warnings = json.loads(done.stdout)["warnings"]
        self.assertTrue(any("'HU'" in line for line in warnings), warnings)
        for line in warnings:
            self.assertIn(f"warning: b.nii: {line}", said)
        self.assertEqual(self.report("convert", path, "torso.nrrd")["warnings"], [])

    def test_what_a_reader_notes_is_said_too(self):
        path = self.sample("two-spheres", 32)
        self.run_batch("convert", path, "b.nii")
        data = bytearray((self.folder / "b.nii").read_bytes())
        data[252:256] = b"\0\0\0\0"  # no form says how the body lies
        (self.folder / "c.nii").write_bytes(data)
        warnings = self.report("convert", "c.nii", "c.nrrd")["warnings"]
        self.assertTrue(any("how the body lies" in line for line in warnings), warnings)

    def test_a_look_says_what_slicer_has_no_place_for(self):
        path = self.sample("torso", 32)
        self.run_batch("render", path, "-o", "a.png", "--size", "16x16", "--preset", "ct-bone", "--save-scene", "a.json")
        warnings = self.report("convert", "a.json", "b.vp")["warnings"]
        self.assertTrue(any("ct-bone" in line for line in warnings), warnings)
        self.assertEqual(self.report("convert", "a.json", "b.velum-transfer.json")["warnings"], [])

    def test_samples_and_sheets_say_it_as_well(self):
        report = self.report("sample", "torso", "-o", "t.nii", "--voxels", "32")
        self.assertTrue(any("'HU'" in line for line in report["warnings"]), report)
        report = self.report("membrane", "t.nii", "--sheet", "s.stl")
        self.assertTrue(any("normals" in line for line in report["warnings"]), report)
        self.assertEqual(self.report("membrane", "t.nii", "--sheet", "s.ply")["warnings"], [])

    def test_labels_become_surfaces_and_segmentations(self):
        self.sample("two-spheres", 32)
        labels = "two-spheres_labels.seg.nrrd"
        names = [s["name"] for s in self.report("info", labels)["structures"]]
        self.run_batch("convert", labels, "b.dcm")
        after = self.report("info", "b.dcm")
        self.assertEqual((after["kind"], [s["name"] for s in after["structures"]]), ("labels", names))
        for name in ("b.stl", "b.ply", "b.obj", "b.vtp"):
            self.assertEqual(self.report("convert", labels, name)["structures"], 2)
            self.assertGreater(self.report("info", name)["triangles"], 500, name)
        self.assertEqual(self.report("convert", labels, "b.glb", "--structure", names[0], "--smooth", "0.2")["structures"], 1)
        self.run_batch("convert", labels, "c.stl", "--apart")
        self.assertTrue((self.folder / "c-upper-sphere.stl").exists())
        self.refuse("convert", labels, "d.stl", "--structure", "spleen", code=1, words=["spleen"])
        self.refuse("convert", labels, "d.stl", "--smooth", "2", code=1, words=["2"])
        self.refuse("convert", "two-spheres.nrrd", "d.stl", code=1, words=["two-spheres.nrrd", "--labels"])

    def test_structures_of_a_scene_have_its_names(self):
        path = self.sample("two-spheres", 32)
        self.run_batch("render", path, "two-spheres_labels.seg.nrrd", "-o", "a.png", "--size", "16x16", "--set",
                       "labels.structures.0.name=my ball", "--save-scene", "a.json")
        self.run_batch("convert", "a.json", "b.seg.nrrd")
        self.assertEqual(self.report("info", "b.seg.nrrd")["structures"][0]["name"], "my ball")

    def test_formats_that_are_not_written_exit_2(self):
        path = self.sample()
        for name in ("b.dcm", "b", "b.txt", "none/b.nrrd"):
            with self.subTest(name=name):
                self.refuse("convert", path, name, code=2, words=[name.split("/")[0]])


if __name__ == "__main__":
    unittest.main()
