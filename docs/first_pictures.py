#!/usr/bin/env python3
"""Draws the first picture of each volume of a folder, as it opens, without anything being chosen, and a sheet of them.

docs/images/first.jpg is the sheet of those whose licences let pictures of them be passed on; CREDITS.md names their
owners. usage: first_pictures.py BATCH DATA FOLDER [NAME...]; with names, or --all, the single pictures stay in FOLDER,
too. DATA is the folder that VELUM_TEST_DATA names; oiiotool mounts the sheet (Debian package openimageio-tools).
"""
import pathlib
import subprocess
import sys
import tempfile
import zipfile

SIZE = (300, 240)
COLUMNS = 6
GAP = 4
MOST_BYTES = 250_000

BRAIN = ["--raw", "128x128x84:uint8:+62", "--spacing", "1,1,1.5"]

# What is opened, and, if it needs any, words about how it lies in the file. Those of the sheet.
SHOWN = {
    "ct_thorax_lidc0314_dicom.zip": [],
    "ct_torso_contrast_lidc2.mha": [],
    "ct_torso_contrast_lidc2.vti": [],
    "ct_heart_aorta_cta.nii.gz": [],
    "ct_heart_aorta_cta_labels.nii.gz": [],
    "ct_abdomen_3mm.nii.gz": [],
    "ct_abdomen_3mm_vertebrae.nii.gz": [],
    "ct_abdomen_3mm_crop.nii.gz": [],
    "ct_abdomen_3mm_crop_organs.nii.gz": [],
    "ct_head_pitch_oblique.nii.gz": [],
    "ct_head_avm_angio.nii.gz": [],
    "ct_engine.vti": [],
    "xa_aneurism.vti": [],
    "ct_mouse_head.nii.gz": [],
    "ct_mouse_head_labels.nii.gz": [],
    "ct_mouse_head_35um_labels.seg.nrrd": [],
    "tooth.nhdr": [],
    "ct_tooth_u8.nrrd": [],
    "frogtissue.mhd": [],
    "mr_head_ch2.nii.gz": [],
    "mr_head_ch2_aal_labels.nii.gz": [],
    "mr_fetal_brain_template.nrrd": [],
    "micro_mousebrain_tiff_stack.zip": ["--spacing", "0.04,0.04,0.05"],
    "micro_mousebrain_100um.tiff": [],
    "micro_mousebrain_100um_hemispheres.tiff": [],
    "micro_axons_120.tif": [],
    "micro_axons_120_labels.tif": [],
    "micro_lightsheet_brain_10planes.tif": [],
    "us_spine_phantom_3d.mha": [],
    "us_spine_phantom_sweep.igs.mha": [],
    "raw_ct_headsq_slices.zip": ["--raw", "64x64x93:uint16", "--spacing", "3.2,3.2,1.5"],
    "raw_mr_brainsmall.den.gz": BRAIN,
}
# For tests alone, under terms of their own, or of an origin that is not stated.
NOT_SHOWN = {
    "ct_iguana_head.nii.gz": [],
    "embryo_mouse.nrrd": [],
    "seis_f3_crop.sgy": [],
    "seis_volve_inline.sgy": [],
    "seis_volve_velocity.sgy": [],
}


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def opened(path, words, folder):
    """What to open: the file; of an archive, what is in it; slices of raw numbers as one file."""
    if path.suffix != ".zip":
        return path
    place = folder / path.stem
    with zipfile.ZipFile(path) as archive:
        archive.extractall(place)
    inner = [p for p in place.iterdir() if p.is_dir()]
    if "--raw" not in words:
        return inner[0]
    slices = sorted((p for p in inner[0].iterdir() if p.suffix[1:].isdigit()), key=lambda p: int(p.suffix[1:]))
    whole = place / "slices.raw"
    whole.write_bytes(b"".join(p.read_bytes() for p in slices))
    return whole


def draw(batch, data, name, words, folder, out):
    picture = out / f"first-{name}.png"
    run(batch, "render", opened(data / name, words, folder), *words, "-o", picture, "--size", f"{SIZE[0]}x{SIZE[1]}",
        "--samples", 8)
    return picture


def mount(pictures, out):
    rows = -(-len(pictures) // COLUMNS)
    whole = f"{COLUMNS * (SIZE[0] + GAP) - GAP}x{rows * (SIZE[1] + GAP) - GAP}"
    plate = ["--create", whole, 3, "--fill:color=0.035,0.04,0.045", whole]
    for i, picture in enumerate(pictures):
        x, y = (i % COLUMNS) * (SIZE[0] + GAP), (i // COLUMNS) * (SIZE[1] + GAP)
        plate += [picture, "--ch", "R,G,B", "--swap", "--paste", f"+{x}+{y}"]
    for quality in (90, 84, 78, 72, 66):
        run("oiiotool", *plate, "--eraseattrib", ".*", "--compression", f"jpeg:{quality}", "-o", out)
        if out.stat().st_size <= MOST_BYTES:
            return


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    batch, data, out, names = sys.argv[1], pathlib.Path(sys.argv[2]) / "volumes", pathlib.Path(sys.argv[3]), sys.argv[4:]
    rows = SHOWN | NOT_SHOWN if names else SHOWN
    if names and names != ["--all"]:
        rows = {name: rows[name] for name in names}
    with tempfile.TemporaryDirectory() as folder:
        place = out if names else pathlib.Path(folder)
        pictures = [draw(batch, data, name, words, pathlib.Path(folder), place) for name, words in rows.items()]
        mount(pictures, out / "first.jpg")


if __name__ == "__main__":
    main()
