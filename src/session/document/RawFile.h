#pragma once
#include <filesystem>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "scene/Source.h"

/// Files without a header, before they are opened. Any thread. @throw InputError, Cancelled
namespace velum::session {

/// True when the file opens only once the layout of its samples is given.
bool needsLayout(const std::filesystem::path& path);
/// Layouts that fill the file to its last byte, the likeliest first.
std::vector<scene::RawLayout> guessLayouts(const std::filesystem::path& path, Progress& progress);
/// Size in bytes of a file with that layout.
double bytesOf(const scene::RawLayout& layout);
/// A plane of the file as it would be read, in grey. @param z  0..dims.z-1  @param size  most pixels along the longer
/// side
Image rawPicture(const scene::Source& source, int z, int size);

}  // namespace velum::session
