#!/usr/bin/env python3
"""Draws the pictures of the guide and of the README that show volumes, and a film; `./dev guide` calls it.

Each picture is a plate of panels, each panel one call of `velum-batch render` or `film`, mounted by oiiotool (Debian package
openimageio-tools). The scans are those of the Debian packages invesalius-examples and mricron-data; all else is
phantoms. usage: pictures.py BATCH FOLDER [NAME...]
"""
import functools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HEAD = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3"
TEMPLATES = "/usr/share/mricron/templates/"
WELCOME = str(pathlib.Path(__file__).parent.parent / "resources" / "welcome.json")
GOLDEN = pathlib.Path(__file__).parent.parent / "tests" / "golden"
MOST_BYTES = 250_000
GAP = 4  # pixels between panels
DARK, WHITE = "0.035,0.04,0.045", "1,1,1"

OBLIQUE = ["--view", "oblique"]
BRAIN_SEEDS = ["-3.9069,-0.4272,0.5581", "-0.3790,0.2894,0.5581", "-2.0878,-2.5403,0.5949", "-3.4659,-1.4378,0.5949", "-3.4475,-0.3537,0.5949", "-0.4341,1.0611,0.5949",
               "0.2458,2.6046,0.6316", "-0.7465,2.6781,0.6316", "-1.0037,-1.6951,0.6684", "-1.0221,0.3261,0.6684", "-0.7281,2.2922,0.6684", "-3.3557,-1.8972,0.6867",
               "-3.3557,0.3078,0.6867", "-3.6313,-0.9601,0.7051", "-0.6178,3.1926,0.7235", "-0.0299,-1.0703,0.7419", "-2.3634,3.7254,0.7419", "-3.2087,0.4180,0.7602",
               "-4.0906,0.7855,0.7602", "-1.8489,2.1452,0.7786", "-1.9592,-2.4852,0.8154", "-1.7571,1.4470,0.8337", "-3.2822,3.7806,0.8337", "-3.3557,0.3996,0.8521",
               "0.2458,0.8590,0.8521", "-0.5627,-0.8314,0.8705", "-3.1352,-1.8788,0.8889", "-3.0984,-0.6845,0.8889", "-0.0299,-0.1516,0.8889", "-1.0772,-1.5664,0.9072",
               "-0.9486,-2.2647,0.9256", "-3.6313,-0.2802,0.9256", "-1.0405,1.2265,0.9256", "-0.4708,1.8145,0.9256", "-2.7493,3.7806,0.9256"]
SAMPLES = 16


def sets(*assignments):
    """--set for each."""
    return [word for one in assignments for word in ("--set", one)]


def ids(first, last):
    return "[" + ",".join(str(i) for i in range(first, last + 1)) + "]"


def near(degrees):
    """How near the camera comes: its field of view."""
    return sets(f"camera.fieldOfViewDeg={degrees}")


def cut(index, *assignments):
    """A cut more, the one with this number."""
    return sets(f"cuts.+.{assignments[0]}", *(f"cuts.{index}.{one}" for one in assignments[1:]))


# Without what it rests on.
BARE_HEAD = [HEAD, "--hide-table", *sets("camera.eye=-150,-360,250", "camera.target=118,112,72", "camera.fieldOfViewDeg=21.5",
                                         "lighting.ambient=0.42", "lighting.keyDirection=-0.6,0.35,0.72")]
SKULL = [*BARE_HEAD, "--preset", "ct-bone"]
XRAY = sets("rayCast.mode=mip", "volume.windowLevel=900", "volume.windowWidth=2200")
# The scan's own surface, coloured by region.
AS_MATERIAL = sets("labels.structures.*.showAs=material", "labels.unlabelled=1")
WHOLE = sets("labels.structures.*.opacity=1", "labels.structures.*.visible=true")
REGIONS = [TEMPLATES + "ch2.nii.gz", TEMPLATES + "aal.nii.gz", *OBLIQUE, *AS_MATERIAL]
OPENED = cut(0, "axis=-0.55,-0.2,0.8", "centre=0,15,10")
SPARED = [*OPENED, *sets("cuts.0.spares=" + ids(1, 116))]
MACAQUE = [TEMPLATES + "inia19-t1-brain.nii.gz", TEMPLATES + "inia19-NeuroMaps.nii.gz"]
TRACTS = [TEMPLATES + "ch2better.nii.gz", TEMPLATES + "JHU-WhiteMatter-labels-1mm.nii.gz"]
# The head's face is cut off, and the skull, which has no label, grown out of the cut.
HEAD_CUT = [*BARE_HEAD, "--preset", "ct-skin", *sets("camera.eye=-190,-330,240"),
            *cut(0, "axis=0,-1,0", "centre=100,75,100")]
