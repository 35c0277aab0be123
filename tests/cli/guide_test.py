"""Every command of the guide and of the README runs, in the order in which a reader meets them, in one folder; menus, entries and
keys that the guide names are there.

The folder holds small files of the names that the commands use. Commands are run by a shell as they stand there, but for
--size, --frames and --voxels, so that pictures are small and animations short.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import unittest

from recover_test import journal_line
from velum_cli import PROGRAM, CliTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The verbs that draw or sample, and what makes them cheap.
CHEAP = {"render": ("--size", "96x72"), "count": ("--size", "128x96"), "bench": ("--size", "96x72"), "film": ("--size", "96x72"), "sample": ("--voxels", "32")}
# Exit codes that are not 0: pictures that differ, and a window where there is no display.
CODES = {"compare": 4, "view": 3}
NO_DISPLAY = {"DISPLAY": "", "WAYLAND_DISPLAY": ""}


def is_placeholder(words):
    """A command is none that can be run where it names nothing to work on, or has a word in capitals, as VERB, in its place."""
    return len(words) < 3 or any(re.fullmatch("[A-Z]{2,}", word) for word in words)


def whole_commands(block):
    """The commands of a fenced block, each with the lines on which it goes on: behind a backslash, or inside of quotes."""
    rest = iter(block.replace("\\\n", " ").splitlines())
    for line in rest:
        while line.count("'") % 2:
            line += next(rest)
        yield line


def commands_of(text):
    """Every `velum-batch ...` of a document: lines of fenced blocks, with what they go on in, and code inside of lines."""
    commands = []
    for block, inline in re.findall(r"^```\n(.*?)^```$|(?<!`)`(velum-batch [^`]*)`", text, re.M | re.S):
        lines = whole_commands(block) if block else [" ".join(inline.split())]
        commands += [line.strip() for line in lines if line.lstrip().startswith("velum-batch ")]
    return [one for one in commands if not is_placeholder(shlex.split(one, comments=True))]


def made_cheap(command):
    """The same with small pictures, few frames and, where it does not say how many, few voxels."""
    verb = command.split()[1]
    command = re.sub(r"(?<= )--frames \d+", "--frames 3", re.sub(r"\s+#.*", "", command))
    option, value = CHEAP.get(verb, ("", ""))
    if verb == "sample" and "brain" in command:  # which the guide makes larger than memory
        return re.sub(r"--voxels \d+", "--voxels 96", command)
    if not option or verb == "sample" and ("virion" in command or option in command):
        return command
    return re.sub(rf" {option} \S+", "", command) + f" {option} {value}"


def text_element(group, element, kind, text):
    data = text.encode() + (b"" if len(text) % 2 == 0 else b"\0" if kind == "UI" else b" ")
    return struct.pack("<HH2sH", group, element, kind.encode(), len(data)) + data


def number_element(group, element, number):
    return struct.pack("<HH2sHH", group, element, b"US", 2, number)


def dicom_image(index, side=16):
    """A CT image of a cube of bone in air, explicit little endian."""
    pixels = b"".join(struct.pack("<h", 700 if 4 <= x < 12 and 4 <= y < 12 else -1000) for y in range(side) for x in range(side))
    image_class = "1.2.840.10008.5.1.4.1.1.2"
    head = text_element(2, 2, "UI", image_class) + text_element(2, 3, "UI", f"2.25.7.{index}") + text_element(2, 0x10, "UI", "1.2.840.10008.1.2.1")
    return b"".join([
        bytes(128), b"DICM", struct.pack("<HH2sHI", 2, 0, b"UL", 4, len(head)), head,
        text_element(8, 0x16, "UI", image_class), text_element(8, 0x18, "UI", f"2.25.7.{index}"), text_element(8, 0x60, "CS", "CT"),
        text_element(0x20, 0xe, "UI", "2.25.7"), text_element(0x20, 0x13, "IS", str(index)),
        text_element(0x20, 0x32, "DS", f"0\\0\\{2 * index}"), text_element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0"),
        number_element(0x28, 2, 1), text_element(0x28, 4, "CS", "MONOCHROME2"), number_element(0x28, 0x10, side),
        number_element(0x28, 0x11, side), text_element(0x28, 0x30, "DS", "2\\2"), number_element(0x28, 0x100, 16),
        number_element(0x28, 0x101, 16), number_element(0x28, 0x102, 15), number_element(0x28, 0x103, 1),
        struct.pack("<HH2sHI", 0x7fe0, 0x10, b"OW", 0, len(pixels)), pixels])


def meta_image(kind, values, side, data_file="LOCAL"):
    """A cube of MetaImage: its header, and its voxels."""
    head = (f"ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nElementSpacing = 2 2 2\n"
            f"DimSize = {side} {side} {side}\nElementType = MET_{'UCHAR' if kind == 'B' else 'SHORT'}\nElementDataFile = {data_file}\n")
    return head.encode(), struct.pack(f"<{side ** 3}{kind}", *values)


def cube(side, inside, outside):
    middle = range(side // 4, 3 * side // 4)
    return [inside if x in middle and y in middle and z in middle else outside
            for z in range(side) for y in range(side) for x in range(side)]


def ome_tiff(side=16, planes=4):
    """Two channels of one page a plane, 16 bits, as a microscope's program writes them: a cube, and its inverse."""
    description = (f'<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06"><Image ID="Image:0"><Pixels '
                   f'ID="Pixels:0" DimensionOrder="XYZCT" Type="uint16" SizeX="{side}" SizeY="{side}" SizeZ="{planes}" SizeC="2" SizeT="1" '
                   f'PhysicalSizeX="0.3" PhysicalSizeY="0.3" PhysicalSizeZ="1"><Channel ID="Channel:0:0"/><Channel ID="Channel:0:1"/>'
                   f"<TiffData/></Pixels></Image></OME>\0").encode()
    shape = cube(side, 3000, 200)[side * side * side // 2:][:side * side]
    data, pages = b"", []
    for page in range(2 * planes):
        pages.append(8 + len(data))
        data += struct.pack(f"<{side * side}H", *(shape if page < planes else reversed([3200 - value for value in shape])))
    text_at = 8 + len(data)
    data += description + b"\0" * (len(description) % 2)
    first = 8 + len(data)
    for page, pixels_at in enumerate(pages):  # tag, type (2 text, 3 short, 4 long), count, value or place
        tags = [(256, 4, 1, side), (257, 4, 1, side), (258, 3, 1, 16), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, pixels_at),
                (277, 3, 1, 1), (278, 4, 1, side), (279, 4, 1, 2 * side * side)]
        tags += [(270, 2, len(description), text_at)] if page == 0 else []
        entries = b"".join(struct.pack("<HHII", *tag) for tag in sorted(tags))
        after = 8 + len(data) + 2 + len(entries) + 4
        data += struct.pack("<H", len(tags)) + entries + struct.pack("<I", after if page + 1 < len(pages) else 0)
    return b"II*\0" + struct.pack("<I", first) + data


