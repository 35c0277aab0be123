"""velum-batch grow: what it grows, what it writes, what it refuses."""
import array
import json
import unittest
import zlib

from velum_cli import CliTest

SIZE = 40


class Grow(CliTest):
    def volume(self, valueOf, name="v.nrrd", more=""):
        """A cube of uint8 voxels with its first voxel's middle at the origin, half a millimetre apart."""
        data = bytes(valueOf(x, y, z) for z in range(SIZE) for y in range(SIZE) for x in range(SIZE))
        head = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIZE} {SIZE} {SIZE}\n"
                f"space directions: (0.5,0,0) (0,0.5,0) (0,0,0.5)\nspace origin: (0,0,0)\nencoding: raw\n{more}\n")
        (self.folder / name).write_bytes(head.encode() + data)
        return self.folder / name

    def bar(self):
        """A bar of 4 x 4 along z, that reaches a wall at 30."""
        return self.volume(lambda x, y, z: 200 if z >= 30 else 190 if 10 <= x < 14 and 20 <= y < 24 else 20)

    def test_reports_what_it_has_grown(self):
        report = self.report("grow", self.bar(), "--seed", "6,11,5", "--range", "150,250", "-o", "l.seg.nrrd")
        self.assertKeys(report, "voxels", "slabs", "ms", "volumeMl", "box", "structure", "range")
        self.assertEqual(report["voxels"], 30 * 16 + 10 * SIZE * SIZE)
        self.assertAlmostEqual(report["volumeMl"], report["voxels"] * 0.125 / 1000)
        low, high = report["range"]
        self.assertEqual(report["values"]["voxels"], report["voxels"])
        self.assertTrue(low <= report["values"]["min"] <= report["values"]["mean"] <= report["values"]["max"] <= high)
        self.assertEqual(report["box"], {"first": [0, 0, 0], "last": [SIZE - 1] * 3})
        self.assertEqual((self.report("info", "l.seg.nrrd"))["kind"], "labels")

    def test_grows_on_one_side_of_a_plane(self):
        bar = self.bar()
        report = self.report("grow", bar, "--seed", "6,11,4", "--range", "150,250", "--plane", "0,0,1,4", "--distance", "5",
                             "-o", "l.nrrd")
        # The seed's own voxel, in the plane, and what lies above it up to 9 mm.
        self.assertEqual(report["voxels"], 1 + 10 * 16)
        self.assertEqual(report["box"]["last"][2], 18)
        self.assertGreater(report["slabs"], 1)
        # However long the normal is that the plane is given by.
        again = self.report("grow", bar, "--seed", "6,11,4", "--range", "150,250", "--plane", "0,0,3,12", "--distance", "5",
                            "-o", "m.nrrd")
        self.assertEqual(report["voxels"], again["voxels"])
        self.assertEqual((self.folder / "l.nrrd").read_bytes(), (self.folder / "m.nrrd").read_bytes())

    def test_a_guard_stops_before_it_leaks(self):
        common = ("--seed", "6,11,1", "--range", "150,250", "--plane", "0,0,1,1", "-o", "l.nrrd")
        leaked = self.report("grow", self.bar(), *common)
        guarded = self.report("grow", self.bar(), *common, "--guard")
        self.assertNotIn("leak", leaked)
        self.assertKeys(guarded["leak"], "depth", "area", "widestBefore")
        self.assertLess(guarded["voxels"], 30 * 16)
        self.assertGreater(guarded["voxels"], 15 * 16)
        self.assertLess(guarded["distance"], guarded["leak"]["depth"])
        said = self.run_batch("grow", self.bar(), *common, "--guard").stdout.decode()
        self.assertIn("stopped at", said)

    def test_takes_the_material_at_the_seed_if_no_range_is_given(self):
        path = self.volume(lambda x, y, z: (150 if x < 20 else 60) + ((x * 73856093 ^ y * 19349663 ^ z * 83492791) >> 5) % 5)
        report = self.report("grow", path, "--seed", "4,9,9", "-o", "l.nrrd")
        self.assertEqual(report["voxels"], 20 * SIZE * SIZE)

    def test_adds_to_labels_and_grows_within_one(self):
        path = self.volume(lambda x, y, z: 100)
        self.volume(lambda x, y, z: 7 if x < 10 else 0, "given.nrrd")
        outside = self.report("grow", path, "--labels", "given.nrrd", "--seed", "15,9,9", "--range", "50,150", "--name", "rest",
                              "-o", "l.seg.nrrd")
        self.assertEqual(outside["voxels"], 30 * SIZE * SIZE)
        self.assertEqual(outside["structure"], 8)
        self.assertIn(b":=rest", (self.folder / "l.seg.nrrd").read_bytes())
        inside = self.report("grow", path, "--labels", "given.nrrd", "--seed", "2,9,9", "--range", "50,150", "--within", "7",
                             "-o", "m.nrrd")
        self.assertEqual(inside["voxels"], 10 * SIZE * SIZE)

    def test_a_streamed_volume_grows_in_the_voxels_of_its_finest_level(self):
        whole = self.sample("vessels", 160, "v.nrrd")
        self.run_batch("convert", whole, "v.ome.zarr")
        streamed = {"VELUM_WHOLE_MB": "1"}
        bright = self.brightest(whole)
        common = ("--seed", bright, "--range", "700,3000", "--closing", "2", "--fill-holes", "--json")
        reports = [json.loads(self.run_batch("grow", file, *common, "-o", f"{file}.l.nrrd", env=streamed).stdout)
                   for file in ("v.nrrd", "v.ome.zarr")]
        self.assertGreater(reports[0]["voxels"], 2000)
        for key in ("voxels", "smoothed", "volume", "box", "values"):
            self.assertEqual(reports[0][key], reports[1][key], key)
        self.assertEqual((self.folder / "v.nrrd.l.nrrd").read_bytes(), (self.folder / "v.ome.zarr.l.nrrd").read_bytes())
        # In scenes as on the command line.
        scene = {"velum": 2, "volume": {"source": {"path": "v.ome.zarr"}},
                 "labels": {"growths": [{"structure": 1, "seeds": [[float(n) for n in bright.split(",")]], "low": 700, "high": 3000}]}}
        (self.folder / "s.json").write_text(json.dumps(scene))
        self.run_batch("convert", "s.json", "s.nii", env=streamed)
        self.run_batch("grow", whole, *common[:4], "-o", "p.nii")
        ids = [(self.folder / name).read_bytes()[-160 ** 3:] for name in ("s.nii", "p.nii")]  # without names and colours
        self.assertGreater(sum(ids[0]), 2000)
        self.assertEqual(ids[0], ids[1])
        # A store that lost a piece: one line.
        shards = sorted(p for p in (self.folder / "v.ome.zarr" / "0").rglob("*") if p.is_file() and p.stat().st_size > 5000)
        for shard in shards:
            shard.write_bytes(shard.read_bytes()[:4000])
        self.refuse("grow", "v.ome.zarr", *common[:4], "-o", "d.nrrd", code=2)

    def brightest(self, path):
        """The place of the brightest voxel, x,y,z."""
        data = path.read_bytes()
        head, samples = data.split(b"\n\n", 1)
        lines = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
        if lines["encoding"] == "gzip":
            samples = zlib.decompress(samples, 31)
        sizes = [int(n) for n in lines["sizes"].split()]
        values = array.array("H", samples)
        x, y, z = (lambda i: (i % sizes[0], i // sizes[0] % sizes[1], i // (sizes[0] * sizes[1])))(values.index(max(values)))
        axes = [[float(n) for n in axis.strip("()").split(",")] for axis in lines["space directions"].split()]
        origin = [float(n) for n in lines["space origin"].strip("()").split(",")]
        return ",".join(str(origin[i] + axes[0][i] * x + axes[1][i] * y + axes[2][i] * z) for i in range(3))

    def test_stops_at_steep_places(self):
        path = self.volume(lambda x, y, z: 100 if x < 20 else 130)
        report = self.report("grow", path, "--seed", "2,2,2", "--range", "50,150", "--steepest", "20", "-o", "l.nrrd")
        self.assertEqual(report["voxels"], 19 * SIZE * SIZE)

    def test_grows_from_several_places_and_from_strokes(self):
        # Four bars along z.
        path = self.volume(lambda x, y, z: 200 if x % 10 < 4 and 10 <= y < 14 else 20)
        bar = 4 * 4 * SIZE
        one = self.report("grow", path, "--seed", "1,6,5", "--range", "150,250", "-o", "l.nrrd")
        self.assertEqual(one["voxels"], bar)
        two = self.report("grow", path, "--seed", "1,6,5", "--seed", "16,6,5", "--range", "150,250", "-o", "l.nrrd")
        self.assertEqual(two["voxels"], 2 * bar)
        # Across three of them, and over what lies between, by the material where it begins.
        stroke = self.report("grow", path, "--stroke", "1,6,5;6,6.5,5;11,6,5", "--range", "150,250", "-o", "l.nrrd")
        self.assertEqual(stroke["voxels"], 3 * bar)
        both = self.report("grow", path, "--stroke", "1,6,5;11,6,5", "--seed", "16,6,5", "--range", "150,250", "-o", "l.nrrd")
        self.assertEqual(both["voxels"], 4 * bar)

    def test_gives_up_what_it_is_told_that_it_is_not(self):
        bar = self.bar()
        common = ("grow", bar, "--seed", "6,11,5", "--range", "150,250", "-o", "l.nrrd")
        leaked = self.report(*common)["voxels"]
        told = self.report(*common, "--not", "15,15,17")
        # The bar, but for what lies at its end; not the wall.
        self.assertGreater(told["voxels"], 24 * 16)
        self.assertLess(told["voxels"], 30 * 16 + 0.05 * (leaked - 30 * 16))
        stroke = self.report(*common, "--not-stroke", "2,2,17;17,17,17")
        self.assertLess(stroke["voxels"], told["voxels"] + 16)
        self.assertGreater(stroke["voxels"], 24 * 16)
        # Fields of a scene say the same.
        step = {"structure": 1, "seeds": [[6, 11, 5]], "others": [[15, 15, 17]], "low": 150, "high": 250}
        scene = {"velum": 2, "volume": {"source": {"path": str(bar)}}, "labels": {"growths": [step]}}
        (self.folder / "s.json").write_text(json.dumps(scene))
        self.run_batch("convert", "s.json", "m.seg.nrrd")
        self.assertEqual(self.report("info", "m.seg.nrrd")["structures"][0]["voxels"], told["voxels"])

    def test_smooths_what_has_grown(self):
        # A box with a hole in its middle and a slit of one voxel from its face. Balls of a voxel fit into the hole but for its
        # edges, and into the slit's rim.
        def value(x, y, z):
            inside = all(10 <= c < 30 for c in (x, y, z))
            hole = all(18 <= c < 22 for c in (x, y, z))
            slit = x == 12 and z >= 26
            return 200 if inside and not hole and not slit else 20
        path = self.volume(value)
        common = ("grow", path, "--seed", "8,8,8", "--range", "150,250", "-o", "l.nrrd")
        rough = self.report(*common)
        self.assertEqual((rough["voxels"], rough["smoothed"]), (20 ** 3 - 4 ** 3 - 4 * 20, 0))
        filled = self.report(*common, "--fill-holes")
        self.assertEqual((filled["voxels"], filled["smoothed"]), (20 ** 3 - 4 * 20, 4 ** 3))
        closed = self.report(*common, "--closing", "0.6")
        self.assertEqual(closed["voxels"], 20 ** 3 - 4 ** 3 // 2 - 26)
        self.assertEqual(self.report(*common, "--closing", "0.6", "--fill-holes")["voxels"], 20 ** 3 - 26)

    def test_refuses_in_one_line(self):
        bar = self.bar()
        out = ("-o", "l.nrrd")
        at = ("--seed", "6,11,5")
        self.refuse("grow", bar, "--seed", "60,11,5", *out, code=1, words=["--seed", "60,11,5", "outside"])
        self.refuse("grow", bar, "--seed", "6,11", *out, code=1, words=["--seed", "x,y,z"])
        self.refuse("grow", bar, *at, "--range", "10,50", *out, code=1, words=["--seed", "190", "10", "50"])
        self.refuse("grow", bar, *at, "--range", "50,10", *out, code=1, words=["--range"])
        self.refuse("grow", bar, *at, "--distance", "5", *out, code=1, words=["--distance", "--plane"])
        self.refuse("grow", bar, *at, "--guard", *out, code=1, words=["--guard", "--plane"])
        self.refuse("grow", bar, *at, "--plane", "0,0,0,1", *out, code=1, words=["--plane"])
        self.refuse("grow", bar, *at, "--plane", "0,0,1,1", "--distance", "-2", *out, code=1, words=["--distance", "-2"])
        self.refuse("grow", bar, *at, "--within", "3", *out, code=1, words=["--within", "3"])
        self.refuse("grow", bar, *out, code=1, words=["--seed"])
        self.refuse("grow", bar, "--range", "150,250", *out, code=1, words=["--seed", "--stroke"])
        self.refuse("grow", bar, "--stroke", "6,11,5;6,60,5", *out, code=1, words=["--stroke", "6,60,5", "outside"])
        self.refuse("grow", bar, "--stroke", "1,1,1;2,1,1", "--range", "150,250", *out, code=1, words=["--stroke", "150"])
        self.refuse("grow", bar, *at, "--not", "60,11,5", *out, code=1, words=["--not", "60,11,5", "outside"])
        self.refuse("grow", bar, *at, "--not", "1,1,1", "--range", "150,250", *out, code=1, words=["--not", "1,1,1", "150"])
        self.refuse("grow", bar, *at, "--not-stroke", "1,1,1;2,1,1", "--range", "150,250", *out, code=1, words=["--not-stroke"])
        self.refuse("grow", bar, *at, "--not", "15,15,17", "--plane", "0,0,1,1", "--guard", *out, code=1, words=["--guard", "--not"])
        self.refuse("grow", bar, *at, "--closing", "-1", *out, code=1, words=["--closing"])
        self.refuse("grow", bar, *at, code=1, words=["--output"])
        self.refuse("grow", "none.nrrd", *at, *out, code=2, words=["none.nrrd"])
        self.refuse("grow", bar, *at, "-o", "l.xyz", code=2, words=["l.xyz"])
        self.assertFalse((self.folder / "l.nrrd").exists())


if __name__ == "__main__":
    unittest.main()