SKULL_OUT = [*HEAD_CUT, *sets(
    'labels.growths.+={"structure":1,"seeds":[[84,70,30]],"low":260,"high":3100,"centre":[100,75,100],"axis":[0,-1,0],"distance":95}',
    'labels.structures.+={"id":1,"name":"Skull","color":[0.93,0.88,0.76],"litSphere":"bone"}',
    'cuts.0.spares=[{"structure":1,"distance":95}]')]
FLESH = {"skin": "0.87,0.68,0.56", "subcutaneous fat": "0.95,0.83,0.52", "muscle": "0.72,0.3,0.25", "artery": "0.8,0.17,0.15",
         "vein": "0.28,0.42,0.75", "cartilage": "0.67,0.82,0.86"}
HIDDEN = ("skin", "subcutaneous fat", "visceral fat", "muscle")


def phantom(folder, name, *labels):
    """A phantom, and its labels if they are to be shown."""
    return [folder / f"{name}.nrrd", *[folder / f"{name}_labels.seg.nrrd" for _ in labels]]


def presets(_):
    return [
        SKULL,
        [*BARE_HEAD, "--preset", "ct-skin"],
        [*BARE_HEAD, "--preset", "ct-skin-bone"],
        [*BARE_HEAD, "--preset", "ct-muscle"],
        [*SKULL, *XRAY],
        [*SKULL, *sets("rayCast.mode=iso", "rayCast.isoValue=300")],
    ]


def systems(folder):
    """One picture for each of the three systems: a membrane; structures that stand out of cuts; a model of a virus, what is
    before its inside cleared away."""
    brain = [*REGIONS[:2], "--preset", "mr-head", "--view", "anterior", "--finish", "plate",
             *cut(0, "axis=1,0,0", "centre=1,0,0"), *cut(1, "axis=0,0,1", "centre=0,0,-6", "joined=true"), *AS_MATERIAL,
             *sets("cuts.0.spares=" + ids(1, 116), "cuts.1.spares=" + ids(1, 116), "labels.tint=0.35", "lighting.ambient=0.5",
                   "lighting.shadow=0.35", "camera.eye=440,-330,190", "camera.target=0,-17,10", "camera.fieldOfViewDeg=23")]
    virus = [folder / "virion.cif", "--view", "anterior", "--preset", "soft", *near(12.6),
             *cut(0, "shape=sphere", "centre=250,-520,200", "size=1100,1100,1100"),
             *cut(1, "shape=everywhere", 'model.spares=[{"type":"root","share":1},{"type":"root.plasma","share":0}]')]
    return [[WELCOME], brain, virus]


def cuts(_):
    return [
        [*SKULL, *cut(0, "axis=-1,0,0", "centre=100,120,80")],
        [*SKULL, *cut(0, "axis=-1,0,0", "centre=100,120,80", "face=section")],
        [*SKULL, *cut(0, "shape=sphere", "centre=62,76,124", "size=112,112,112")],
    ]


