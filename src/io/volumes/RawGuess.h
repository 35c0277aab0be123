#pragma once
#include <filesystem>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Source.h"

/// Files without a header: what their samples could be, so that a person has to choose rather than to know.
namespace velum::io {

/// No reader knows it, and nothing says that it holds no samples: it opens once its layout is given. False for what
/// does not exist. Any thread.
bool needsLayout(const std::filesystem::path& path);

/// Bytes of all samples of a layout, its header included.
double bytesOf(const scene::RawLayout& layout);

/// The layouts that fill a file to its last byte, the likeliest first: cubes, and stacks of square or usual planes, or
/// what stands in the file's name ("head_256x256x109_uint16.raw"), of each type and byte order. Likely is what would
/// take the fewest bits to write down by the differences of neighbouring samples, with something added for planes that
/// are not square and for headers. Empty where nothing fits, and for compressed files, whose length tells nothing.
/// @throw InputError when it cannot be read; Cancelled. Any thread. Reads some 600 KiB for each candidate.
std::vector<scene::RawLayout> guessLayouts(const std::filesystem::path& path, Progress& progress);

/// One plane of a headerless file, as a volume of one plane. @param z  0..dims.z-1
/// @throw InputError when the file ends before it, or is compressed. Any thread.
Volume readRawPlane(const scene::Source& source, int z);

}  // namespace velum::io
