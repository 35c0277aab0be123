#!/usr/bin/env python3
"""Draws the pictures of the guide and of the README that show volumes; `./dev guide` calls it.

Each picture is a plate of panels, each panel one call of `velum-batch render`, mounted by oiiotool (Debian package
openimageio-tools). The scans are those of the Debian packages invesalius-examples and mricron-data; all else is
phantoms. usage: pictures.py BATCH FOLDER [NAME...]
"""
import os
import pathlib
import subprocess
import sys
import tempfile

HEAD = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3"
TEMPLATES = "/usr/share/mricron/templates/"
WELCOME = str(pathlib.Path(__file__).parent.parent / "resources" / "welcome.json")
MOST_BYTES = 250_000
GAP = 4  # pixels between panels
DARK, WHITE = "0.035,0.04,0.045", "1,1,1"

OBLIQUE = ["--view", "oblique"]
FINE = ["--samples", os.environ.get("S","16")]


def sets(*assignments):
    """--set for each."""
    return [word for one in assignments for word in ("--set", one)]


def ids(first, last):
    return "[" + ",".join(str(i) for i in range(first, last + 1)) + "]"


def near(degrees):
    """How near the camera comes: its field of view."""
    return sets(f"camera.fieldOfViewDeg={degrees}")


def cut(index, *assignments):
    return sets(f"cuts.+.{assignments[0]}", *(f"cuts.{index}.{one}" for one in assignments[1:]))


# The head without its headrest, which two cuts of the first scene hide.
BARE_HEAD = [WELCOME, *OBLIQUE, *near(21), *sets("cuts.0.enabled=false")]
REGIONS = [TEMPLATES + "ch2.nii.gz", TEMPLATES + "aal.nii.gz", *OBLIQUE, *near(22)]
OPENED = cut(0, "axis=-0.55,-0.2,0.8", "centreMm=0,15,10")
SPARED = [*OPENED, *sets("cuts.0.exempt=" + ids(1, 116))]


def head_cut(*assignments):
    """The skull with one more cut, behind those that hide the headrest."""
    return [*BARE_HEAD, "--preset", "ct-bone", *cut(3, *assignments)]


def phantom(folder, name):
    return str(folder / f"{name}.nrrd")


def labels_of(folder, name):
    return str(folder / f"{name}_labels.seg.nrrd")


def sheet(folder):
    tracts = [TEMPLATES + "ch2better.nii.gz", TEMPLATES + "JHU-WhiteMatter-labels-1mm.nii.gz", *OBLIQUE, *near(17.5)]
    macaque = [TEMPLATES + "inia19-t1-brain.nii.gz", TEMPLATES + "inia19-NeuroMaps.nii.gz", *OBLIQUE, *near(15)]
    torso = [phantom(folder, "torso"), labels_of(folder, "torso"), *OBLIQUE, *near(21)]
    fetus = [phantom(folder, "ultrasound"), labels_of(folder, "ultrasound"), *OBLIQUE, *near(18)]
    return [
        [WELCOME],
        [*REGIONS, *SPARED],
        [*tracts, *cut(0, "axis=-1,-0.25,0.6", "centreMm=4,10,12", "exempt=" + ids(1, 50)), *sets("labels.tint=0.9")],
        [*macaque, *cut(0, "axis=-0.7,-0.5,0.5", "centreMm=0,4,6", "face=slice")],
        [*torso],
        [*fetus, *sets(*(f"labels.structures.{i}.visible=false" for i in range(5)), "labels.unlabelled=0")],
        [phantom(folder, "vessels"), labels_of(folder, "vessels"), *OBLIQUE, *near(20)],
        [phantom(folder, "neurons"), labels_of(folder, "neurons"), *OBLIQUE, *near(24)],
        [phantom(folder, "seismic"), *OBLIQUE, *near(24)],
    ]


# name: (columns, size of a panel, colour of the gaps, panels); a panel is the arguments of `velum-batch render`.
PLATES = {
    "presets": (3, (480, 400), DARK, lambda _: [
        [*BARE_HEAD, "--preset", "ct-bone"],
        [*BARE_HEAD, "--preset", "ct-skin"],
        [*BARE_HEAD, "--preset", "ct-skin-bone"],
        [*BARE_HEAD, "--preset", "ct-muscle"],
        [*BARE_HEAD, "--preset", "ct-bone", *sets("rayCast.mode=mip", "volume.windowLevel=900", "volume.windowWidth=2200")],
        [*BARE_HEAD, "--preset", "ct-bone", *sets("rayCast.mode=iso", "rayCast.isoValue=300")],
    ]),
    "cuts": (3, (480, 400), DARK, lambda _: [
        head_cut("axis=-1,0,0", "centreMm=96,120,80"),
        head_cut("axis=-1,0,0", "centreMm=96,120,80", "face=slice"),
        head_cut("shape=sphere", "centreMm=56,70,120", "sizeMm=110,110,110"),
    ]),
    "labels": (3, (480, 400), DARK, lambda _: [
        [*REGIONS, *OPENED],
        [*REGIONS, *SPARED],
        [*REGIONS, *SPARED, *sets("labels.tint=0")],
    ]),
    "sheet": (3, (480, 400), DARK, sheet),
}


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def mount(panels, columns, size, ground, out):
    """Panels side by side, as a JPEG that is as good as its size allows."""
    rows = -(-len(panels) // columns)
    whole = [count * (length + GAP) - GAP for count, length in zip((columns, rows), size)]
    command = ["oiiotool", "--create", f"{whole[0]}x{whole[1]}", 3, f"--fill:color={ground}", f"{whole[0]}x{whole[1]}"]
    for i, panel in enumerate(panels):
        x, y = (i % columns) * (size[0] + GAP), (i // columns) * (size[1] + GAP)
        command += [panel, "--ch", "R,G,B", "--swap", "--paste", f"+{x}+{y}"]
    for quality in (90, 86, 82, 78, 74, 70):
        run(*command, "--eraseattrib", ".*", "--compression", f"jpeg:{quality}", "-o", out)
        if os.path.getsize(out) <= MOST_BYTES:
            return
    sys.exit(f"pictures: {out} is larger than {MOST_BYTES} bytes: make its panels smaller")


def draw_plate(batch, name, folder, out):
    columns, size, ground, describe = PLATES[name]
    panels = []
    for i, arguments in enumerate(describe(folder)):
        panels.append(folder / f"{name}-{i}.png")
        run(batch, "render", *arguments, "-o", panels[-1], "--size", f"{size[0]}x{size[1]}", *FINE)
    mount(panels, columns, size, ground, out)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    batch, out = sys.argv[1], pathlib.Path(sys.argv[2])
    names = sys.argv[3:] or list(PLATES)
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        if "sheet" in names:
            for phantom_name in ("torso", "vessels", "neurons", "ultrasound", "seismic"):
                run(batch, "sample", phantom_name, "-o", phantom(folder, phantom_name))
        for name in names:
            draw_plate(batch, name, folder, out / f"{name}.jpg")


if __name__ == "__main__":
    main()
