"""velum-batch recover, and scenes whose data is missing."""
import json
import os
import unittest

from velum_cli import CliTest


def check_sum(text):
    """As src/scene/json/ChangeLog.cpp: FNV-1a, 64 bits."""
    value = 14695981039346656037
    for byte in text.encode():
        value = (value ^ byte) * 1099511628211 % 2**64
    return f"{value:016x}"


def journal_line(number, patch, **fields):
    head = json.dumps({"n": number, "s": 0.5, **fields}, separators=(",", ":"))[:-1]
    patch = json.dumps(patch, separators=(",", ":"))
    return f'{head},"sum":"{check_sum(head + patch)}","patch":{patch}}}\n'


class Recover(CliTest):
    def setUp(self):
        super().setUp()
        self.env = {"XDG_STATE_HOME": str(self.folder / "state")}
        self.root = self.folder / "state/velum/recovery"

    def leave_work(self, name="1-2-3", level=17.0):
        """A dead session's folder, with a last line that was half written."""
        folder = self.root / name
        folder.mkdir(parents=True)
        (folder / "lock").touch()
        text = journal_line(1, [{"op": "replace", "path": "", "value": {"velum": 1}}], label="Open", title="head.nrrd")
        text += journal_line(2, [{"op": "add", "path": "/volume", "value": {"windowLevel": level}}], label="Window",
                             title="head.nrrd", path="/a/head.json")
        (folder / "journal-1.jsonl").write_text(text + text[:40])
        return folder

    def recover(self, *arguments, **options):
        return self.run_batch("recover", *arguments, env=self.env, **options)

    def test_nothing_left_behind(self):
        self.assertIn(b"no unsaved work", self.recover("--list").stdout)
        self.assertEqual(json.loads(self.recover("--list", "--json").stdout), {"work": []})
        self.assertIn(b"no unsaved work", self.recover("-o", "a.json", code=2).stderr)

    def test_lists_writes_and_discards(self):
        folder = self.leave_work()
        row, = json.loads(self.recover("--list", "--json").stdout)["work"]
        self.assertEqual((row["name"], row["title"], row["scene"], row["lastChange"], row["readable"]),
                         ("1-2-3", "head.nrrd", "/a/head.json", "Window", True))
        self.assertIn(b"head.nrrd", self.recover("--list").stdout)
        self.recover("-o", "a.json")
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["volume"]["windowLevel"], 17)
        self.assertTrue(folder.exists())
        self.recover("1-2-3", "-o", "b.json", "--discard")
        self.assertFalse(folder.exists())
        self.assertEqual((self.folder / "a.json").read_bytes(), (self.folder / "b.json").read_bytes())

    def test_what_cannot_be_written_is_not_discarded(self):
        folder = self.leave_work()
        self.recover("1-2-3", "-o", "/nowhere/a.json", "--discard", code=2)
        self.assertTrue(folder.exists())

    def test_damaged_work_is_listed_and_refused(self):
        (self.leave_work() / "journal-1.jsonl").write_bytes(os.urandom(1000))
        row, = json.loads(self.recover("--list", "--json").stdout)["work"]
        self.assertFalse(row["readable"])
        self.assertIn("journal-1.jsonl: it is damaged", row["problem"])
        self.assertEqual(row["folder"], str(self.root / "1-2-3"))
        self.assertIn(str(self.root / "1-2-3").encode(), self.recover("--list").stdout)
        self.assertIn(b"damaged", self.recover("1-2-3", "-o", "a.json", code=2).stderr)
        self.assertIn(b"none can be read", self.recover("-o", "a.json", code=2).stderr)
        self.assertFalse((self.folder / "a.json").exists())
        self.recover("1-2-3", "--discard")
        self.assertIn(b"no unsaved work", self.recover("--list").stdout)

    def test_newer_work_that_cannot_be_read_is_said_and_the_next_written(self):
        older, newer = self.leave_work("1-2-3"), self.leave_work("4-5-6")
        (newer / "journal-1.jsonl").write_bytes(os.urandom(1000))
        os.utime(older / "journal-1.jsonl", (1e9, 1e9))
        names = [row["name"] for row in json.loads(self.recover("--list", "--json").stdout)["work"]]
        self.assertEqual(names, ["4-5-6", "1-2-3"])
        said = self.recover("-o", "a.json").stderr
        self.assertIn(b"4-5-6", said)
        self.assertIn(b"cannot be read", said)
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["volume"]["windowLevel"], 17)

    def test_work_without_a_lock_is_work(self):
        (self.leave_work() / "lock").unlink()
        self.recover("-o", "a.json")
        self.recover("1-2-3", "--discard")
        self.assertIn(b"no unsaved work", self.recover("--list").stdout)

    def test_changes_that_cannot_be_read_are_said(self):
        path = self.leave_work() / "journal-1.jsonl"
        first, second = path.read_text().splitlines(keepends=True)[:2]
        path.write_text(first + second.replace("17", "18"))
        row, = json.loads(self.recover("--list", "--json").stdout)["work"]
        self.assertEqual((row["readable"], row["whole"]), (True, False))
        self.assertIn(b"what came later cannot be read", self.recover("--list").stdout)
        self.assertIn(b"what came later cannot be read", self.recover("-o", "a.json").stderr)

    def test_a_file_in_the_place_of_the_folder_of_all_work(self):
        self.root.parent.mkdir(parents=True)
        self.root.write_text("")
        for arguments in (["--list"], ["-o", "a.json"]):
            self.assertIn(str(self.root).encode(), self.recover(*arguments, code=2).stderr)

    def test_usage(self):
        self.leave_work()
        self.recover(code=1)
        self.recover("--discard", code=1)
        self.assertIn(b"no unsaved work 'x'", self.recover("x", "-o", "a.json", code=2).stderr)


class MissingData(CliTest):
    def save_scene(self):
        (self.folder / "data").mkdir()
        self.sample(voxels=16, file="data/ct.nrrd")
        self.run_batch("render", "data/ct.nrrd", "-o", "a.png", "--size", "16x12", "--save-scene", "a.json")

    def test_one_line_names_the_file_and_what_to_do(self):
        self.save_scene()
        (self.folder / "data/ct.nrrd").rename(self.folder.parent / f"{self.folder.name}.nrrd")
        moved = self.folder.parent / f"{self.folder.name}.nrrd"
        self.addCleanup(moved.unlink)
        self.refuse("render", "a.json", "-o", "b.png", "--size", "16x12", code=2,
                    words=("ct.nrrd", "--set volume.source.path="))
        self.run_batch("render", "a.json", "-o", "b.png", "--size", "16x12", "--set", f"volume.source.path={moved}")
        self.run_batch("compare", "a.png", "b.png")

    def test_data_that_moved_with_the_scene_is_found(self):
        self.save_scene()
        (self.folder / "deep/er").mkdir(parents=True)
        (self.folder / "data/ct.nrrd").rename(self.folder / "deep/er/other.nrrd")
        done = self.run_batch("render", "a.json", "-o", "b.png", "--size", "16x12")
        self.assertIn(b"has moved", done.stderr)

    def test_a_changed_file_is_said(self):
        self.save_scene()
        self.sample("vessels", 16, file="data/ct.nrrd")
        done = self.run_batch("render", "a.json", "-o", "b.png", "--size", "16x12")
        self.assertIn(b"ct.nrrd has changed", done.stderr)


if __name__ == "__main__":
    unittest.main()
