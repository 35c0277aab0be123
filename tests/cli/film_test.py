"""velum-batch film."""
import json
import os
import shutil
import signal
import struct
import subprocess
import time
import unittest
import zlib

from velum_cli import PROGRAM, CliTest

# Light costs seconds on a software driver.
FAST = ["--samples", "1", "--set", "lighting.shaded=false", "--size", "48x32"]
HAS_FFMPEG = shutil.which("ffmpeg") and shutil.which("ffprobe")


def probe(path):
    fields = "codec_name,width,height,pix_fmt,color_space,nb_read_frames,r_frame_rate"
    said = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", f"stream={fields}", "-of", "json", path],
                          capture_output=True, check=True, timeout=60)
    return json.loads(said.stdout)["streams"][0]


def samples_of(path):
    """The samples of a PNG without interlace, in order, as whole numbers of 8 or 16 bits."""
    data, at, packed = path.read_bytes(), 8, b""
    width, height, bits, kind = struct.unpack(">IIBB", data[16:26])
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if name == b"IDAT" else b""
        at += length + 12
    step, rows = {2: 3, 6: 4}[kind] * bits // 8, zlib.decompress(packed)
    above, out = bytes(width * step), b""
    for y in range(height):
        begin = y * (width * step + 1)
        way, row = rows[begin], bytearray(rows[begin + 1:begin + 1 + width * step])
        for i in range(len(row)):
            left, up, corner = row[i - step] if i >= step else 0, above[i], above[i - step] if i >= step else 0
            nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[way]) % 256
        above, out = bytes(row), out + row
    return struct.unpack(f">{len(out) * 8 // bits}{'H' if bits == 16 else 'B'}", out)


