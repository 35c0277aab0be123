"""What is stopped, or fails, has not been done: scene, history and what is open are as they were."""
import os
import signal
import unittest

from support import Case, ball

import velum


class Stopped(LookupError):
    pass


def told(session):
    """All that can be seen of a session."""
    voxels = session.voxels
    return session[""], session.commands(), voxels and voxels.array.ctypes.data, repr(session)


class Nothing(Case):
    def setUp(self):
        super().setUp()
        self.session = velum.open(ball())
        self.addCleanup(self.session.close)

    def stop_at(self, word=""):
        """Stops the work when it tells that it is at something."""
        def refuse(fraction, what):
            if word in what:
                raise Stopped(what)

        self.session.progress = refuse

    def expect_nothing(self, run, word="", kind=Stopped):
        before = told(self.session)
        self.stop_at(word)
        with self.assertRaises(kind):
            run(self.session)
        self.session.progress = None
        self.assertEqual(told(self.session), before)

    def test_of_a_command_when_the_history_is_full(self):
        for step in range(205):
            self.session["rayCast.stepVoxels"] = 0.5 + step / 1000
        self.expect_nothing(lambda s: s.membrane.hang((500, 3000)), "membrane")
        for _ in range(200):
            self.session.undo()
        with self.assertRaises(velum.InputError):
            self.session.undo()

    def test_of_what_can_be_done_again(self):
        self.session["rayCast.mode"] = "mip"
        self.session.undo()
        self.expect_nothing(lambda s: s.membrane.hang((500, 3000)), "membrane")
        self.session.redo()
        self.assertEqual(self.session["rayCast.mode"], "mip")

    def test_of_opening(self):
        velum.Volume(ball(side=24)).save(self.folder / "small.nrrd")
        self.session.cut("plane", name="mine")
        self.expect_nothing(lambda s: s.open(self.folder / "small.nrrd"))  # it is read before the first pulse
        with velum.open(self.folder / "small.nrrd") as other:
            other.membrane.hang((500, 3000))
            other.save(self.folder / "hung.json")
        self.expect_nothing(lambda s: s.open(self.folder / "hung.json"), "membrane")
        self.session.undo()
        self.assertEqual(self.session["cuts"], [])

    def test_of_undo_redo_and_growing(self):
        """Each lets a sheet hang anew."""
        self.session.membrane.hang((500, 3000))
        self.session.undo()
        self.expect_nothing(lambda s: s.redo(), "membrane")
        self.session.redo()
        self.expect_nothing(lambda s: s.grow((15.5, 15.5, 15.5), range=(500, 1500)), "membrane")
        self.assertIsNone(self.session.labels)
        self.session.grow((15.5, 15.5, 15.5), range=(500, 1500), name="ball")
        self.expect_nothing(lambda s: s.undo(), "membrane")
        self.assertEqual(self.session["labels.structures"][-1]["name"], "ball")
        self.session.undo()
        self.session.undo()
        self.assertEqual(self.session["cuts"], [])

    def test_of_a_cut_and_its_fields(self):
        self.session["rayCast.mode"] = "mip"
        self.session.undo()
        self.expect_nothing(lambda s: s.cut("box", face="section", axle=(0, 0, 1)), "never", velum.ArgumentError)
        self.session.redo()
        self.assertEqual(self.session["rayCast.mode"], "mip")

    def test_an_interrupt_that_comes_at_the_end(self):
        velum.Volume(ball(side=24)).save(self.folder / "small.nrrd")
        before = told(self.session)
        self.session.progress = lambda fraction, what: os.kill(os.getpid(), signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            self.session.open(self.folder / "small.nrrd")
        self.session.progress = None
        self.assertEqual(told(self.session), before)


class Meanwhile(Case):
    """What progress calls can cancel and close the session, and nothing else."""

    def setUp(self):
        super().setUp()
        velum.Volume(ball(side=24)).save(self.folder / "small.nrrd")
        self.session = velum.open(ball())
        self.addCleanup(self.session.close)

    def test_it_cancels(self):
        before = told(self.session)
        self.session.progress = lambda fraction, what: self.session.cancel()
        with self.assertRaises(velum.Cancelled):
            self.session.open(self.folder / "small.nrrd")
        self.session.progress = None
        self.assertEqual(told(self.session), before)

    def test_it_closes(self):
        self.session.progress = lambda fraction, what: self.session.close()
        with self.assertRaises(velum.Cancelled):
            self.session.open(self.folder / "small.nrrd")
        with self.assertRaisesRegex(velum.ArgumentError, "closed"):
            self.session.undo()

    def test_it_asks(self):
        self.session.progress = lambda fraction, what: self.session["camera.eye"]
        with self.assertRaisesRegex(velum.ArgumentError, "at work"):
            self.session.open(self.folder / "small.nrrd")


if __name__ == "__main__":
    unittest.main()
