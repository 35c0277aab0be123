"""A thousand data sets by an array of Slurm: a real controller and a real node, in a namespace of their own."""
import os
import shutil
import subprocess
import sys
import time
import unittest

from pieces import COUNT, PiecesTest

NEEDED = ["slurmctld", "slurmd", "munged", "sbatch", "unshare"]
TASKS = 12
NODE = "n1"


def paths():
    return {**os.environ, "PATH": os.environ["PATH"] + ":/usr/sbin:/sbin"}


def missing():
    return [name for name in NEEDED if not shutil.which(name, path=paths()["PATH"])]


def may_unshare():
    return subprocess.run(["unshare", "-m", "-p", "-f", "--mount-proc", "true"], capture_output=True).returncode == 0


def configuration(folder):
    host, user = os.uname().nodename, subprocess.check_output(["id", "-un"], text=True).strip()
    lines = {"ClusterName": "velum", "SlurmctldHost": f"{host}(127.0.0.1)", "SlurmUser": user, "SlurmdUser": user,
             "AuthType": "auth/munge", "AuthInfo": f"socket={folder}/munge/socket", "CryptoType": "crypto/munge",
             "StateSaveLocation": f"{folder}/state", "SlurmdSpoolDir": f"{folder}/spool",
             "SlurmctldPidFile": f"{folder}/controller.pid", "SlurmdPidFile": f"{folder}/node.pid",
             "SlurmctldLogFile": f"{folder}/controller.log", "SlurmdLogFile": f"{folder}/node.log",
             "SlurmctldPort": "16817", "SlurmdPort": "16818", "ProctrackType": "proctrack/linuxproc",
             "TaskPlugin": "task/none", "SelectType": "select/cons_tres", "SelectTypeParameters": "CR_Core",
             "ReturnToService": "2", "MpiDefault": "none", "SchedulerParameters": "sched_interval=1",
             "AccountingStorageType": "accounting_storage/none", "JobCompType": "jobcomp/none",
             "NodeName": f"{NODE} NodeHostname={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000 State=UNKNOWN",
             "PartitionName": f"main Nodes={NODE} Default=YES MaxTime=INFINITE State=UP"}
    return "".join(f"{name}={value}\n" for name, value in lines.items())


@unittest.skipIf(missing(), f"Slurm is not installed: {', '.join(missing())}")
@unittest.skipUnless(os.geteuid() == 0 and may_unshare(), "no namespace can be made here: needs root")
class Slurm(PiecesTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.slurm = cls.folder / "slurm"
        for name in ("state", "spool", "munge"):
            (cls.slurm / name).mkdir(parents=True)
        (cls.slurm / "munge").chmod(0o700)
        key = cls.slurm / "munge/key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        (cls.slurm / "slurm.conf").write_text(configuration(cls.slurm))
        munge = cls.slurm / "munge"
        daemons = (f"munged --key-file={key} --socket={munge}/socket --pid-file={munge}/pid --log-file={munge}/log "
                   f"--seed-file={munge}/seed --force && slurmctld -f $SLURM_CONF && slurmd -f $SLURM_CONF -N {NODE} "
                   "&& exec sleep infinity")
        cls.environment = {**paths(), "SLURM_CONF": str(cls.slurm / "slurm.conf")}
        # The namespace ends with its first process, and all daemons with it.
        namespace = subprocess.Popen(["unshare", "-m", "-p", "-f", "--mount-proc", "--kill-child", "bash", "-c", daemons],
                                     env=cls.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(namespace.wait)
        cls.addClassCleanup(namespace.kill)
        cls.wait_for(lambda: cls.slurm_says("sinfo", "-h", "-o", "%T") == "idle", "the node to be idle")

    @classmethod
    def slurm_says(cls, *words):
        done = subprocess.run(words, cwd=cls.folder, env=cls.environment, capture_output=True, text=True, timeout=60)
        return done.stdout.strip()

    @classmethod
    def wait_for(cls, holds, what, seconds=240):
        end = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > end:
                logs = [path.read_text(errors="replace")[-2000:] for path in cls.slurm.glob("*.log")]
                raise AssertionError(f"waited too long for {what}\n" + "\n".join(logs))
            time.sleep(0.1)

    def submit(self, folder):
        script = self.folder / "job.sh"
        words = " ".join(f"'{word}'" for word in self.command(folder))
        script.write_text(f"#!/bin/bash\n#SBATCH --output=/dev/null\nexec {words}\n")
        return self.slurm_says("sbatch", "--parsable", f"--array=1-{TASKS}", str(script))

    def running(self, job):
        return self.slurm_says("squeue", "-h", "-j", job, "-o", "%i").split()

    def test_an_array_of_which_a_third_is_killed_gives_the_bytes_of_one_process(self):
        job = self.submit("out")
        self.assertTrue(job)
        # A third of the tasks dies, each in the middle of a piece.
        killed = []
        for task in range(3, TASKS + 1, 3):
            mine = {f"SLURM_ARRAY_TASK_ID={task}", f"SLURM_ARRAY_JOB_ID={job}"}
            killed.append(self.kill_in_the_middle("out", task, TASKS, 2 * (task % 2), lambda _, variables: mine <= set(variables),
                                                  lambda: not self.running(f"{job}_{task}")))
        self.wait_for(lambda: not self.running(job), "the array")
        before = self.records("out")
        self.assertLeft(before, killed)
        self.assertEqual(sum(told == ["begun", "done"] for i, told in enumerate(before.values()) if (i % TASKS + 1) % 3), COUNT * 2 // 3)
        again = self.submit("out")
        self.wait_for(lambda: not self.running(again), "the second array")
        self.assertOnlyRestMade("out", before)
        self.assertEqual(self.states("out"), ["done"] * COUNT)
        self.assertWhole("out")
        print(f"{sum(told[-1:] != ['done'] for told in before.values())} of {COUNT} pieces were left by the first array, "
              f"{killed} in their middle", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