# A look in 3D Slicer's old form: which interpolation and light, then points of the curves, each behind how many numbers follow.
SLICER_LOOK = "1\n1\n0.9\n0.1\n0.2\n10\n4 150 0 400 0.8\n4 0 1 255 1\n8 0 0.8 0.5 0.4 400 1 1 0.9\n"


def plain(text):
    """What a menu shows of its text in the source."""
    return text.replace("&", "").removesuffix("...")


def commands_in_menu(title):
    """The entries that the sources put into a menu of the window, and each command's name, which submenus do not have. They
    are those of files that ask for the menu, and what is called after it."""
    entries = {}
    for source in (ROOT / "src/gui").rglob("*.cpp"):
        text = source.read_text()
        fills = f"MenuId::{title}" in text
        for name, entry in re.findall(r'"([a-z]+\.[A-Za-z]+)",\s*(?:tr\()?"([^"]+)"', text):
            if fills or name.startswith(title.lower() + "."):
                entries[plain(entry)] = name
        if fills:
            entries |= {plain(entry): "" for entry in re.findall(r'addMenu\(tr\("([^"]+)"', text)}
    return entries


def titles_on_page(title):
    """Texts of the room whose page of the side panel is called so."""
    rooms = [source.parent for source in (ROOT / "src/gui").rglob("*.cpp") if re.search(rf'addPage\([^;]*"{title}"', source.read_text())]
    return {plain(text) for room in rooms for source in room.glob("*.cpp") for text in re.findall(r'tr\("([^"]+)"', source.read_text())}