class Film(CliTest):
    def film(self, output, *more, frames=9, **options):
        return self.report("film", "two-spheres.nrrd", "-o", output, "--frames", frames, *FAST, *more, **options)

    def frames(self, name):
        """The bytes of all frames, by file."""
        return {path.name: path.read_bytes() for path in (self.folder / name).glob("frame-*.png")}

    def refuse_task(self, env):
        said = self.run_batch("film", "two-spheres.nrrd", "-o", "left/", "--frames", "9", *FAST, code=1, env=env).stderr.decode()
        self.assertIn("indices are left out", said)

    def setUp(self):
        super().setUp()
        self.sample()

    def test_parts_and_what_was_killed_are_the_bytes_of_the_whole(self):
        report = self.film("whole/")
        self.assertEqual((report["frames"], report["drawn"], report["kept"]), (9, 9, 0))
        whole = self.frames("whole")
        self.assertEqual(sorted(whole), [f"frame-{i:05}.png" for i in range(9)])
        for k in (2, 3, 1):
            self.assertEqual(self.film("parts/", "--part", f"{k}/3")["frames"], 3)
        self.assertEqual(self.frames("parts"), whole)
        # Tasks of an array are parts; a video is whole, and --part goes before.
        array = {"SLURM_ARRAY_TASK_MIN": "4", "SLURM_ARRAY_TASK_MAX": "8", "SLURM_ARRAY_TASK_STEP": "2", "SLURM_ARRAY_TASK_COUNT": "3"}
        for task in (8, 4, 6):
            own = {**array, "SLURM_ARRAY_TASK_ID": str(task)}
            self.assertEqual(self.film("tasks/", env=own)["frames"], 3)
        self.assertEqual(self.frames("tasks"), whole)
        said = self.run_batch("film", "two-spheres.nrrd", "-o", "tasks/", "--frames", "9", *FAST, "--resume", env=own).stderr
        self.assertEqual(said, b"note: SLURM_ARRAY_TASK_ID is 6, so this is part 2 of 3 of the frames; --part 1/1 draws all\n")
        self.assertEqual(self.film("all/", "--part", "1/1", env=own)["frames"], 9)
        if shutil.which("ffmpeg"):
            self.assertEqual(self.film("whole.mp4", env=own)["frames"], 9)
        self.refuse_task({**own, "SLURM_ARRAY_TASK_MAX": "20"})
        # Killed in the middle, three times: what is there is kept, and all is there in the end.
        command = [PROGRAM, "film", "two-spheres.nrrd", "-o", "killed/", "--frames", "9", *FAST, "--resume"]
        for wanted in (2, 4, 6):
            running = subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL)
            begin = time.monotonic()
            while len(self.frames("killed")) < wanted and running.poll() is None and time.monotonic() < begin + 60:
                time.sleep(0.002)
            running.send_signal(signal.SIGKILL)
            running.wait(timeout=60)
        report = self.film("killed/", "--resume")
        self.assertEqual(report["drawn"] + report["kept"], 9)
        self.assertGreaterEqual(report["kept"], 5)
        self.assertEqual(self.frames("killed"), whole)
        self.assertEqual([path.name for path in (self.folder / "killed").glob(".velum-*")], [])

    def test_a_frame_opens_as_its_scene_and_is_the_picture_of_render(self):
        self.film("turn.png", frames=4)
        self.run_batch("render", "turn-0002.png", "-o", "again.png", "--size", "48x32")
        self.assertEqual((self.folder / "again.png").read_bytes(), (self.folder / "turn-0002.png").read_bytes())

    def stop(self, name, is_time):
        """What a film says that is stopped by Ctrl+C as soon as it is time."""
        running = subprocess.Popen([PROGRAM, "film", "two-spheres.nrrd", "-o", name, "--frames", "100000", *FAST], cwd=self.folder,
                                   stderr=subprocess.PIPE)
        begin = time.monotonic()
        while not is_time() and running.poll() is None and time.monotonic() < begin + 60:
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        said = running.communicate(timeout=60)[1].decode()
        self.assertEqual(running.returncode, 130, said)
        self.assertIn("stopped", said)
        return said

    def test_ctrl_c_keeps_what_is_there(self):
        said = self.stop("frames/", lambda: len(self.frames("frames")) > 3)
        self.assertIn(f"holds {len(self.frames('frames'))} of 100000 frames; --resume", said)

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg is not installed: apt install ffmpeg")
    def test_ctrl_c_ends_a_video_that_plays(self):
        # What ffmpeg has written so far is seen beside it: frames have come.
        said = self.stop("a.mp4", lambda: any(path.stat().st_size > 0 for path in self.folder.glob(".velum-*")))
        self.assertIn(f"holds {probe(self.folder / 'a.mp4')['nb_read_frames']} of 100000 frames\n", said)
        self.assertEqual(list(self.folder.glob(".velum-*")), [])

    def test_another_film_is_refused(self):
        self.film("frames/", frames=2)
        self.refuse("film", "two-spheres.nrrd", "-o", "frames/", "--frames", 3, *FAST, code=2, words=["another film", "--overwrite"])
        self.refuse("film", "two-spheres.nrrd", "-o", "frames/", "--frames", 2, *FAST, "--animate", "turn", "--set", "background.top=1,0,0",
                    "--resume", code=2, words=["scene"])
        self.assertEqual(self.film("frames/", "--overwrite", frames=3)["drawn"], 3)

    def test_a_frame_that_fails_is_said_at_the_end(self):
        self.film("frames/", frames=3)
        (self.folder / "frames/frame-00001.png").unlink()
        (self.folder / "frames/frame-00001.png").mkdir()
        report = self.run_batch("film", "two-spheres.nrrd", "-o", "frames/", "--frames", 3, *FAST, "--resume", code=2)
        self.assertIn(b"1 of 3 frames could not be drawn: 1 (", report.stderr)
        self.assertEqual(len(report.stderr.splitlines()), 1)

    def test_command_lines_that_cannot_be_are_refused(self):
        for more in (["--part", "4/3"], ["--part", "half"], ["--blur", "0"], ["--shutter", "2"], ["--frames", "0"], ["--quality", "101"],
                     ["--bits", "12"], ["--animate", "fly"], ["--animate", "time"], ["--frames", "3", "--seconds", "1"]):
            with self.subTest(more=more):
                self.refuse("film", "two-spheres.nrrd", "-o", "frames/", *FAST, *more, code=1)
        self.refuse("film", "two-spheres.nrrd", "-o", "a.avi", *FAST, code=2, words=[".mp4", ".png", "folder"])
        self.refuse("film", "two-spheres.nrrd", "-o", "nowhere/a.png", *FAST, code=2, words=["folder"])
        self.refuse("film", "two-spheres.nrrd", "-o", "a.mp4", *FAST, "--part", "1/2", code=1, words=["parts"])
        self.assertFalse((self.folder / "frames").exists())

    def test_16_bits_hold_more_levels_of_the_same_picture(self):
        self.film("coarse.png", frames=2)
        self.film("fine.png", "--bits", "16", frames=2)
        coarse, fine = (samples_of(self.folder / f"{name}-0001.png") for name in ("coarse", "fine"))
        self.assertEqual(len(coarse), len(fine))
        self.assertGreater(sum(value % 257 != 0 for value in fine), len(fine) / 4)
        # The noise that hides the steps of the coarse one's background is half a level, as is rounding.
        self.assertLess(max(abs(a - b / 257) for a, b in zip(coarse, fine)), 1.01)

    def test_a_blurred_frame_is_the_mean_of_its_moments(self):
        # Four frames of a turn with a whole shutter: pictures 1/16 turn apart, around the frame's own place.
        self.film("blurred.png", "--bits", "16", "--blur", "4", "--shutter", "1", frames=4)
        self.film("moments.png", "--bits", "16", frames=32)
        moments = [samples_of(self.folder / f"moments-{i:04}.png") for i in (5, 7, 9, 11)]
        blurred = samples_of(self.folder / "blurred-0001.png")
        self.assertLess(max(abs(4 * a - sum(of)) for a, *of in zip(blurred, *moments)), 8)

    def animate(self, name, frames, *arguments):
        """The names of a film's frames, in order."""
        self.run_batch("film", *arguments, "-o", f"{name}.png", "--frames", frames)
        return [f"{name}-{i:04}.png" for i in range(frames)]

    def same(self, name, frame):
        self.run_batch("compare", name, frame, "--max-diff", "0", "--max-fraction", "0")

    def different(self, names):
        return len({(self.folder / name).read_bytes() for name in names})

    def test_structures_are_pulled_out_one_after_the_other(self):
        common = (self.sample("torso", 40), "torso_labels.seg.nrrd", "--set", "cuts.+.axis=0,-1,0", *FAST)
        spares = ["--set", 'cuts.0.spares=[{"structure": 1, "distance": 30}, {"structure": 2, "distance": 40}]']
        pull = ["--animate", "pull overlap=0 hold=0"]
        names = self.animate("pull", 5, *common, *spares, *pull)
        self.assertEqual(self.different(names), 5)
        # It begins with the plain cut, and ends with the scene itself.
        self.run_batch("render", *common, "-o", "plain.png")
        self.run_batch("render", *common, *spares, "-o", "all.png")
        self.same("plain.png", names[0])
        self.same("all.png", names[-1])
        # Sections go along.
        self.assertGreater(self.different(self.animate("cut", 3, *common, *spares, *pull, "--section", "axial")), 1)

    def test_a_model_is_cut_open_instance_by_instance(self):
        self.run_batch("sample", "virion", "-o", "v.cif")
        common = ("v.cif", "--view", "anterior", *FAST)
        cuts = ["--set", 'cuts.+={"axis": [0, -1, 0], "model": {"spares": [{"type": "root.plasma", "share": 0.3}]}}']
        names = self.animate("cut", 5, *common, *cuts, "--animate", "equalize hold=0")
        self.assertEqual(self.different(names), 5)
        # It begins without cuts, passes what the cuts take plainly, and ends with the scene itself.
        self.run_batch("render", *common, "-o", "whole.png")
        self.run_batch("render", *common, "--set", "cuts.+.axis=0,-1,0", "-o", "plain.png")
        self.run_batch("render", *common, *cuts, "-o", "scene.png")
        for name, frame in (("whole.png", 0), ("plain.png", 2), ("scene.png", 4)):
            self.same(name, names[frame])

    def test_a_cut_comes_in_from_where_the_data_ends(self):
        cut = ["--set", "cuts.+.axis=0,-1,0"]
        names = self.animate("cut", 3, "two-spheres.nrrd", *cut, *FAST, "--animate", "cut")
        self.run_batch("render", "two-spheres.nrrd", *FAST, "-o", "whole.png")
        self.run_batch("render", "two-spheres.nrrd", *cut, *FAST, "-o", "all.png")
        self.same("whole.png", names[0])
        self.same("all.png", names[2])

    def test_what_cannot_move_is_refused(self):
        film = ("two-spheres.nrrd", "-o", "x.png", "--frames", "3", *FAST, "--animate")
        for name, words in (("pull", ["no structure"]), ("time", ["no time steps"]), ("cut", ["no cut is on"]),
                            ("equalize", ["no model"]), ("jump", ["--animate jump", "turn", "pull"]), ("title", ["words"])):
            with self.subTest(name=name):
                self.refuse("film", *film, name, code=1, words=words)

    def test_a_title_is_over_its_part_of_a_turn(self):
        turn = ["two-spheres.nrrd", *FAST[:4], "--size", "480x320", "--fps", "4", "--animate", "turn"]
        plain = self.animate("plain", 4, *turn)
        titled = self.animate("titled", 4, *turn, "--animate", 'title "The two spheres" start=0.5 seconds=0.2 fade=0')
        for i, (a, b) in enumerate(zip(plain, titled)):
            self.run_batch("compare", a, b, "--max-diff", "0", "--max-fraction", "0", code=4 if i == 2 else 0)

    def test_what_was_grown_stays_out_over_a_beat(self):
        self.run_batch("sample", "heart", "-o", "heart.nrrd", "--voxels", "40", "--time-steps", "4")
        grown = {"structure": 1, "seeds": [[0, 0, 0]], "low": 250, "high": 600, "timeStep": 0}
        scene = ["--set", f"labels.growths=[{json.dumps(grown)}]", "--set", "cuts.+.axis=0,-1,0",
                 "--set", 'cuts.0.spares=[{"structure": 1, "distance": 40}]']
        names = self.animate("beat", 4, "heart.nrrd", *scene, *FAST)
        # Each frame is what its time step gives by itself.
        for t in (1, 3):
            self.run_batch("render", "heart.nrrd", "-o", "one.png", *scene, "--set", f"volume.timeStep={t}", *FAST)
            self.same("one.png", names[t])

    def test_a_membrane_follows_through_time_steps(self):
        self.run_batch("sample", "heart", "-o", "heart.nrrd", "--voxels", "40", "--time-steps", "4")
        self.run_batch("membrane", "heart.nrrd", "--protect", "200,600", "--axis", "0,-1,0", "--position", "0.4",
                       "--save-scene", "m.json")
        names = self.animate("beat", 4, "m.json", "--set", "cuts[Membrane].membrane.repositioning=active", *FAST)
        self.assertEqual(self.different(names), 4)
        # The first step is that of a passive sheet, later ones go on from it.
        self.run_batch("render", "m.json", "-o", "first.png", *FAST)
        self.run_batch("compare", "first.png", names[0])

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg is not installed: apt install ffmpeg")
    def test_videos_and_the_film_of_frames_that_are_there(self):
        for name, codec in (("a.mp4", "h264"), ("a.webm", "vp9"), ("a.gif", "gif")):
            self.film(name, "--fps", "20", frames=5)
            found = probe(self.folder / name)
            self.assertEqual((found["codec_name"], found["width"], found["height"], found["nb_read_frames"]), (codec, 48, 32, "5"))
        self.film("frames/", "--fps", "20", frames=5)
        self.assertEqual(self.report("film", "frames", "-o", "b.mp4")["frames"], 5)
        self.assertEqual((self.folder / "a.mp4").read_bytes(), (self.folder / "b.mp4").read_bytes())
        (self.folder / "frames/frame-00003.png").unlink()
        self.refuse("film", "frames", "-o", "c.mp4", code=2, words=["1 of 5 frames missing", ": 3;", "--resume"])
        self.assertFalse((self.folder / "c.mp4").exists())

    def test_without_ffmpeg_its_package_is_named(self):
        (self.folder / "empty").mkdir()
        done = self.run_batch("film", "two-spheres.nrrd", "-o", "a.mp4", *FAST, code=2, env={"PATH": str(self.folder / "empty")})
        self.assertEqual(done.stderr, b"velum-batch: ffmpeg is not installed: apt install ffmpeg\n")
        self.assertEqual(sorted(os.listdir(self.folder)), ["empty", "two-spheres.nrrd", "two-spheres_labels.seg.nrrd"])


if __name__ == "__main__":
    unittest.main()
