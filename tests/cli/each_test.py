"""velum-batch each."""
import json
import os
import signal
import subprocess
import time
import unittest

from velum_cli import PROGRAM, CliTest

FAST = ["--samples", "1", "--set", "lighting.shaded=false", "--size", "48x32"]
PATTERN = "studies/*/ct.nrrd"


class Each(CliTest):
    def setUp(self):
        super().setUp()
        for i in range(6):
            (self.folder / f"studies/p{i}").mkdir(parents=True)
            self.sample(voxels=16 + 2 * i, file=f"studies/p{i}/ct.nrrd")

    def each(self, *more, code=0, env=None):
        """The states of pieces, by name."""
        done = self.run_batch("each", PATTERN, *FAST, "--json", *more, code=code, env=env)
        return {line["name"]: line["state"] for line in map(json.loads, done.stdout.decode().splitlines())}

    def outputs(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).glob("*.png")}

    def test_each_piece_is_the_picture_that_render_makes(self):
        self.assertEqual(self.each("-o", "out/{name}.png"), {f"p{i}": "done" for i in range(6)})
        self.assertEqual(sorted(self.outputs("out")), [f"p{i}.png" for i in range(6)])
        (self.folder / "one").mkdir()  # as deep, since a picture tells the way to its data
        self.run_batch("render", "studies/p3/ct.nrrd", "-o", "one/p3.png", *FAST)
        self.assertEqual(self.outputs("out")["p3.png"], self.outputs("one")["p3.png"])

    def test_what_is_done_is_kept_until_data_or_options_change(self):
        self.each("-o", "out/{name}.png")
        before = self.outputs("out")
        self.assertEqual(set(self.each("-o", "out/{name}.png").values()), {"kept"})
        self.sample(voxels=30, file="studies/p2/ct.nrrd")
        (self.folder / "out/p4.png").unlink()
        (self.folder / "out/p5.png").write_bytes(b"x" * len(before["p5.png"]))
        self.assertEqual(self.each("-o", "out/{name}.png"),
                         {"p0": "kept", "p1": "kept", "p2": "done", "p3": "kept", "p4": "done", "p5": "done"})
        after = self.outputs("out")
        self.assertEqual([name for name in before if before[name] != after[name]], ["p2.png"])
        self.assertEqual(set(self.each("-o", "out/{name}.png", "--view", "left").values()), {"done"})
        self.assertEqual(set(self.each("-o", "out/{name}.png", "--view", "left", "--again").values()), {"done"})

    def test_what_cannot_be_read_fails_alone_and_is_tried_again(self):
        good = (self.folder / "studies/p1/ct.nrrd").read_bytes()
        (self.folder / "studies/p1/ct.nrrd").write_bytes(b"junk")
        states = self.each("-o", "out/{name}.png", code=2)
        self.assertEqual([name for name, state in states.items() if state == "failed"], ["p1"])
        said = self.run_batch("each", PATTERN, *FAST, "-o", "out/{name}.png", "--list").stdout.decode()
        self.assertIn("failed   studies/p1/ct.nrrd: is not a NRRD file\n", said)
        self.assertEqual(said.count("done "), 5)
        self.each("-o", "by/{name}.png", "--set", "labels.structures[none].visible=false", code=2)
        (self.folder / "studies/p1/ct.nrrd").write_bytes(good)
        states = self.each("-o", "out/{name}.png")
        self.assertEqual([name for name, state in states.items() if state == "done"], ["p1"])

    def test_parts_make_the_whole_and_tasks_of_an_array_are_parts(self):
        self.each("-o", "whole/{name}.png")
        for k in (2, 1):
            self.assertEqual(len(self.each("-o", "parts/{name}.png", "--part", f"{k}/2")), 3)
        self.assertEqual(self.outputs("parts"), self.outputs("whole"))
        for task in (4, 6, 8, 10):
            self.each("-o", "tasks/{name}.png",
                      env={"SLURM_ARRAY_TASK_ID": str(task), "SLURM_ARRAY_TASK_MIN": "4", "SLURM_ARRAY_TASK_MAX": "10",
                           "SLURM_ARRAY_TASK_STEP": "2", "SLURM_ARRAY_TASK_COUNT": "4"})
        self.assertEqual(self.outputs("tasks"), self.outputs("whole"))

    def test_two_processes_at_once_make_each_piece_once_and_a_kill_loses_nothing(self):
        self.each("-o", "whole/{name}.png")
        command = [PROGRAM, "each", PATTERN, *FAST, "--json", "-o", "out/{name}.png"]
        both = [subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE) for _ in range(2)]
        states = [json.loads(line)["state"] for running in both for line in running.communicate(timeout=120)[0].splitlines()]
        self.assertEqual(states.count("done"), 6)
        self.assertEqual(len(states), 12)
        self.assertEqual(self.outputs("out"), self.outputs("whole"))
        running = subprocess.Popen([*command, "--again"], cwd=self.folder, stdout=subprocess.PIPE)
        running.stdout.readline()
        time.sleep(0.05)
        running.send_signal(signal.SIGKILL)
        running.communicate()
        states = self.each("-o", "out/{name}.png")
        self.assertGreaterEqual(list(states.values()).count("kept"), 4)
        self.assertEqual(self.outputs("out"), self.outputs("whole"))

    def test_what_ends_its_process_three_times_is_passed_over(self):
        self.each("-o", "out/{name}.png")
        record = self.folder / "out/pieces/p0.png.jsonl"
        begun = record.read_text().split("\n")[1]
        record.write_text(f"{begun}\n" * 3 + '{"half a li')
        self.assertEqual(self.each("-o", "out/{name}.png", code=2)["p0"], "failed")
        self.assertEqual(self.each("-o", "out/{name}.png", "--retry", "--part", "1/6")["p0"], "done")
        # Half a line is no attempt at all, whatever follows it.
        record.write_text(f'{begun}\n{{"half a li')
        self.each("-o", "out/{name}.png", "--part", "1/6", "--view", "left")
        self.assertEqual(self.each("-o", "out/{name}.png", "--part", "1/6")["p0"], "done", "that was of another view")

    def test_a_scene_is_carried_over_and_tables_are_made(self):
        script = self.folder / "cut.velum"
        script.write_text("open studies/p0/ct.nrrd\ncut.add plane\nmark.add distance points=0,0,0;1,0,0\nsave plan.json\n")
        self.run_batch("run", script)
        states = self.each("--scene", "plan.json", "-o", "out/{name}.png", "-o", "out/{name}.csv",
                           "--labels", "studies/{name}/ct_labels.seg.nrrd", "--structures")
        self.assertEqual(set(states.values()), {"done"})
        tables = [(self.folder / f"out/p{i}.csv").read_text() for i in range(6)]
        self.assertTrue(all("distance" in table and "structure" in table for table in tables))
        self.assertEqual(len(set(tables)), 6)

    def test_refusals(self):
        self.refuse("each", "nowhere/*.nrrd", "-o", "out/{name}.png", code=2, words=["there are no such files"])
        self.refuse("each", PATTERN, "-o", "out.png", code=1, words=["would both become out.png"])
        self.refuse("each", "studies/*", "-o", "studies/{name}/view.png", code=1, words=["lies in the data's folder"])
        self.refuse("each", PATTERN, "-o", "out/{name}.xyz", code=2)
        self.refuse("each", PATTERN, "-o", "out/{name}.png", "--part", "7/6", code=1, words=["K/N"])
        self.refuse("each", PATTERN, "-o", "out/{name}.png", "--scene", "none.json", code=2, words=["none.json"])
        self.assertFalse(os.path.exists(self.folder / "out/p0.png"))


if __name__ == "__main__":
    unittest.main()
