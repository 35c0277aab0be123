#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/Volume.h"
#include "io/read/Payload.h"
#include "io/read/TiffPages.h"
#include "io/volumes/TiffDescription.h"

/// What is the same for all who read a volume out of a TIFF file, whoever unpacks its pages.
namespace velum::io {

/// What all planes must agree on.
struct PlaneShape {
  int width = 0, height = 0, channels = 0;
  SampleType type = SampleType::UInt8;
  bool operator==(const PlaneShape&) const = default;
};
std::string words(const PlaneShape& shape);

/// The pages of a file that make a volume.
struct TiffStack {
  Path path;
  TiffPages file;
  TiffLayout layout;       ///< sizeZ is set
  std::vector<int> pages;  ///< those of full size, as numbers of `file.pages`; never empty
};

/// Walks the directories. @throw InputError for a file that is cut short, too
TiffPages scanPages(const Path& path);
/// @throw InputError when pages are missing or of several sizes
TiffStack describeTiff(const Path& path);

/// The bytes that the pages can unpack to at most.
double mostBytes(const TiffPages& file);
/// Bytes that one stored byte can become at most, by compression scheme.
double mostExpansion(std::uint64_t compression);

/// Gives a volume the shape of a stack of planes.
void setShape(Volume& volume, const PlaneShape& shape, std::uint64_t z, std::uint64_t channelPlanes, std::uint64_t t);

/// A volume with the shape of the stack.
struct TiffVolume {
  Volume head;
  std::vector<PlaneTarget> planes;
};
/// @throw InputError when the description promises other planes than there are, or more than the file can hold
TiffVolume arrangePlanes(const TiffStack& stack, const PlaneShape& shape);

/// ImageJ leaves the pages out of the chain when a stack is large: the planes lie one behind the other.
bool isOnePageStack(const TiffStack& stack);
/// @throw InputError
UnreadVolume describeOnePageStack(const TiffStack& stack, const PlaneShape& shape);

/// Spacing, names, colours, time steps and kind, once the shape is set.
void describeHead(Volume& volume, const TiffStack& stack);
/// What is said of volumes of planes of any file.
void markAsPlanes(Volume& volume);

}  // namespace velum::io
