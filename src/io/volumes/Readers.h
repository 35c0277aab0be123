#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/ReplaceFile.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "io/read/Payload.h"
#include "io/read/Refuse.h"
#include "scene/Source.h"

/// The readers and writers, each in the file of its name. The table in Formats.cpp lists them and chooses one by the
/// file. Each reader checks the header against the file's size before it allocates, throws InputError with the file's
/// name and the reason, reports progress, and leaves it to readVolume() to fill `range`, to make up a name that the
/// file does not give, and to apply the user's spacing. A writer fills the file that it is given, which the caller
/// commits, and returns what it could not keep, one line each.
namespace velum::io {

// Headers of our own: those of volumes whose samples lie behind a header, or of a layout that is given, are read by
// describeX(), which reads no sample, and readX() is readSamples() of that.
UnreadVolume describeNifti(const scene::Source& source);
UnreadVolume describeNrrd(const scene::Source& source);
UnreadVolume describeMetaImage(const scene::Source& source);
UnreadVolume describeMrc(const scene::Source& source);
UnreadVolume describeRaw(const scene::Source& source);
Volume readNifti(const scene::Source& source, Progress& progress);
Volume readNrrd(const scene::Source& source, Progress& progress);
Volume readMetaImage(const scene::Source& source, Progress& progress);
Volume readMrc(const scene::Source& source, Progress& progress);
std::vector<std::string> writeNifti(const Volume& volume, ReplaceFile& file, Progress& progress);
std::vector<std::string> writeNrrd(const Volume& volume, ReplaceFile& file, Progress& progress);
// GDCM
Volume readDicom(const scene::Source& source, Progress& progress);
/// Contours of a radiotherapy structure set, filled on a grid made for them: its step along the contours' planes is
/// half a millimetre where they have a patient's size.
LabelVolume readRtStruct(const scene::Source& source, Progress& progress);
LabelVolume readDicomSeg(const scene::Source& source, Progress& progress);
// VTK
Volume readVti(const scene::Source& source, Progress& progress);
Volume readVtkLegacy(const scene::Source& source, Progress& progress);
std::vector<std::string> writeVti(const Volume& volume, ReplaceFile& file, Progress& progress);
// Own or OpenImageIO, OpenVDB
Volume readSegy(const scene::Source& source, Progress& progress);
Volume readTiff(const scene::Source& source, Progress& progress);
Volume readVdb(const scene::Source& source, Progress& progress);
std::vector<std::string> writeVdb(const Volume& volume, ReplaceFile& file, Progress& progress);
Volume readRaw(const scene::Source& source, Progress& progress);
Volume readStore(const scene::Source& source, Progress& progress);  // of any format
std::vector<std::string> writeZarr(const Volume& volume, const Path& path, Progress& progress);
Volume readInvesalius(const scene::Source& source, Progress& progress);  // .inv3

}  // namespace velum::io