def membrane(folder):
    """Above a plane, a membrane in the same place, the same as inlay; below the like for a beating heart."""
    def protect(low, high):
        return f'membrane.field.byValue=[{{"value":{low},"strength":100}},{{"value":{high},"strength":100}}]'
    def three(data, protected, *frame):
        return [[*data, *cut(0, f"shape={shape}", *frame, *own)] for shape, own in
                (("plane", ["face=section"]), ("membrane", [protected]), ("membrane", [protected, "membrane.use=inlay"]))]
    trunk = [*phantom(folder, "torso"), "--view", "anterior", "--preset", "ct-bone"]
    heart = [*phantom(folder, "heart"), "--view", "anterior", "--preset", "ct-muscle",
             *sets("volume.windowLevel=120", "volume.windowWidth=700")]
    return [
        *three(trunk, protect(200, 2000), "axis=0,-1,0", "centre=0,-54,0", "size=384,384,120"),
        *three(heart, protect(200, 600), "axis=0,-1,0", "centre=5,-30,-10", "size=166,166,80"),
    ]


def golden(folder, name, *more, view=None, near_enough=False):
    """A golden picture's case, finer. @param near_enough  the view comes as near as the case says, not as all of it lets it"""
    case = json.loads((GOLDEN / name / "case.json").read_text())
    fields = {**case["set"], **{k: v for one in more for k, v in one.items()}}
    fields["rayCast.samplesPerPixel"] = SAMPLES
    if not near_enough:
        fields.pop("camera.fieldOfViewDeg", None)
    if case.get("labels"):  # which are numbered by what a grid so coarse holds
        name = f"{case['sample']}{case['voxels']}"
        run(sys.argv[1], "sample", case["sample"], "-o", folder / f"{name}.nrrd", "--voxels", case["voxels"])
        words = [*phantom(folder, name, "labels"), *AS_MATERIAL, *WHOLE]
    else:
        words = phantom(folder, case["sample"])
    words += ["--preset", case["preset"], "--view", view or case["view"]]
    if fields["cuts.0.shape"] == "plane":  # which has nothing of a membrane's own
        fields = {path: v for path, v in fields.items() if not path.startswith("cuts.0.membrane.")}
    # A cut begins with its shape.
    fields = [(re.sub(r"^cuts\.\d+\.shape$", "cuts.+.shape", path), v) for path, v in fields.items()]
    return [*words, *sets(*(f"{path}={json.dumps(v) if not isinstance(v, str) else v}" for path, v in fields))]


def situations(folder):
    """The situations of the membrane paper's figures, row by row, each with plain clipping first. They are those of the
    golden pictures, finer."""
    panel = functools.partial(golden, folder)

    def active(name):
        """The frame comes down and drags its sheet along: a scene for each place."""
        panels = json.loads((GOLDEN / name / "case.json").read_text())["panels"]
        scenes, scene = [], panel(name, panels[0]["set"])
        for i, place in enumerate(panels):
            out = folder / f"{name}{i}.json"
            centre = place["set"]["cuts.0.centre"]
            run(sys.argv[1], "membrane", *scene, *sets(f"cuts.0.centre={json.dumps(centre)}"), "--save-scene", out)
            scene = [out]
            scenes.append([out])
        return scenes

    plane, cut_face = {"cuts.0.shape": "plane"}, {"cuts.0.shape": "plane", "cuts.0.face": "section"}
    as_inlay, as_grid = {"cuts.0.membrane.use": "inlay"}, {"cuts.0.membrane.look": "grid"}
    torso, spheres, fade, horizon = "imc-fig3-torso", "imc-fig5-spheres", "imc-fig6-falloff", "imc-fig7-horizon"
    vessels, levels = "imc-fig8-active", "imc-fig10-levels"
    return [
        *(panel(torso, cut_face), panel(torso, as_inlay), panel(torso, as_inlay, view="oblique"),
          panel(torso, as_grid, view="oblique")),
        *(panel(spheres, cut_face, view="oblique"), panel(spheres, plane, view="oblique"),
          panel(spheres, as_inlay, view="oblique"), panel(spheres, view="oblique")),
        *(panel(fade, cut_face), *(panel(fade, {"cuts.0.membrane.falloff": mm}) for mm in (8, 20, 60))),
        *(panel(horizon, plane), panel(horizon), panel(horizon, as_grid), panel(horizon, view="superior")),
        *(panel(vessels, plane, {"cuts.0.centre": [0, 0, 0]}), *active(vessels)),
        *(panel(levels, cut_face), panel(levels, plane), *(panel(levels, {"cuts.0.membrane.field.level": n}) for n in (1, 4))),
    ]


