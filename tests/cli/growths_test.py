"""Scene files that say strange things of growing: one line and exit code 2, or a meaning that does no harm."""
import json
import unittest

from velum_cli import CliTest

# Of the two spheres in air: all that is no air.
SOUND = {"structure": 1, "seeds": [[0, 0, 0]], "low": 100, "high": 5000}
POINTS = 70000  # as many as a list may have


class Growths(CliTest):
    def setUp(self):
        super().setUp()
        self.sample(voxels=24, file="v.nrrd")

    def scene(self, steps, volume="v.nrrd", name="s.json"):
        steps = [{**SOUND, **step} for step in steps]
        text = json.dumps({"velum": 2, "volume": {"source": {"path": volume}}, "labels": {"growths": steps}})
        (self.folder / name).write_text(text)
        return name

    def picture(self, steps, name="p.png", **scene):
        self.run_batch("render", self.scene(steps, **scene), "-o", name, "--size", "32x32", "--samples", "1")
        return name

    def refuse_step(self, step, *words):
        self.refuse("render", self.scene([{}, step]), "-o", "p.png", code=2, words=["s.json", "labels.growths.1", *words])

    def test_values_that_no_step_can_have_are_refused(self):
        self.refuse_step({"structure": 0}, "structure", "0")
        self.refuse_step({"structure": 65536}, "structure", "65536")
        self.refuse_step({"structure": 1.5}, "structure", "1.5")
        self.refuse_step({"structure": "bone"}, "structure", "number")
        self.refuse_step({"seeds": [[0, 0]]}, "seeds.0", "3 numbers")
        self.refuse_step({"seeds": [[1e16, 0, 0]]}, "seeds.0", "1e+16")
        self.refuse_step({"seeds": [[0, 0, 0]] * (POINTS + 1)}, "seeds", "70001")
        self.refuse_step({"others": [[0, 0]]}, "others.0", "3 numbers")
        self.refuse_step({"others": [[0, 0, 0]] * (POINTS + 1)}, "others", "70001")
        self.refuse_step({"high": 1e301}, "high", "1e+301")
        self.refuse_step({"low": None}, "low", "number")
        self.refuse_step({"steepest": -1}, "steepest", "-1")
        self.refuse_step({"distance": -5}, "distance", "-5")
        self.refuse_step({"barriers": [{"path": [[0, 0, 0]], "radius": -1}]}, "barriers.0.radius", "-1")
        self.refuse_step({"barriers": [{"path": [[0, 0]]}]}, "barriers.0.path.0", "3 numbers")

    def test_what_the_volume_does_not_have_is_refused(self):
        for step, words in (({"channel": 5}, ["channel 5"]), ({"timeStep": 99}, ["time step 99"])):
            self.refuse("render", self.scene([{}, step]), "-o", "p.png", code=2, words=["s.json", "labels.growths", *words])

    def test_numbers_that_are_none_are_refused(self):
        for number in ("NaN", "Infinity", "1e400"):
            scene = self.folder / self.scene([{}])
            scene.write_text(scene.read_text().replace("5000", number))
            self.refuse("render", "s.json", "-o", "p.png", code=2, words=["s.json"])

    def test_a_list_of_steps_has_an_end(self):
        self.refuse("render", self.scene([{}] * 4097), "-o", "p.png", code=2, words=["labels.growths", "4097", "4096"])
        self.picture([{"structure": 1 + i % 9} for i in range(4096)])

    def test_steps_that_find_nothing_change_nothing(self):
        plain = self.picture([], "plain.png")
        self.run_batch("compare", plain, self.picture([{}]), "--max-fraction", "0", code=4)
        nothing = {
            "a seed outside the data": {"seeds": [[1e6, 0, 0]]},
            "a seed at the end of the world": {"seeds": [[1e15, -1e15, 1e15]]},
            "no seed": {"seeds": []},
            "a range upside down": {"low": 5000, "high": 100},
            "a range without the seed's value": {"low": 1e300, "high": 1e300},
            "within a structure that nobody has": {"within": 9},
            "a barrier over the seed": {"barriers": [{"path": [[0, 0, 0]], "radius": 1e9}]},
        }
        for what, step in nothing.items():
            with self.subTest(what):
                self.run_batch("compare", plain, self.picture([step]), "--max-fraction", "0")

    def test_a_barrier_without_places_holds_nothing_back(self):
        free = self.picture([{}], "free.png")
        for barrier in ({"path": []}, {"path": [[1e6, 0, 0]], "radius": 3}):
            held = self.picture([{"barriers": [barrier]}])
            self.run_batch("compare", free, held, "--max-fraction", "0")

    def test_the_largest_lists_and_numbers_end_in_time(self):
        line = [[i * 1e-3, 0, 0] for i in range(POINTS)]
        for step in ({"seeds": line}, {"others": line}, {"barriers": [{"path": line}]}, {"barriers": [{"path": line[:2]}] * POINTS},
                     {"low": -1e300, "high": 1e300}, {"axis": [1e-300, 0, 0], "distance": 5},
                     {"axis": [1e15, 1e15, 0], "distance": 1e15}, {"axis": [0, 0, 1], "centre": [1e15, 0, -1e15]},
                     {"closing": 1e9, "fillHoles": True}, {"closing": 40}, {"steepest": 0}):
            with self.subTest(step=str(step)[:80]):
                self.picture([step])

    def test_steps_of_another_volume_grow_where_they_can(self):
        # As when the file was replaced by one that is smaller, and lies elsewhere.
        head = ("NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\n"
                "space directions: (9,0,0) (0,9,0) (0,0,9)\nspace origin: (500,0,0)\nencoding: raw\n\n")
        (self.folder / "other.nrrd").write_bytes(head.encode() + bytes([0, 200] * 4))
        self.picture([{}, {"seeds": [[509, 0, 0]], "structure": 3}], volume="other.nrrd")


if __name__ == "__main__":
    unittest.main()
