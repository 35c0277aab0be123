"""velum-batch each."""
import contextlib
import fcntl
import json
import os
import signal
import subprocess
import time
import unittest

from velum_cli import PROGRAM, CliTest

FAST = ["--samples", "1", "--set", "lighting.shaded=false", "--size", "48x32"]
SLOW = ["--samples", "64", *FAST[2:]]
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

    def test_a_file_has_one_record_however_it_is_called(self):
        self.each("-o", "out/{dir}/{name}.png")
        (self.folder / "way").symlink_to("out")
        for output in ("out/{dir}/{name}.png", "./out/../out/p1/../{name}/{name}.png", f"{self.folder}/out/{{dir}}/{{name}}.png",
                       "way/{dir}/{name}.png"):
            with self.subTest(output=output):
                self.assertEqual(set(self.each("-o", output).values()), {"kept"})
        said = self.run_batch("each", "studies/p1/ct.nrrd", *FAST, "-o", "out/p1/p1.png", "--list").stdout.decode()
        self.assertEqual(said, "done     studies/p1/ct.nrrd\n")
        self.each("-o", "elsewhere/{name}.png", "--records", "records")
        states = self.each("-o", f"{self.folder}/elsewhere/{{name}}.png", "--records", f"{self.folder}/records")
        self.assertEqual(set(states.values()), {"kept"})
        self.assertEqual(sorted(path.name for path in (self.folder / "elsewhere").iterdir()), [f"p{i}.png" for i in range(6)])
        self.refuse("each", PATTERN, "-o", "out/{name}.png", "-o", "way/{name}.png", code=1, words=["would both become"])
        # What lies beside outputs is no data.
        self.each("-o", "beside/{name}.png")
        said = self.run_batch("each", "beside/*", *FAST, "-o", "beside/{name}.png", "--list").stdout.decode()
        self.assertEqual(said, "".join(f"missing  beside/p{i}.png\n" for i in range(6)))

    def test_a_folder_that_cannot_be_written_fails_alone(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/p3").write_text("no folder")
        states = self.each("-o", "out/{dir}/{name}.png", code=2)
        self.assertEqual(states, {f"p{i}": "failed" if i == 3 else "done" for i in range(6)})

    def is_locked(self, path):
        with contextlib.suppress(FileNotFoundError), open(path, "rb") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return True
        return False

    def stopped_in_a_piece(self, *more):
        """A process that was stopped while it makes a piece, and the piece's name."""
        running = subprocess.Popen([PROGRAM, "each", PATTERN, *SLOW, *more], cwd=self.folder)
        self.addCleanup(running.wait)
        self.addCleanup(running.kill)
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if any(self.folder.glob("*/.velum-lock-*")):
                running.send_signal(signal.SIGSTOP)
                os.waitid(os.P_PID, running.pid, os.WSTOPPED)
                held = [path.name.split("-")[-1].split(".")[0] for path in self.folder.glob("*/.velum-lock-*") if self.is_locked(path)]
                # All outputs, and not those of a piece that it begins or ends.
                if held and len(held) == more.count("-o"):
                    return running, held.pop()
                running.send_signal(signal.SIGCONT)
            time.sleep(0.001)
        self.fail("it was never at work")

    def test_a_second_output_has_one_writer_and_what_another_makes_is_waited_for(self):
        other, held = self.stopped_in_a_piece("-o", "a/{name}.png", "-o", "both/{name}.csv")
        waiting = subprocess.Popen([PROGRAM, "each", PATTERN, *FAST, "-o", "b/{name}.png", "-o", "both/{name}.csv", "--json"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(waiting.kill)
        self.assertEqual(waiting.stderr.readline(), b"note: waiting for 1 piece that another process makes\n")
        self.assertEqual(sorted(self.outputs("b")), [f"p{i}.png" for i in range(6) if f"p{i}" != held], "the other has its table")
        # make, and whoever else goes by exit codes, is told that a file is there when it is.
        other.kill()
        lines = waiting.communicate(timeout=60)[0].decode().splitlines()
        self.assertEqual(waiting.returncode, 0)
        states = [(line["name"], line["state"]) for line in map(json.loads, lines)]
        self.assertEqual(states, [*((f"p{i}", "done") for i in range(6) if f"p{i}" != held), (held, "done")])
        self.assertIn(f"{held}.png", self.outputs("b"))

    def test_a_part_without_pieces_says_so_and_tasks_with_data_of_their_own_are_told(self):
        done = self.run_batch("each", PATTERN, *FAST, "-o", "out/{name}.png", "--part", "8/9")
        self.assertEqual(done.stderr.decode(), "note: part 8 of 9 has nothing to do, as there are 6 pieces\n")
        array = {"SLURM_ARRAY_TASK_ID": "2", "SLURM_ARRAY_TASK_MIN": "1", "SLURM_ARRAY_TASK_MAX": "6", "SLURM_ARRAY_TASK_COUNT": "6"}
        own = ["each", "studies/p2/ct.nrrd", *FAST, "-o", "out/p2.png"]
        said = self.run_batch(*own, env=array).stderr.decode()
        self.assertEqual(said, "warning: SLURM_ARRAY_TASK_ID is 2: part 2 of 6 has nothing to do, as there is 1 piece; "
                         "where each task has data of its own, say --part 1/1\n")
        self.assertEqual(self.run_batch(*own, "--part", "1/1", env=array).stderr, b"")
        self.assertTrue((self.folder / "out/p2.png").exists())

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