def pull(folder):
    """A cut, what is pulled out of it, and the same with a finish; without labels, and with."""
    hand = [*phantom(folder, "hand", "labels"), *OBLIQUE, "--preset", "ct-skin",
            *sets(*(f"labels.structures[{name}].opacity=1" for name in ("skin", "subcutaneous fat", "muscle"))),
            *cut(0, "axis=0,-1,0", "centre=0,13,0")]
    structures = named(folder / "hand_labels.seg.nrrd")
    soft = ("skin", "subcutaneous fat", "muscle", "flexor tendons", "extensor tendons")
    spares = [{"structure": id, "distance": 40} for name, id in structures.items() if name not in soft]
    pulled = [*hand, *sets("cuts.0.spares=" + json.dumps(spares))]
    return [HEAD_CUT, SKULL_OUT, [*SKULL_OUT, "--finish", "plate"], hand, pulled, [*pulled, "--finish", "watercolour"]]


def named(file):
    """Numbers of a file's structures by their names."""
    info = subprocess.run([sys.argv[1], "info", file, "--json"], check=True, capture_output=True)
    return {s["name"]: s["id"] for s in json.loads(info.stdout)["structures"]}


def cross_sections(folder):
    """The situations of the cross-section paper's figures 1, 7 and 9; below those of its study, figure 8: bones out of one
    plane, and out of two that open a wedge."""
    def study(name, planes, *bones):
        numbers = named(folder / f"{name}_labels.seg.nrrd")
        words = [*phantom(folder, name, "labels"), "--preset", "ct-skin", *OBLIQUE, *near(28), *AS_MATERIAL, *WHOLE, *sets(
            "labels.structures[skin].showAs=solid", "labels.structures.*.color=0.93,0.88,0.76",
            *(f"labels.structures[{of}].color={color}" for of, color in FLESH.items()))]
        for i, plane in enumerate(planes):
            spares = [{"structure": numbers[bone], "distance": mm} for bone, of, mm in bones if of == i]
            words += cut(i, *plane, "spares=" + json.dumps(spares), *["joined=true"] if i else [])
        return words
    middle = "proximal phalanx of middle finger"
    front = ("axis=0,-1,0", "centre=0,11,0")
    return [
        *(golden(folder, name, near_enough=True) for name in ("acs-fig1-torso", "acs-fig7-finish", "acs-fig9-ct")),
        study("hand", [front], ("proximal phalanx of index finger", 0, 9), (middle, 0, 20), ("hamate", 0, 12), ("scaphoid", 0, 8)),
        [*study("hand", [front, ("axis=1,0,0", "centre=-5,0,0")], ("radius", 0, 8), ("hamate", 0, 12),
                ("fourth metacarpal", 0, 14), ("proximal phalanx of ring finger", 0, 10), ("third metacarpal", 1, 9), (middle, 1, 6)),
         *sets("camera.eye=330,-380,140", "camera.target=0,0,0")],
        study("foot", [("axis=-1,0,0", "centre=0,0,0")], ("calcaneus", 0, 14), ("tibia", 0, 9), ("cuboid", 0, 18),
              ("lateral cuneiform", 0, 6)),
    ]


def finish(_):
    return [[*SKULL_OUT, "--finish", name] for name in ("watercolour", "pencil", "ink", "engraving", "chalk", "wax")]


def labels(_):
    return [[*REGIONS, *OPENED], [*REGIONS, *SPARED], [*REGIONS, *SPARED, *sets("labels.tint=0")]]


def layers(_):
    """One render, and what lies beside its picture."""
    return [([*REGIONS, *SPARED, "--transparent", "--layers"], ("", ".normal", ".depth", ".id"))]


def turn(_):
    return [([WELCOME, *near(28), "--frames", "4", "--animate", "turn"], ("-0000", "-0001", "-0002", "-0003"))]


