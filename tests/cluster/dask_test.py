"""The same through Dask with the Python module: a scheduler and three workers on the loopback, one of which is killed while it draws."""
import importlib.util
import os
import pathlib
import signal
import sys
import time
import unittest

from pieces import COUNT, PiecesTest, name_of, pause

WORKERS = 3

MODULES = [name for name in ("distributed", "numpy", "velum") if not importlib.util.find_spec(name)]


def note(folder, *words):
    with open(f"{folder}/log", "a") as log:
        log.write(" ".join(map(str, words)) + "\n")


def draw(data, output, folder):
    """What a worker does, with a line of the log when it begins and when it has ended. @return its process"""
    import velum
    note(folder, "begun", output, os.getpid())
    s = velum.open(data)
    s.view.first(aspect=96 / 64)  # as velum-batch looks at data, by the picture's shape
    s.picture("96x64", output, samples=1)
    note(folder, "done", output, os.getpid())
    return os.getpid()


@unittest.skipIf(MODULES, f"not installed: {', '.join(MODULES)}")
class Dask(PiecesTest):
    def at_work(self):
        """Pieces that are begun and not done, and who draws them."""
        path = self.folder / "log"
        lines = [line.split() for line in path.read_text().splitlines()] if path.exists() else []
        done = {(output, pid) for what, output, pid in lines if what == "done"}
        return lines, [(output, int(pid)) for what, output, pid in lines if what == "begun" and (output, pid) not in done]

    def kill_a_worker(self):
        """Kills a worker in the middle of a piece, when a third is done. @return the piece, the worker"""
        end = time.monotonic() + 240
        while time.monotonic() < end:
            lines, held = self.at_work()
            if len(lines) - len(held) > 2 * COUNT // 3 and held and pause(held[-1][1]):
                if held[-1] in self.at_work()[1]:
                    os.kill(held[-1][1], signal.SIGKILL)
                    return held[-1]
                os.kill(held[-1][1], signal.SIGCONT)
            time.sleep(0.002)
        raise AssertionError("no worker was ever caught in the middle of a piece")

    def test_workers_of_which_one_is_killed_give_the_bytes_of_one_process(self):
        import distributed
        (self.folder / "out").mkdir()
        cluster = distributed.LocalCluster(n_workers=WORKERS, threads_per_worker=1, processes=True, host="127.0.0.1",
                                           dashboard_address=None, local_directory=str(self.folder))
        self.addCleanup(cluster.close)
        client = distributed.Client(cluster)
        self.addCleanup(client.close)
        os.chdir(self.folder)
        client.run(os.chdir, str(self.folder))
        names = map(name_of, range(COUNT))
        files = [(f"{self.folder}/studies/{name}/ct.nrrd", f"{self.folder}/out/{name}.png") for name in names]
        work = [client.submit(draw, *pair, str(self.folder), pure=False, retries=3) for pair in files]
        piece, victim = self.kill_a_worker()
        client.gather(work)
        lines, held = self.at_work()
        self.assertEqual(held, [(piece, victim)], "what was begun and never done")
        begun = [output for what, output, _ in lines if what == "begun"]
        done = [(output, int(pid)) for what, output, pid in lines if what == "done"]
        self.assertEqual(begun.count(piece), 2)
        self.assertNotIn((piece, victim), done)
        # What a dead worker has returned dies with it where nobody has fetched it, and is drawn again.
        others = {output for output, pid in done if pid != victim}
        self.assertEqual(len(others), COUNT)
        self.assertEqual([output for output in set(begun) if begun.count(output) > 1 and output != piece
                          and (output, victim) not in done], [])
        print(f"{len({pid for _, pid in done})} processes have drawn {COUNT} pieces, one was killed at {pathlib.Path(piece).name}", file=sys.stderr)
        self.assertWhole("out")


if __name__ == "__main__":
    unittest.main()
