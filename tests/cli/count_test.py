"""velum-batch count, and render with targets."""
import json
import csv
import unittest
import xml.etree.ElementTree

from velum_cli import CliTest

SMALL = ["--size", "160x120"]
BALL = ["--set", 'cuts=[{"id": 1, "shape": "sphere", "size": [700, 700, 700]}]']
STATES = ("visible", "hidden", "clipped")
WORDS = {"visible": "seen", "hidden": "hidden", "clipped": "removed"}  # in pictures


class Count(CliTest):
    def setUp(self):
        super().setUp()
        self.run_batch("sample", "virion", "-o", "v.cif.gz")

    def rows(self, report):
        return report["perType"] + report["perCompartment"]

    def count_of(self, report, name):
        return next(row for row in self.rows(report) if name in (row["name"], row["path"]))

    def test_every_instance_is_one_of_three(self):
        report = self.report("count", "v.cif.gz", *SMALL, *BALL)
        self.assertKeys(report, "renderer", "size", "perType", "perCompartment", "all")
        for row in [report["all"], *self.rows(report)]:
            self.assertEqual(sum(row[state] for state in STATES), row["total"])
        for key in (*STATES, "total"):
            self.assertEqual(sum(row[key] for row in report["perType"]), report["all"][key])
            self.assertGreater(report["all"][key], 0)
        for compartment in report["perCompartment"]:
            below = [row for row in report["perType"] if row["path"].startswith(compartment["path"] + ".")]
            self.assertEqual(sum(row["visible"] for row in below), compartment["visible"])
        instances = sum(row["instances"] for row in self.report("info", "v.cif.gz")["perType"])
        self.assertGreaterEqual(report["all"]["total"], instances)

    def test_its_files_say_the_same(self):
        report = self.report("count", "v.cif.gz", *SMALL, *BALL, "--csv", "c.csv", "--svg", "c.svg", "--instances", "i.csv")
        with open(self.folder / "c.csv", newline="") as file:
            table = {row["path"]: row for row in csv.DictReader(file)}
        self.assertEqual(len(table), len(self.rows(report)))
        for row in self.rows(report):
            self.assertEqual([row[key] for key in (*STATES, "total")], [int(table[row["path"]][key]) for key in (*STATES, "total")])
        with open(self.folder / "i.csv", newline="") as file:
            instances = list(csv.DictReader(file))
        self.assertEqual(len(instances), report["all"]["total"])
        for row in report["perType"]:
            for state in STATES:
                self.assertEqual(sum(i["type"] == row["path"] and i["state"] == state for i in instances), row[state])
        svg = xml.etree.ElementTree.parse(self.folder / "c.svg")
        told = [title.text for title in svg.iter("{http://www.w3.org/2000/svg}title")]
        for row in self.rows(report):
            for state in STATES:
                self.assertEqual(f"{row['path']}: {row[state]:,} {WORDS[state]}" in told, row[state] > 0)

    def test_counts_are_set(self):
        before = self.report("count", "v.cif.gz", *SMALL, *BALL)
        name = max(before["perType"], key=lambda row: min(row["clipped"], row["total"] - row["clipped"]))["path"]
        row = self.count_of(before, name)
        wanted = row["total"] - row["clipped"] + row["clipped"] // 3
        report = self.report("count", "v.cif.gz", *SMALL, *BALL, "--set-count", f"{name}={wanted}", "-o", "solved.json")
        row = self.count_of(report, name)
        self.assertEqual(row["visible"] + row["hidden"], wanted)
        self.assertEqual([(t["type"], t["rendered"], t["met"]) for t in report["targets"]], [(name, wanted, True)])
        again = self.report("count", "solved.json", *SMALL)
        self.assertEqual(again["perType"], report["perType"])
        rendered = self.report("render", "v.cif.gz", "-o", "x.png", *SMALL, *BALL, "--set-count", f"{name}={wanted}", "--samples", "1")
        self.assertEqual(rendered["targets"][0]["rendered"], wanted)
        self.run_batch("render", "solved.json", "-o", "y.png", *SMALL, "--samples", "1")
        self.run_batch("compare", "x.png", "y.png", "--max-diff", "0", "--max-fraction", "0")

    def test_a_scene_shows_what_its_cuts_say_not_what_was_once_wanted(self):
        name = self.report("info", "v.cif.gz")["perType"][0]["path"]
        self.report("count", "v.cif.gz", *SMALL, *BALL, "--set-count", f"{name}=30%", "-o", "solved.json")
        scene = json.loads((self.folder / "solved.json").read_text())
        scene["model"]["targets"] = [{"type": name, "visible": 3}]
        (self.folder / "other.json").write_text(json.dumps(scene))
        self.assertEqual(*(self.report("count", file, *SMALL)["perType"] for file in ("solved.json", "other.json")))
        met = self.report("count", "other.json", *SMALL, "--meet-targets")
        self.assertLessEqual(self.count_of(met, name)["visible"], 4)

    def test_shares_and_numbers_beyond_all_are_understood(self):
        row = max(self.report("count", "v.cif.gz", *SMALL)["perType"], key=lambda row: row["total"])
        half = self.report("count", "v.cif.gz", *SMALL, "--set-count", f"{row['path']}=50%")
        now = self.count_of(half, row["path"])
        self.assertEqual(now["visible"] + now["hidden"], round(row["total"] / 2))
        done = self.run_batch("count", "v.cif.gz", *SMALL, "--set-count", f"{row['path']}={row['total'] + 57}")
        self.assertIn("there are no more", done.stderr.decode())

    def test_what_shows_is_set_or_said_to_be_out_of_reach(self):
        before = self.report("count", "v.cif.gz", *SMALL)
        row = max(before["perType"], key=lambda row: row["visible"])
        wanted = row["visible"] // 2
        report = self.report("count", "v.cif.gz", *SMALL, "--set-visible", f"{row['path']}={wanted}")
        reached = self.count_of(report, row["path"])["visible"]
        self.assertEqual(reached, report["targets"][0]["visible"])
        self.assertLessEqual(abs(reached - wanted), max(1, wanted // 50))
        self.assertLessEqual(report["pictures"], 24)
        done = self.run_batch("count", "v.cif.gz", *SMALL, "--set-visible", f"{row['path']}={row['total']}")
        said = done.stderr.decode()
        self.assertRegex(said, r"warning: [\d,]+ of [\d,]+ .* seen, not [\d,]+: all are drawn")

    def test_tells_what_hides_a_type(self):
        whole = self.report("count", "v.cif.gz", *SMALL)
        inner = min((row for row in whole["perType"] if row["total"] > 20), key=lambda row: row["visible"] / row["total"])["path"]
        report = self.report("count", "v.cif.gz", *SMALL, "--what-hides", inner)["whatHides"]
        self.assertEqual(report["type"], inner)
        self.assertEqual(report["seen"] + sum(h["pixels"] for h in report["hiders"]), report["pixels"])
        self.assertGreater(report["hiders"][0]["share"], 0.3)
        self.assertNotIn(inner, [h["type"] for h in report["hiders"]])
        cleared = self.report("count", "v.cif.gz", *SMALL, "--what-hides", inner, "--clear-the-way", inner)
        self.assertGreater(cleared["whatHides"]["seen"], report["seen"])
        self.assertGreater(cleared["all"]["clipped"], 0)

    def test_a_table_for_people(self):
        text = self.run_batch("count", "v.cif.gz", *SMALL).stdout.decode()
        lines = text.splitlines()
        self.assertEqual(lines[0].split(), ["visible", "hidden", "clipped", "total"])
        self.assertEqual(len({len(line) for line in lines}), 1)

    def test_refusals(self):
        name = self.report("info", "v.cif.gz")["perType"][0]["path"]
        for arguments, code, words in ((["--set-count", f"{name}x=3"], 2, [name]), (["--what-hides", name[:-1]], 2, [name]),
                                       (["--set-count", name], 1, ["TYPE=N"]), (["--set-count", f"{name}=-1"], 1, ["TYPE=N"]),
                                       (["--set-count", f"{name}=2.5"], 1, ["2.5", "whole"]), (["--set-visible", f"{name}=101%"], 1, ["101%"]),
                                       (["--csv", "none/c.csv"], 2, ["none/c.csv"])):
            with self.subTest(arguments=arguments):
                self.refuse("count", "v.cif.gz", *SMALL, *arguments, code=code, words=words)
        self.refuse("count", self.sample(), *SMALL, code=2, words=["no model"])
        self.refuse("render", self.sample(), "-o", "x.png", "--set-count", "a=1", code=2, words=["no model"])


class CountAreas(CliTest):
    """Structures have areas where instances have numbers."""

    def setUp(self):
        super().setUp()
        volume = self.sample("torso", 40)
        self.scene = (volume, "torso_labels.seg.nrrd", "--view", "oblique", "--set", "cuts.+.axis=0.2,-1,0.3")

    def areas(self, *arguments):
        report = self.report("count", *self.scene, *arguments)
        return {row["name"]: row for row in report["perStructure"]}, report

    def test_every_pixel_of_a_structure_is_one_of_three(self):
        areas, report = self.areas()
        self.assertKeys(report, "renderer", "size", "ms", "perStructure")
        self.assertEqual(report["size"], [320, 180])
        listed = {s["name"] for s in self.report("info", "torso_labels.seg.nrrd")["structures"]}
        self.assertEqual(set(areas), listed)
        for row in areas.values():
            self.assertEqual(sum(row[state] for state in STATES), row["total"])
            self.assertAlmostEqual(row["visibleShare"], row["visible"] / (320 * 180))
        self.assertTrue(all(any(row[state] > 0 for row in areas.values()) for state in STATES))
        self.assertNotIn("targets", report)

    def test_its_files_say_the_same(self):
        areas, _ = self.areas(*SMALL, "--csv", "c.csv", "--svg", "c.svg")
        with open(self.folder / "c.csv", newline="") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), len(areas))
        for row in table:
            area = areas[row["name"]]
            self.assertEqual(int(row["structure"]), area["id"])
            self.assertEqual([int(row[key]) for key in (*STATES, "total")], [area[key] for key in (*STATES, "total")])
        xml.etree.ElementTree.parse(self.folder / "c.svg")
        text = self.run_batch("count", *self.scene, *SMALL).stdout.decode().splitlines()
        self.assertEqual(text[0].split(), ["visible", "hidden", "clipped", "total", "%"])
        self.assertEqual(len({len(line) for line in text}), 1)

    def test_areas_are_set(self):
        before, _ = self.areas()
        name = max(before, key=lambda name: before[name]["clipped"])
        row = before[name]
        wanted = row["visible"] + row["hidden"] + row["clipped"] // 2
        after, report = self.areas("--set-area", f"{name}={wanted}", "-o", "solved.json")
        target = report["targets"][0]
        self.assertEqual((target["structure"], target["wanted"], target["reached"], target["met"]), (row["id"], wanted, wanted, True))
        self.assertGreater(target["distance"], 0)
        # A few pixels of an outline are seen that no walk from voxel to voxel meets.
        self.assertAlmostEqual(after[name]["visible"] + after[name]["hidden"], wanted, delta=max(3, wanted // 50))
        again = self.report("count", "solved.json")
        self.assertEqual(again["perStructure"], report["perStructure"])
        _, by_number = self.areas("--set-area", f"{row['id']}=50%")
        # The percent is of what the walk meets; the total has the outline's pixels, too.
        self.assertAlmostEqual(by_number["targets"][0]["wanted"], row["total"] / 2, delta=wanted // 50)
        said = self.run_batch("count", *self.scene, "--set", "cuts.0.enabled=false", "--set-area", f"{name}=10").stderr.decode()
        self.assertRegex(said, "warning: .* no cut is on")

    def test_refusals(self):
        for arguments, code, words in ((["--set-area", "nothing=3"], 1, ["--set-area nothing=3", "no structure"]),
                                       (["--set-area", "1=120%"], 1, ["STRUCTURE=PERCENT%"]), (["--set-area", "1"], 1, ["STRUCTURE=PIXELS"]),
                                       (["--set-count", "a=1"], 2, ["no model", "--set-area"])):
            with self.subTest(arguments=arguments):
                self.refuse("count", *self.scene, *arguments, code=code, words=words)
        self.run_batch("sample", "virion", "-o", "v.cif.gz")
        self.refuse("count", "v.cif.gz", *SMALL, "--set-area", "1=3", code=2, words=["--set-area", "--set-count"])


if __name__ == "__main__":
    unittest.main()