def films(folder):
    """Five frames of a film each: a membrane sinks into a head, structures come out of a trunk, a virion is opened and filled again."""
    frames = tuple(f"-{i:04}" for i in range(5))
    pulled, spikes = first_plate(folder)[1], first_virus(folder)[1]
    return [(words, frames) for words in (
        [WELCOME, *near(28), "--frames", "5", "--animate", "membrane"],
        [*pulled, "--frames", "5", "--animate", "pull overlap=0 hold=0"],
        [*spikes, *near(21), "--frames", "5", "--animate", "equalize hold=0"])]


def head_film(_):
    """A head is cut open, its skull comes out of the cut, the eye goes round."""
    return [*SKULL_OUT, "--fps", "25", "--animate", "cut seconds=2.5", "--animate", "pull start=2.5 seconds=2.5 hold=0.1",
            "--animate", "turn start=4.5 seconds=5.5 gently=true"]


def models(folder):
    """A virion in its looks; below a membrane about the capsid, a cut that leaves shares, and the inside from near."""
    virion = [folder / "virion.cif", "--view", "anterior"]
    opened = cut(0, "axis=0,-1,0", "centre=0,0,0")
    around = folder / "capsid.json"
    run(sys.argv[1], "membrane", folder / "virion.cif", "--protect-type", "capsid", "--axis", "0,-1,0", "--position", "0.5",
        "--set", "camera.fieldOfViewDeg=15", "--save-scene", around)
    return [
        [*virion, "--preset", "painted", *near(21), *opened],
        [*virion, "--preset", "soft", *near(21), *opened],
        [*virion, "--preset", "technical", *near(6), *opened],
        [around, "--preset", "painted", "--view", "anterior", *near(12), *sets("cuts.0.size=3000,3000,900")],
        [*virion, "--preset", "painted", *near(21),
         *cut(0, "shape=sphere", "centre=0,-600,0", "size=1700,1700,1700", "model.spares=[{\"type\":\"root.plasma\",\"share\":0.04}]")],
        [*virion, "--preset", "painted", *near(5), *opened],
    ]


def equalizer(folder):
    """What a cut can leave of a virion, the plain cut first: the panels of the golden picture, finer."""
    case = json.loads((GOLDEN / "ve-views" / "case.json").read_text())
    panels = []
    for panel in case["panels"]:
        fields = {**case["set"], **panel["set"], "rayCast.samplesPerPixel": SAMPLES}
        shape = fields.pop("cuts.0.shape")
        panels.append([folder / "virion.cif", "--preset", case["preset"], "--view", case["view"],
                       *sets(f"cuts.+.shape={shape}", *(f"{path}={json.dumps(value)}" for path, value in fields.items()))])
    return panels


def sheet(folder):
    seen = sets(*(f"labels.structures[{name}].visible=false" for name in HIDDEN), "labels.unlabelled=0")
    return [
        SKULL_OUT,
        [*REGIONS, *SPARED],
        [*TRACTS, *OBLIQUE, *cut(0, "axis=-1,-0.25,0.6", "centre=4,10,12", "spares=" + ids(1, 50))],
        [*MACAQUE, *OBLIQUE, *cut(0, "shape=box", "centre=-25,-25,25", "size=50,50,40")],
        [TEMPLATES + "ch2better.nii.gz", *OBLIQUE,
         *cut(0, "shape=box", "centre=-50,-60,60", "size=100,120,100", "face=section")],
        [*phantom(folder, "torso", "labels"), *OBLIQUE, "--preset", "ct-muscle", *seen],
        [*phantom(folder, "vessels", "labels"), *OBLIQUE,
         *sets("labels.unlabelled=0", "lighting.shadow=0.3", "lighting.ambient=0.5")],
        [*phantom(folder, "neurons", "labels"), *OBLIQUE, *sets("labels.unlabelled=0")],
        [*phantom(folder, "seismic"), *OBLIQUE, *near(24),
         *cut(0, "shape=box", "axis=0,0,1", "centre=-850000,-850000,450000", "size=1700000,1700000,900000", "face=section")],
    ]


