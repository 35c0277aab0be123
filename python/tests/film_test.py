"""Films: the bytes of velum-batch, arrays of frames, stopping."""
import gc
import json
import pathlib
import re
import unittest

from support import PROGRAM, Case, ball, numpy, read_png

import velum

WORDS = ["--size", "96x72", "--samples", "1"]
HOW = {"size": "96x72", "samples": 1}


class Films(Case):
    def setUp(self):
        super().setUp()
        self.session = velum.open(self.sample())
        self.addCleanup(self.session.close)
        self.session["timeline.framesPerSecond"] = 4
        self.session.cut(shape="plane", face="section")

    def batch(self, *words):
        return self.run_program(PROGRAM, "film", *words, *WORDS)

    def frames_in(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).glob("*.png")}

    def test_bytes_are_those_of_the_program(self):
        s = self.session
        s.film.turn(seconds=2)
        s.film.key("cuts[0].faceOpacity", 0, 0)
        s.film.key("cuts[0].faceOpacity", 1.5, 1)
        s.save(self.folder / "story.json")
        s.film(self.folder / "mine.mp4", **HOW)
        self.batch("story.json", "-o", "theirs.mp4")
        self.assertEqual((self.folder / "mine.mp4").read_bytes(), (self.folder / "theirs.mp4").read_bytes())
        s.film(f"{self.folder}/mine/", **HOW, blur=3, shutter=0.4)
        self.batch("story.json", "-o", "theirs/", "--blur", "3", "--shutter", "0.4")
        self.assertEqual(self.frames_in("mine"), self.frames_in("theirs"))
        self.assertEqual(len(self.frames_in("mine")), 8)

    def test_a_ready_made_film_leaves_the_scene_as_it_is(self):
        s = self.session
        s.save(self.folder / "still.json")
        before = s.commands()
        s.film(self.folder / "mine.gif", **HOW, animate="turn gently=true", seconds=1)
        self.batch("still.json", "-o", "theirs.gif", "--animate", "turn gently=true", "--seconds", "1")
        self.assertEqual((self.folder / "mine.gif").read_bytes(), (self.folder / "theirs.gif").read_bytes())
        self.assertEqual(s.commands(), before)
        self.assertEqual(s["timeline.tracks"], [])
        # Without any film it is the usual one, as of the program.
        s.film(f"{self.folder}/mine/", **HOW, part="2/16")
        self.batch("still.json", "-o", "theirs/", "--part", "2/16")
        self.assertEqual(self.frames_in("mine"), self.frames_in("theirs"))

    def test_frames_are_those_of_the_files(self):
        s = self.session
        s.film.turn(seconds=1)
        s.film(f"{self.folder}/out/", **HOW)
        files = [read_png(data) for _, data in sorted(self.frames_in("out").items())]
        frames = []
        for frame in s.frames(96, 72, samples=1):
            frames.append(frame)
            s.film.clear()  # changes nothing of what is drawn
            s.render(48, 36)
        self.assertEqual(len(frames), 4)
        self.assertEqual((type(frames[0]), frames[0].dtype), (velum.Image, numpy.uint8))
        numpy.testing.assert_array_equal(frames, files)
        self.assertGreater(numpy.abs(frames[0].astype(int) - frames[2]).mean(), 0.5)
        fine = next(s.frames(96, 72, samples=1, animate="turn", seconds=1, dtype="float32", transparent=True))
        self.assertEqual((fine.shape, fine.dtype), ((72, 96, 4), numpy.float32))
        self.assertEqual(next(s.frames(96, 72, section="axial", animate="turn", seconds=1)).shape, (72, 96, 3))

    def test_frames_that_are_left_end_with_their_session(self):
        with velum.open(ball()) as s:
            left = s.frames(48, 36, samples=1, animate="turn", seconds=1)
            next(left)
        with self.assertRaisesRegex(velum.ArgumentError, "closed"):
            next(left)
        s = velum.open(ball())
        some = s.frames(48, 36, samples=1, animate="turn", seconds=1)
        next(some)
        del s
        next(some)  # they hold the session
        del some
        gc.collect()

    def test_wrong_words_are_refused_in_one_line(self):
        s = self.session
        for call, word in ((lambda: s.film("turn.avi"), "mp4"), (lambda: s.film("a.mp4", animate="spin"), "turn"),
                           (lambda: s.film("a.mp4", layers=True), "layers"), (lambda: s.film("a.mp4", blur=300), "256"),
                           (lambda: s.film("a.mp4", section="diagonal"), "axial"), (lambda: s.film(), "path"),
                           (lambda: next(s.frames(96, 72, blur=0)), "outside 1 .. 256"), (lambda: next(s.frames(96, 72, dtype="int16")), "uint8"),
                           (lambda: next(s.frames(96, 72, animate="cut", seconds=-1)), "seconds")):
            with self.subTest(word=word), self.assertRaises(velum.Error) as caught:
                call()
            self.assertIn(word, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        s.film.turn(seconds=1)
        with self.assertRaisesRegex(velum.ArgumentError, "film of its own"):
            s.film("a.mp4", seconds=3)

    def test_stopped_it_keeps_what_was_drawn_and_goes_on_from_there(self):
        s = self.session
        s.film.turn(seconds=4)
        told, slow = [], {**HOW, "samples": 16}

        def stop(share, what):
            told.append((share, what))
            if what.startswith("Frame ") and int(re.findall("[0-9]+", what)[0]) >= 5:  # not each is told
                raise KeyboardInterrupt
        s.progress = stop
        with self.assertRaises(KeyboardInterrupt):
            s.film(f"{self.folder}/out/", **slow)
        s.progress = None
        there = len(self.frames_in("out"))
        self.assertTrue(3 <= there < 16, there)
        self.assertEqual([share for share, _ in told], sorted(share for share, _ in told))
        s.film(f"{self.folder}/out/", **slow, resume=True)
        self.assertEqual(len(self.frames_in("out")), 16)
        records = [json.loads(line) for line in (self.folder / "out/film.jsonl").read_text().splitlines()]
        self.assertEqual(sum("frame" in record for record in records), 16)


if __name__ == "__main__":
    unittest.main()
