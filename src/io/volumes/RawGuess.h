#pragma once
#include <filesystem>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Source.h"

/// Guesses the layout of files without a header, so that people can choose a layout instead of having to know it.
namespace velum::io {

/// True when no reader knows the file but it may hold samples, so that it can be opened once its layout is given. False
/// for a file that does not exist. Any thread.
bool needsLayout(const std::filesystem::path& path);

/// Bytes that a file with this layout has: its header and all samples.
double bytesOf(const scene::RawLayout& layout);

/// The layouts that fill a file to its last byte, the likeliest first: cubes, stacks of square or usual planes, and the
/// layout that stands in the file's name ("head_256x256x109_uint16.raw"), for each type and byte order. The likeliest
/// layout is the one whose differences of neighbouring samples could be written in the fewest bits; some bits are added
/// for planes that are not square and for headers. Empty where no layout fits, and for compressed files, whose length
/// tells nothing.
/// @throw InputError when the file cannot be read; Cancelled. Any thread. Reads some 600 KiB for each candidate.
std::vector<scene::RawLayout> guessLayouts(const std::filesystem::path& path, Progress& progress);

/// One plane of a headerless file, as a volume of one plane. @param z  0..dims.z-1
/// @throw InputError when the file ends before the plane's end, or is compressed. Any thread.
Volume readRawPlane(const scene::Source& source, int z);

}  // namespace velum::io