def first_plate(folder):
    """The guide's first pictures, as its commands draw them: of a trunk the cut, what is pulled out of it, the plate."""
    trunk = [*phantom(folder, "torso", "labels"), "--preset", "ct-skin", *OBLIQUE, *near(19),
             *sets("camera.eye=210,-760,640", "camera.target=0,-5,-52", *(f"labels.structures[{name}].opacity=1" for name in HIDDEN)),
             *cut(0, "axis=0,0,1", "centre=0,0,-45")]
    spares = [{"structure": number, "distance": mm} for number, mm in ((27, 120), (9, 120), (29, 95), (33, 60), (34, 60), (35, 60))]
    pulled = [*trunk, *sets("cuts.0.spares=" + json.dumps(spares))]
    return [trunk, pulled, [*pulled, "--finish", "plate", *sets("finish.contourStructures=0")]]


def first_ct(folder):
    """A section; a plane; a membrane in the same place, which the program hangs."""
    trunk, opened = phantom(folder, "torso"), folder / "opened-ct.json"
    look = ["--preset", "ct-muscle", "--view", "anterior"]
    run(sys.argv[1], "membrane", *trunk, "--protect", "200,3000", "--axis", "0,-1,0", "--position", "0.7", *look, "--save-scene", opened)
    frame = json.loads(opened.read_text())["cuts"][0]
    place = [f"{key}={','.join(str(number) for number in frame[key])}" for key in ("axis", "centre")]
    return [
        [*trunk, "--section", "axial", *sets("volume.windowLevel=40", "volume.windowWidth=400")],
        [*trunk, *look, *cut(0, *place)],
        [opened],
    ]


def first_cells(folder):
    """Neurons; the section on a plane; two of them, grown and pulled out."""
    neurons, first, both = folder / "neurons.nrrd", folder / "first.seg.nrrd", folder / "both.seg.nrrd"
    run(sys.argv[1], "sample", "neurons", "-o", neurons, "--voxels", "128")  # the seeds are those of the guide
    values = ["--range", "3600,8000"]
    run(sys.argv[1], "grow", neurons, "--seed", "-0.0215,0.0375,-0.0065", *values, "-o", first)
    run(sys.argv[1], "grow", neurons, "--labels", first, "--seed", "0.0215,0.0295,-0.0405", *values, "-o", both)
    plane = [*OBLIQUE, *cut(0, "axis=0,-1,0", "centre=0,0.036,0", "face=section")]
    spares = [{"structure": number, "distance": 0.1} for number in (1, 2)]
    return [[neurons, *OBLIQUE], [neurons, *plane], [neurons, both, *plane, *sets("cuts.0.spares=" + json.dumps(spares))]]


def first_virus(folder):
    """A virion cut; spikes brought back and plasma thinned; the way to the capsid cleared."""
    virion, opened = [folder / "virion.cif", "--view", "anterior"], folder / "opened.json"
    run(sys.argv[1], "count", *virion, "--clear-the-way", "capsid_monomer", "-o", opened)
    half = cut(0, "axis=0,-1,0")
    spikes = folder / "spikes.json"
    run(sys.argv[1], "count", *virion, *half, "--set-count", "spike=60", "-o", spikes)
    thinned = cut(1, "shape=everywhere", 'model.spares=[{"type":"root","share":1},{"type":"root.plasma","share":0.4}]')
    return [
        [*virion, *half],
        [spikes, *thinned],
        [opened, "--view", "anterior"],
    ]


def plate(folder):
    """Plates as SVG: a hand whose bones are named, a head in a membrane, a virus with its types."""
    atlas = ["--style", "atlas", "--page-width", "120"]
    soft = ("skin", "subcutaneous fat", "muscle", "artery", "vein", "flexor tendons", "extensor tendons", "cartilage")
    hand = [*phantom(folder, "hand", "labels"), "--view", "anterior", "--finish", "ink", "--names", "--scale-bar", *atlas, *near(34),
            *sets("lettering.mostNames=22", "labels.unlabelled=0", *(f"labels.structures[{name}].visible=false" for name in soft))]
    head = [WELCOME, "--finish", "plate", "--names", "--scale-bar", *atlas, *near(34), *sets("lettering.mostNames=12")]
    virus = [folder / "virion.cif", "--view", "anterior", "--finish", "plate", "--names", "--scale-bar", *atlas, *near(17),
             *cut(0, "shape=sphere", "centre=250,-520,200", "size=1100,1100,1100"),
             *cut(1, "shape=everywhere", 'model.spares=[{"type":"root","share":1},{"type":"root.plasma","share":0}]'),
             *sets("lettering.mostNames=8", "lettering.nameOrder=around")]
    return [hand, head, virus]


