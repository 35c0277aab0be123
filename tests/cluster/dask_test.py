"""The same through Dask with the Python module: a scheduler and two workers on the loopback, one of which is killed."""
import importlib.util
import os
import signal
import sys
import time
import unittest

from pieces import COUNT, PiecesTest

MODULES = [name for name in ("distributed", "numpy", "velum") if not importlib.util.find_spec(name)]


def draw(data, output):
    """What a worker does. @return its process"""
    import velum
    s = velum.open(data)
    s.view.first(aspect=96 / 64)  # as velum-batch looks at data, by the picture's shape
    s.picture("96x64", output, samples=1)
    return os.getpid()


@unittest.skipIf(MODULES, f"not installed: {', '.join(MODULES)}")
class Dask(PiecesTest):
    def test_workers_of_which_one_is_killed_give_the_bytes_of_one_process(self):
        import distributed
        (self.folder / "out").mkdir()
        cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1",
                                           dashboard_address=None, local_directory=str(self.folder))
        self.addCleanup(cluster.close)
        client = distributed.Client(cluster)
        self.addCleanup(client.close)
        os.chdir(self.folder)
        client.run(os.chdir, str(self.folder))
        names = [f"p{i:02}" for i in range(COUNT)]
        files = [(f"{self.folder}/studies/{name}/ct.nrrd", f"{self.folder}/out/{name}.png") for name in names]
        work = [client.submit(draw, *pair, pure=False, retries=3) for pair in files]
        end = time.monotonic() + 240
        while self.made("out") < 10 and time.monotonic() < end:
            time.sleep(0.05)
        victim = next(iter(client.run(os.getpid).values()))
        os.kill(victim, signal.SIGKILL)
        workers = set(client.gather(work))
        print(f"{len(workers)} processes have drawn {COUNT} pieces, one was killed", file=sys.stderr)
        self.assertGreaterEqual(len(workers), 2)
        self.assertWhole("out")


if __name__ == "__main__":
    unittest.main()
