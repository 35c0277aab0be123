"""Threads, processes, progress, stopping, memory."""
import gc
import os
import signal
import threading
import time
import unittest

from support import Case, ball, numpy

import velum


def resident_mb():
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS")) / 1024


def long_work(session):
    """Takes seconds, and tells how far it is."""
    session.render(1600, 1200, samples=64)


class Threads(Case):
    def test_two_sessions_at_once_draw_what_one_draws_alone(self):
        def draw(mode):
            with velum.open(ball(inside=1000 if mode == "mip" else 500)) as session:
                session["rayCast.mode"] = mode
                return [session.render(96, 72, samples=2) for _ in range(3)]

        alone = {mode: draw(mode) for mode in ("mip", "volume")}
        together = {}
        threads = [threading.Thread(target=lambda mode=mode: together.__setitem__(mode, draw(mode))) for mode in alone]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for mode in alone:
            for first, second in zip(alone[mode], together[mode]):
                numpy.testing.assert_array_equal(first, second)
        self.assertGreater(numpy.abs(alone["mip"][0].astype(int) - alone["volume"][0]).max(), 10)

    def test_one_session_is_called_from_many_threads(self):
        with velum.open(ball()) as session:
            first = session.render(48, 36, samples=1)
            pictures = []
            threads = [threading.Thread(target=lambda: pictures.append(session.render(48, 36, samples=1))) for _ in range(4)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(len(pictures), 4)
            for picture in pictures:
                numpy.testing.assert_array_equal(picture, first)

    def test_other_threads_of_python_run_meanwhile(self):
        with velum.open(ball(side=64)) as session:
            turns, ends = [0], threading.Event()

            def count():
                while not ends.is_set():
                    turns[0] += 1
                    time.sleep(0.001)

            thread = threading.Thread(target=count)
            thread.start()
            before = turns[0]
            session.render(640, 480, samples=8)
            during = turns[0] - before
            ends.set()
            thread.join()
            self.assertGreater(during, 20)

    def test_a_fork_has_no_session(self):
        said = self.run_python("""
import os, numpy, velum
s = velum.open(numpy.arange(512, dtype="uint16").reshape(8, 8, 8))
child = os.fork()
if child == 0:
    try:
        s.cut("plane")
    except velum.ArgumentError as error:
        print(error, flush=True)
    s.close()
    velum.open(numpy.arange(512, dtype="uint16").reshape(8, 8, 8)).cut("plane")
    os._exit(0)
print(os.waitpid(child, 0)[1])
s.cut("plane")
""")
        self.assertIn("fork", said.splitlines()[0])
        self.assertEqual(said.splitlines()[1], "0")

    def test_a_session_that_is_left_open_does_not_keep_python(self):
        self.assertEqual(self.run_python("import numpy, velum; s = velum.open(numpy.arange(512.0).reshape(8, 8, 8)); s.render(32, 24); print(1)").strip(), "1")


class Stopping(Case):
    def setUp(self):
        super().setUp()
        self.session = velum.open(ball(side=64))
        self.addCleanup(self.session.close)

    def test_progress_is_told_by_the_thread_that_waits(self):
        heard = []
        self.session.progress = lambda fraction, what: heard.append((fraction, what, threading.get_ident()))
        self.session.render(640, 480, samples=16)
        self.assertGreater(len(heard), 1)
        self.assertEqual({thread for _, _, thread in heard}, {threading.get_ident()})
        fractions = [fraction for fraction, _, _ in heard]
        self.assertTrue(all(0 <= fraction <= 1 for fraction in fractions))
        self.assertTrue(all(isinstance(what, str) for _, what, _ in heard))

    def expect_soon(self, kind, run):
        start = time.monotonic()
        with self.assertRaises(kind):
            run()
        self.assertLess(time.monotonic() - start, 6)
        self.session.progress = None
        self.assertEqual(self.session.render(32, 24).shape, (24, 32, 3))  # it can go on

    def test_an_exception_of_the_listener_stops_the_work(self):
        def refuse(fraction, what):
            raise LookupError("enough")

        self.session.progress = refuse
        self.expect_soon(LookupError, lambda: long_work(self.session))

    def test_cancel_stops_the_work(self):
        timer = threading.Timer(0.3, self.session.cancel)
        timer.start()
        self.expect_soon(velum.Cancelled, lambda: long_work(self.session))

    def test_an_interrupt_stops_the_work(self):
        timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        self.expect_soon(KeyboardInterrupt, lambda: long_work(self.session))

    def test_a_session_is_closed_while_it_works(self):
        timer = threading.Timer(0.3, self.session.close)
        timer.start()
        with self.assertRaises(velum.Cancelled):
            long_work(self.session)


class Daemons(Case):
    """Threads that are at work when Python ends."""

    def test_the_program_ends_as_if_they_were_not(self):
        for seconds in 0, 0.02, 0.05, 0.3:  # within a picture or between two
            self.assertEqual(self.run_python(f"""
import threading, time
import numpy, velum

array = numpy.arange(64 ** 3, dtype="uint32").astype("uint8").reshape(64, 64, 64)
opened = threading.Barrier(4)

def work():
    s = velum.open(array)
    opened.wait()
    while True:
        try:
            velum.Volume(array)
            s.render(64, 48)
        except velum.Error:  # closed
            pass

for _ in range(3):
    threading.Thread(target=work, daemon=True).start()
opened.wait()
time.sleep({seconds})
print("ended")
"""), "ended\n")


class Memory(Case):
    def test_it_does_not_grow_with_what_was_opened(self):
        array = ball(side=64)  # half a megabyte, and its labels

        def work():
            with velum.open(array, unit="HU") as session:
                session.labels = array > 500
                session.cut("plane", face="section")
                return session.voxels.array[0, 0, 0], session.labels.array[0, 0, 0]

        for _ in range(10):
            work()
        gc.collect()
        before = resident_mb()
        for _ in range(200):
            work()
        gc.collect()
        self.assertLess(resident_mb() - before, 10, "MB; 200 volumes are 100")

    def test_frames_that_are_left_are_let_go_whatever_the_listener_says(self):
        velum.Volume(ball(side=96)).save(self.folder / "ball.nrrd")  # nearly two megabytes

        def refuse(fraction, what):
            raise KeyboardInterrupt

        with velum.Session() as session:
            def work():
                session.progress = None
                session.open(self.folder / "ball.nrrd")
                frames = session.frames(48, 36, section="axial", animate="turn", seconds=1)
                next(frames)
                session.progress = refuse
                del frames

            for _ in range(5):
                work()
            before = resident_mb()
            for _ in range(60):
                work()
            self.assertLess(resident_mb() - before, 50, "MB; 60 volumes are 100")

    def test_what_nobody_has_any_more_is_given_up(self):
        threads = threading.active_count(), len(os.listdir("/proc/self/task"))
        for _ in range(5):
            velum.open(ball()).cut("plane")
        self.assertLessEqual(len(os.listdir("/proc/self/task")), threads[1] + 8)


if __name__ == "__main__":
    unittest.main()