def brain_cells(folder):
    """A brain of 20 GB: nerve cells, grown in the voxels of the finest level, stand on a cut through all of it. Half an hour;
    VELUM_BRAIN names the store if it is there already."""
    brain, cells, scene = os.environ.get("VELUM_BRAIN", folder / "brain.ome.zarr"), folder / "cells.ome.zarr", folder / "cells.json"
    if not pathlib.Path(brain).exists():
        run(sys.argv[1], "sample", "brain", "--voxels", "2830", "-o", brain)
    seeds = [word for seed in BRAIN_SEEDS for word in ("--seed", seed)]
    over = ["--plane", "0,0,1,0.53", "--distance", "0.45"]  # what stands on the cut
    run(sys.argv[1], "grow", brain, *seeds, "--range", "900,6000", *over, "--name", "nerve cells", "-o", cells)
    tissue = [(400, (0.30, 0.12, 0.14)), (480, (0.50, 0.22, 0.22)), (560, (0.74, 0.45, 0.40)), (640, (0.90, 0.70, 0.62)), (1500, (1, 0.93, 0.78))]
    opaque = [{"value": 250, "opacity": 0}, {"value": 350, "opacity": 0.95}]
    colors = [{"value": value, "color": color} for value, color in tissue]
    scene.write_text(json.dumps({
        "velum": 4,
        "volume": {"source": {"path": str(brain)}, "transfer": {"colors": colors, "opacities": opaque, "unitDistance": 0.006}},
        "labels": {"source": {"path": str(cells)}, "unlabelled": 1,
                   "structures": [{"id": 1, "name": "nerve cells", "color": [1, 0.80, 0.35], "showAs": "solid"}]},
        "cuts": [{"name": "Upper part", "shape": "plane", "centre": [0, 0, 0.55], "axis": [0, 0, 1], "spares": [{"structure": 1}]}],
        "camera": {"eye": [-3.7, -2.7, 2.3], "target": [-1.9, 0.9, 0.68], "up": [0, 0, 1], "fieldOfViewDeg": 30}}))
    return [[scene, "--gpu-brick-memory", "5GiB"]]


# name: (columns, size of a panel, colour of the gaps, what gives the panels: the arguments of `velum-batch render`, or
# these and the endings of the pictures that one render gives).
PLATES = {
    "systems": (3, (600, 540), DARK, systems),
    "presets": (3, (480, 400), DARK, presets),
    "cuts": (3, (480, 400), DARK, cuts),
    "labels": (3, (480, 400), DARK, labels),
    "membrane": (3, (480, 400), DARK, membrane),
    "pull": (3, (480, 400), DARK, pull),
    "cross-sections": (3, (480, 440), DARK, cross_sections),
    "finish": (3, (480, 400), WHITE, finish),
    "situations": (4, (300, 240), DARK, situations),
    "layers": (4, (400, 340), WHITE, layers),
    "turn": (4, (360, 300), DARK, turn),
    "films": (5, (260, 220), DARK, films),
    "models": (3, (400, 340), WHITE, models),
    "equalizer": (3, (400, 340), WHITE, equalizer),
    "sheet": (3, (480, 400), DARK, sheet),
    "first-plate": (3, (400, 340), DARK, first_plate),
    "first-ct": (3, (400, 340), DARK, first_ct),
    "first-cells": (3, (400, 340), DARK, first_cells),
    "first-virus": (3, (400, 340), WHITE, first_virus),
    "plate": (3, (480, 440), WHITE, plate),
    "brain-cells": (1, (1200, 800), DARK, brain_cells),
}
# name: (size, what gives the film: the arguments of `velum-batch film`).
FILMS = {"head": ((480, 400), head_film)}
DRAWINGS = ("plate",)  # mounted as SVG is seen
BY_NAME_ONLY = {"brain-cells"}  # they take too long
PHANTOMS = {"systems": ("virion",), "first-plate": ("torso",), "first-ct": ("torso",), "first-virus": ("virion",), "films": ("torso", "virion"), "models": ("virion",), "equalizer": ("virion",), "situations": ("torso", "two-spheres", "seismic", "vessels"), "membrane": ("torso", "heart"), "pull": ("hand",), "plate": ("hand", "virion"), "cross-sections": ("torso", "hand", "foot"), "sheet": ("torso", "vessels", "neurons", "seismic")}


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def put_on_white(panel, size):
    area = f"{size[0]}x{size[1]}"
    run("oiiotool", panel, "--create", area, 4, "--fill:color=1,1,1,1", area, "--over", "-o", panel)


