#include "io/volumes/TiffStack.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "io/read/FileBytes.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"

namespace velum::io {

namespace {

/// The directories of full-resolution pages, all of one size.
std::vector<int> fullPages(const TiffPages& file, const Path& path) {
  std::vector<int> full;
  const TiffPage* first = nullptr;
  for (std::size_t i = 0; i < file.pages.size(); ++i) {
    const TiffPage& page = file.pages[i];
    if (page.isReduced) continue;
    if (!first) first = &page;
    if (page.width != first->width || page.height != first->height || page.samples != first->samples ||
        page.bits != first->bits)
      refuse(path, fmt::format("page {} is {} x {} ({} samples of {} bits), but the first is {} x {} ({} of {}); a "
                               "volume needs pages of one size",
                               i + 1, page.width, page.height, page.samples, page.bits, first->width, first->height,
                               first->samples, first->bits));
    full.push_back(int(i));
  }
  if (full.empty()) refuse(path, "the file has thumbnails only");
  return full;
}

void setSpacing(Volume& v, TiffLayout layout, const TiffPage& page) {
  glm::dvec3 s = layout.spacing;
  if (layout.kind == TiffLayout::Kind::ImageJ && layout.unitMm > 0) {
    if (page.xResolution > 0) s.x = layout.unitMm / page.xResolution;
    if (page.yResolution > 0) s.y = layout.unitMm / page.yResolution;
  }
  auto isKnown = [](double mm) { return mm >= 1e-9 && mm <= 1e5; };
  if (isKnown(s.x) && !isKnown(s.y)) s.y = s.x;
  v.isSpacingKnown = isKnown(s.x) && isKnown(s.y) && (isKnown(s.z) || v.dims.z == 1);
  if (isKnown(s.x) && isKnown(s.y) && !isKnown(s.z)) {
    s.z = s.x;
    if (v.dims.z > 1)
      v.warnings.push_back(
          "the file tells the size of a pixel but not the distance of planes; they are taken as equal");
    v.isSpacingKnown = true;
  }
  v.worldFromVoxel = gridMatrix(v.isSpacingKnown ? s : glm::dvec3(1.0));
}

}  // namespace

std::string words(const PlaneShape& s) {
  return fmt::format("{} x {}, {} channels, {}", s.width, s.height, s.channels, enumName(s.type));
}

/// Bytes that one stored byte can become at most, by compression scheme; zstd and LZMA know hardly a limit.
double mostExpansion(std::uint64_t compression) {
  if (compression == 1) return 1;
  return compression == 50000 || compression == 34925 ? 60000 : 3000;
}

TiffPages scanPages(const Path& path) {
  FileBytes check(path);  // for its messages
  std::ifstream file(path, std::ios::binary);
  TiffPages pages = scanTiff(file, path.string());
  for (std::size_t i = 0; i < pages.pages.size(); ++i)
    if (!pages.pages[i].isDataInside) refuse(path, fmt::format("the file is cut short: page {} is not whole", i + 1));
  if (pages.isTruncated) refuse(path, fmt::format("the file is cut short after {} whole pages", pages.pages.size()));
  return pages;
}

double mostBytes(const TiffPages& file) {
  double most = 0;
  for (const auto& page : file.pages) {
    // Packed bits (1, 4, 12) grow to whole bytes.
    double unpack = page.bits % 8 == 0 ? 1.0 : 8.0;
    double palette = page.samples == 1 && page.bits <= 8 ? 3.0 : 1.0;
    most += double(page.dataBytes) * mostExpansion(page.compression) * unpack * palette;
  }
  return most;
}

TiffStack describeTiff(const Path& path) {
  TiffStack stack;
  stack.path = path;
  stack.file = scanPages(path);
  stack.layout = parseTiffDescription(stack.file.description, path.filename().string());
  stack.pages = fullPages(stack.file, path);
  TiffLayout& layout = stack.layout;
  if (layout.sizeZ == 0 || layout.kind == TiffLayout::Kind::Plain) {
    layout.sizeZ = stack.pages.size() / std::max<std::uint64_t>(1, layout.sizeC * layout.sizeT);
    if (layout.sizeZ == 0) layout.sizeZ = 1;
  }
  return stack;
}

void setShape(Volume& v, const PlaneShape& shape, std::uint64_t z, std::uint64_t channelPlanes, std::uint64_t t) {
  v.dims = {shape.width, shape.height, int(z)};
  v.type = shape.type;
  v.channels = shape.channels * int(channelPlanes);
  v.timeSteps = int(t);
  v.isColor = channelPlanes == 1 && (shape.channels == 3 || shape.channels == 4);
}

TiffVolume arrangePlanes(const TiffStack& stack, const PlaneShape& shape) {
  const TiffLayout& layout = stack.layout;
  std::uint64_t samples = std::uint64_t(shape.channels);
  // In OME, SizeC counts the samples of RGB pages too.
  std::uint64_t channelPlanes =
      layout.kind == TiffLayout::Kind::Ome && layout.sizeC % samples == 0 ? layout.sizeC / samples : layout.sizeC;
  TiffVolume arranged;
  arranged.planes = placePlanes(layout, channelPlanes, stack.pages.size());
  if (arranged.planes.empty())
    refuse(stack.path,
           fmt::format("the description promises {} x {} x {} planes (z, channels, time), but the file has {} pages{}",
                       layout.sizeZ, layout.sizeC, layout.sizeT, stack.pages.size(),
                       layout.hasOtherFiles ? "; the others are in other files" : " that fit"));
  checkedBytes(stack.path, {shape.width, shape.height, double(layout.sizeZ)}, double(channelPlanes) * shape.channels,
               double(layout.sizeT), sampleSize(shape.type), mostBytes(stack.file));
  setShape(arranged.head, shape, layout.sizeZ, channelPlanes, layout.sizeT);
  return arranged;
}

bool isOnePageStack(const TiffStack& stack) {
  const TiffLayout& layout = stack.layout;
  return layout.kind == TiffLayout::Kind::ImageJ && stack.file.pages.size() == 1 &&
         layout.sizeZ * layout.sizeC * layout.sizeT > 1 && stack.file.pages[0].compression == 1;
}

UnreadVolume describeOnePageStack(const TiffStack& stack, const PlaneShape& shape) {
  const TiffPage& page = stack.file.pages[0];
  const TiffLayout& from = stack.layout;
  if (from.sizeC > 1 && shape.channels > 1)
    refuse(stack.path, "a stack of several channels of colours behind one page is not read; save it as OME-TIFF");
  bool isPlain = page.bits == sampleSize(shape.type) * 8 && page.samples == std::uint64_t(shape.channels) &&
                 page.tileWidth == 0 && page.isOneStretch && (page.planar == 1 || page.samples == 1);
  if (!isPlain) refuse(stack.path, "a packed one-page stack is not read");
  Layout layout;
  layout.dims = {shape.width, shape.height, std::int64_t(from.sizeZ)};
  layout.channels = std::int64_t(from.sizeC) * shape.channels;
  layout.timeSteps = std::int64_t(from.sizeT);
  layout.type = static_cast<StoredType>(shape.type);
  layout.bigEndian = stack.file.isBigEndian;
  layout.channelOrder = from.sizeC > 1 ? ChannelOrder::Planes : ChannelOrder::Together;
  UnreadVolume unread = promiseSamples(layout, {{stack.path, page.firstStrip}}, stack.path);
  setShape(unread.head, shape, from.sizeZ, from.sizeC, from.sizeT);
  return unread;
}

void describeHead(Volume& v, const TiffStack& stack) {
  const TiffLayout& layout = stack.layout;
  v.timeStepSeconds = v.timeSteps > 1 ? layout.timeStepSeconds : 0.0;
  bool hasNames = layout.channelNames.size() == std::size_t(v.channels) &&
                  std::any_of(layout.channelNames.begin(), layout.channelNames.end(),
                              [](const auto& name) { return !name.empty(); });
  if (hasNames) v.channelNames = layout.channelNames;
  if (layout.channelColors.size() == std::size_t(v.channels)) v.channelColors = layout.channelColors;
  if (layout.kind != TiffLayout::Kind::Plain) v.modality = Modality::Microscopy;
  setSpacing(v, layout, stack.file.pages[std::size_t(stack.pages[0])]);
}

void markAsPlanes(Volume& v) {
  v.isOrientationKnown = false;
  // Cameras of microscopes give 16 bits; scanners write other files.
  bool isOfCamera = v.type == SampleType::UInt16 && v.channels == 1;
  if (v.modality == Modality::Unknown && isOfCamera) v.modality = Modality::Microscopy;
}

}  // namespace velum::io