class Guide(CliTest):
    def setUp(self):
        super().setUp()
        programs = self.folder.with_name(self.folder.name + "-bin")  # the commands find the program by its name
        programs.mkdir()
        self.addCleanup(shutil.rmtree, programs, ignore_errors=True)
        (programs / "velum-batch").symlink_to(shutil.which(PROGRAM))
        self.env = {**os.environ, **NO_DISPLAY, "PATH": f"{programs}:{os.environ['PATH']}", "XDG_STATE_HOME": str(self.folder / "state")}

    def run_commands(self, name):
        commands = list(dict.fromkeys(map(made_cheap, commands_of((ROOT / name).read_text()))))  # what stands there twice runs once
        for command in commands:
            missing = [word for word in shlex.split(command) if word.startswith("/") and not pathlib.Path(word).exists()]
            is_video = command.split()[1] == "film" and re.search(r"\.(mp4|webm|gif)\b", command)
            if missing or is_video and not shutil.which("ffmpeg"):  # a scan, or a program, of another package
                continue
            with self.subTest(command=command):
                self.run_shell(command, CODES.get(command.split()[1], 0))
        return commands

    def run_shell(self, command, code):
        import subprocess
        done = subprocess.run(["sh", "-c", command], cwd=self.folder, env=self.env, capture_output=True, timeout=120)
        self.assertEqual(done.returncode, code, f"{command}\n{done.stderr.decode(errors='replace')}")

    def test_commands_of_the_readme(self):
        self.assertGreater(len(self.run_commands("README.md")), 4)

    def test_commands_of_the_guide(self):
        self.put_samples()
        self.put_files_of_others()
        self.assertGreater(len(self.run_commands("docs/USER-GUIDE.md")), 55)

    def test_menus_and_keys_of_the_guide(self):
        """*Menu > Entry* (key): the sources have the entry, and the key is its own; *Page > Title* is on that page."""
        guide = (ROOT / "docs/USER-GUIDE.md").read_text()
        keys = json.loads((ROOT / "resources/keys.json").read_text())
        named = re.findall(r"\*([A-Z][a-z ]+) > ([^*>]+)\*(?: \(([^)]*)\))?", " ".join(guide.split()))
        self.assertGreater(len(named), 5)
        for place, entry, key in named:
            with self.subTest(entry=f"{place} > {entry}"):
                commands = commands_in_menu(place)
                if entry in commands:
                    stated = re.match(r"(?:(?:Ctrl|Shift|Alt)\+)*(?:F\d+|Del|.)(?=$|,)", key)
                    self.assertIn(stated.group() if stated else "", keys.get(commands[entry], []) + [""])
                else:
                    self.assertIn(entry, titles_on_page(place))

    def test_pictures_and_links_of_the_guide(self):
        guide = (ROOT / "docs/USER-GUIDE.md").read_text()
        carried = (ROOT / "docs/guide.qrc").read_text()
        for picture in re.findall(r"\]\((images/[^)]+)\)", guide):
            self.assertTrue((ROOT / "docs" / picture).exists(), picture)
            self.assertIn(f"<file>{picture}</file>", carried)
        headings = {re.sub(r"[^a-z0-9 -]", "", line.lower()).replace(" ", "-") for line in re.findall(r"^#+ (.*)", guide, re.M)}
        for link in re.findall(r"\]\(#([^)]+)\)", guide):
            self.assertIn(link, headings)

    def put_samples(self):
        """A trunk as a scan with labels, a heart, a head; all of a few voxels."""
        self.sample("torso", 32, "scan.nrrd")
        labels = self.folder / "scan_labels.seg.nrrd"
        for name in ("labels.nii.gz", "labels.nrrd"):
            self.run_batch("convert", labels, name)
        labels.rename(self.folder / "labels.seg.nrrd")
        self.run_batch("convert", "scan.nrrd", "scan.nii.gz")
        # The script that the guide shows, smaller.
        script = re.search(r"^```\n(cut\.add .*?)^```$", (ROOT / "docs/USER-GUIDE.md").read_text(), re.M | re.S)[1]
        (self.folder / "plate.txt").write_text(re.sub(r"picture \S+", "picture 96x72", script))
        self.run_batch("sample", "heart", "-o", "beating.nrrd", "--voxels", 32, "--time-steps", 3)
        self.run_batch("convert", "beating.nrrd", "heart.nii.gz")
        self.sample("skull", 32, "head.nrrd")
        self.run_batch("convert", "head.nrrd", "ch2.nii.gz")
        self.run_batch("convert", "head_labels.seg.nrrd", "aal.nii.gz")

    def put_files_of_others(self):
        """What other programs write, and work that a session left behind."""
        (self.folder / "ct_folder").mkdir()
        for index in range(16):
            (self.folder / f"ct_folder/image{index:02}.dcm").write_bytes(dicom_image(index))
        (self.folder / "scan.mha").write_bytes(b"".join(meta_image("h", cube(16, 700, -1000), 16)))
        head, voxels = meta_image("B", cube(16, 1, 0), 16, "frog.raw")
        (self.folder / "frog.mhd").write_bytes(head)
        (self.folder / "frog.raw").write_bytes(voxels)
        (self.folder / "cells.ome.tif").write_bytes(ome_tiff())
        (self.folder / "bone.vp").write_text(SLICER_LOOK)
        work = self.folder / "state/velum/recovery/1-2-3"
        work.mkdir(parents=True)
        (work / "lock").touch()
        (work / "journal-1.jsonl").write_text(
            journal_line(1, [{"op": "replace", "path": "", "value": {"velum": 1}}], label="Open", title="scan.nrrd"))


if __name__ == "__main__":
    unittest.main()