def mount(panels, columns, size, ground, out):
    """Panels side by side, as a JPEG that is as good as its size allows."""
    rows = -(-len(panels) // columns)
    whole = "x".join(str(count * (length + GAP) - GAP) for count, length in zip((columns, rows), size))
    plate = ["--create", whole, 3, f"--fill:color={ground}", whole]
    for i, panel in enumerate(panels):
        x, y = (i % columns) * (size[0] + GAP), (i // columns) * (size[1] + GAP)
        plate += [panel, "--ch", "R,G,B", "--swap", "--paste", f"+{x}+{y}"]
    for quality in (90, 86, 82, 78, 74, 70):
        run("oiiotool", *plate, "--eraseattrib", ".*", "--compression", f"jpeg:{quality}", "-o", out)
        if out.stat().st_size <= MOST_BYTES:
            return
    sys.exit(f"pictures: {out} is larger than {MOST_BYTES} bytes: make its panels smaller")


def draw_plate(batch, name, folder, out):
    columns, size, ground, describe = PLATES[name]
    panels = []
    for i, panel in enumerate(describe(folder)):
        arguments, endings = panel if isinstance(panel, tuple) else (panel, ("",))
        if name in DRAWINGS:  # of twice the size
            drawing, panels = folder / f"{name}{i}.svg", [*panels, folder / f"{name}{i}.png"]
            run(batch, "render", *arguments, "-o", drawing, "--size", f"{2 * size[0]}x{2 * size[1]}", "--samples", SAMPLES)
            run("rsvg-convert", "--unlimited", "-w", str(size[0]), "-o", panels[-1], drawing)
            continue
        run(batch, "film" if "--animate" in arguments else "render", *arguments, "-o", folder / f"{name}{i}.png", "--size", f"{size[0]}x{size[1]}", "--samples", SAMPLES)
        panels += [folder / f"{name}{i}{ending}.png" for ending in endings]
        if ".depth" in endings:  # which has one channel
            depth = folder / f"{name}{i}.depth.png"
            run("oiiotool", depth, "--ch", "0,0,0", "--chnames", "R,G,B", "-o", depth)
        if "--transparent" in arguments:
            put_on_white(panels[-len(endings)], size)
    mount(panels, columns, size, ground, out / f"{name}.jpg")


def draw_film(batch, name, folder, out):
    size, describe = FILMS[name]
    run(batch, "film", *describe(folder), "-o", out / f"{name}.mp4", "--size", f"{size[0]}x{size[1]}", "--samples", 4, "--quality", 50)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    batch, out = sys.argv[1], pathlib.Path(sys.argv[2])
    names = sys.argv[3:] or [name for name in (*PLATES, *FILMS) if name not in BY_NAME_ONLY]
    if unknown := set(names) - set(PLATES) - set(FILMS):
        sys.exit(f"pictures: no picture is called {', '.join(unknown)}; there are {', '.join((*PLATES, *FILMS))}")
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for name in names:
            for phantom_name in PHANTOMS.get(name, ()):
                ending = "cif" if phantom_name == "virion" else "nrrd"
                run(batch, "sample", phantom_name, "-o", folder / f"{phantom_name}.{ending}")
            (draw_film if name in FILMS else draw_plate)(batch, name, folder, out)


if __name__ == "__main__":
    main()
