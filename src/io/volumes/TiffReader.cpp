#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "core/Error.h"
#include "io/Plugins.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/read/TiffPages.h"
#include "io/volumes/Readers.h"
#include "io/volumes/TiffDescription.h"

/// TIFF files and folders of planes. Spacing is taken from OME-XML, or from the resolution tags when an ImageJ
/// description names their unit. Resolution tags alone are never taken: programs write 72 dpi there, or whatever their
/// screen had, and a volume scaled by that is worse than one with a warning.
namespace velum::io {

namespace {

SampleType sampleTypeOf(const OIIO::ImageSpec& spec, const Path& path) {
  switch (spec.format.basetype) {
    case OIIO::TypeDesc::UINT8:
      return SampleType::UInt8;
    case OIIO::TypeDesc::INT8:
      return SampleType::Int8;
    case OIIO::TypeDesc::UINT16:
      return SampleType::UInt16;
    case OIIO::TypeDesc::INT16:
      return SampleType::Int16;
    case OIIO::TypeDesc::UINT32:
      return SampleType::UInt32;
    case OIIO::TypeDesc::INT32:
      return SampleType::Int32;
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
      return SampleType::Float32;
    case OIIO::TypeDesc::DOUBLE:
      return SampleType::Float64;
    default:
      refuse(path, fmt::format("samples of type '{}' are not read", spec.format.c_str()));
  }
}

OIIO::TypeDesc typeDescOf(SampleType type) {
  constexpr OIIO::TypeDesc::BASETYPE kTypes[] = {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::INT8,   OIIO::TypeDesc::UINT16,
                                                 OIIO::TypeDesc::INT16, OIIO::TypeDesc::UINT32, OIIO::TypeDesc::INT32,
                                                 OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::DOUBLE};
  return kTypes[static_cast<int>(type)];
}

/// What all planes must agree on.
struct PlaneShape {
  int width = 0, height = 0, channels = 0;
  SampleType type = SampleType::UInt8;
  bool operator==(const PlaneShape&) const = default;
};

PlaneShape shapeOf(const OIIO::ImageSpec& spec, const Path& path) {
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
    refuse(path, fmt::format("a plane of {} x {} x {} pixels is not read", spec.width, spec.height, spec.depth));
  // The library allocates a tile of the size that the header tells.
  if (double(spec.tile_width) > 4096.0 + 2.0 * spec.width || double(spec.tile_height) > 4096.0 + 2.0 * spec.height)
    refuse(path, fmt::format("tiles of {} x {} make no sense", spec.tile_width, spec.tile_height));
  return {spec.width, spec.height, spec.nchannels, sampleTypeOf(spec, path)};
}

std::string words(const PlaneShape& s) {
  return fmt::format("{} x {}, {} channels, {}", s.width, s.height, s.channels, enumName(s.type));
}

std::unique_ptr<OIIO::ImageInput> openInput(const Path& path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // samples as they are, never multiplied by alpha
  auto in = OIIO::ImageInput::open(path.string(), &config);
  if (!in) refuse(path, fmt::format("cannot be read as a picture ({})", OIIO::geterror()));
  return in;
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

/// Reads one plane where it belongs in the volume; channels of planes that are not interleaved are strided in.
void readPlane(OIIO::ImageInput& in, int subimage, const PlaneShape& shape, Volume& v, const PlaneTarget& to,
               const Path& path) {
  std::size_t sample = sampleSize(v.type), pixel = sample * std::size_t(v.channels);
  std::size_t plane = pixel * std::size_t(v.dims.x) * std::size_t(v.dims.y);
  std::size_t offset = plane * (std::size_t(to.t) * std::size_t(v.dims.z) + std::size_t(to.z)) +
                       sample * std::size_t(to.c) * std::size_t(shape.channels);
  if (!in.read_image(subimage, 0, 0, shape.channels, typeDescOf(v.type), v.voxels.data() + offset,
                     OIIO::stride_t(pixel)))
    refuse(path, fmt::format("page {} is damaged ({})", subimage + 1, in.geterror()));
}

void setShape(Volume& v, const PlaneShape& shape, std::uint64_t z, std::uint64_t channelPlanes, std::uint64_t t) {
  v.dims = {shape.width, shape.height, int(z)};
  v.type = shape.type;
  v.channels = shape.channels * int(channelPlanes);
  v.timeSteps = int(t);
  v.isColor = channelPlanes == 1 && (shape.channels == 3 || shape.channels == 4);
}

/// ImageJ leaves the pages out of the chain when a stack is large: the planes lie one behind the other.
bool isOnePageStack(const TiffPages& file, const TiffLayout& layout) {
  return layout.kind == TiffLayout::Kind::ImageJ && file.pages.size() == 1 &&
         layout.sizeZ * layout.sizeC * layout.sizeT > 1 && file.pages[0].compression == 1;
}

void readOnePageStack(const Path& path, const TiffPages& file, const TiffLayout& layout, const PlaneShape& shape,
                      Volume& v) {
  FileBytes bytes(path);
  const TiffPage& page = file.pages[0];
  if (layout.sizeC > 1) refuse(path, "a stack of several channels behind one page is not read; save it as OME-TIFF");
  if (page.bits != sampleSize(shape.type) * 8 || page.samples != std::uint64_t(shape.channels))
    refuse(path, "a packed one-page stack is not read");
  double most = double(bytes.size()) - double(std::min(page.firstStrip, bytes.size()));
  std::size_t size = checkedBytes(path, {shape.width, shape.height, layout.sizeZ}, shape.channels, double(layout.sizeT),
                                  sampleSize(shape.type), most);
  setShape(v, shape, layout.sizeZ, 1, layout.sizeT);
  v.voxels.resize(size);
  bytes.read(page.firstStrip, v.voxels);
  toMachineOrder(v.voxels, sampleSize(v.type), file.isBigEndian);
}

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

void readPages(const Path& path, const TiffPages& file, const std::vector<int>& full, const TiffLayout& layout,
               const PlaneShape& shape, OIIO::ImageInput& in, Volume& v, Progress& progress) {
  std::uint64_t samples = std::uint64_t(shape.channels);
  // In OME, SizeC counts the samples of RGB pages too.
  std::uint64_t channelPlanes =
      layout.kind == TiffLayout::Kind::Ome && layout.sizeC % samples == 0 ? layout.sizeC / samples : layout.sizeC;
  auto targets = placePlanes(layout, channelPlanes, full.size());
  if (targets.empty())
    refuse(path,
           fmt::format("the description promises {} x {} x {} planes (z, channels, time), but the file has {} pages{}",
                       layout.sizeZ, layout.sizeC, layout.sizeT, full.size(),
                       layout.hasOtherFiles ? "; the others are in other files" : " that fit"));
  double stacked = double(channelPlanes) * shape.channels;
  std::size_t bytes = checkedBytes(path, {shape.width, shape.height, double(layout.sizeZ)}, stacked,
                                   double(layout.sizeT), sampleSize(shape.type), mostBytes(file));
  setShape(v, shape, layout.sizeZ, channelPlanes, layout.sizeT);
  v.voxels.resize(bytes);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    progress.report(double(i) / double(targets.size()), "reading TIFF pages");
    int directory = full[std::size_t(targets[i].page)];
    if (directory != 0 && !(shapeOf(in.spec(directory), path) == shape))
      refuse(path, fmt::format("page {} is {}, but the first is {}", directory + 1,
                               words(shapeOf(in.spec(directory), path)), words(shape)));
    readPlane(in, directory, shape, v, targets[i], path);
  }
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

Volume readFile(const Path& path, Progress& progress) {
  TiffPages file = scanPages(path);
  TiffLayout layout = parseTiffDescription(file.description, path.filename().string());
  auto full = fullPages(file, path);
  auto in = openInput(path);
  Volume v;
  if (full[0] != 0 && !in->seek_subimage(full[0], 0)) refuse(path, "the first page cannot be read");
  PlaneShape shape = shapeOf(in->spec(full[0]), path);
  if (layout.sizeZ == 0 || layout.kind == TiffLayout::Kind::Plain) {
    layout.sizeZ = full.size() / std::max<std::uint64_t>(1, layout.sizeC * layout.sizeT);
    if (layout.sizeZ == 0) layout.sizeZ = 1;
  }
  if (file.pages[0].samples == 1 && shape.channels == 3)
    v.warnings.push_back("the pages have a colour table; they are read as colours");
  if (isOnePageStack(file, layout))
    readOnePageStack(path, file, layout, shape, v);
  else
    readPages(path, file, full, layout, shape, *in, v, progress);
  v.timeStepSeconds = v.timeSteps > 1 ? layout.timeStepSeconds : 0.0;
  bool hasNames = layout.channelNames.size() == std::size_t(v.channels) &&
                  std::any_of(layout.channelNames.begin(), layout.channelNames.end(),
                              [](const auto& name) { return !name.empty(); });
  if (hasNames) v.channelNames = layout.channelNames;
  if (layout.channelColors.size() == std::size_t(v.channels)) v.channelColors = layout.channelColors;
  if (layout.kind != TiffLayout::Kind::Plain) v.modality = Modality::Microscopy;
  setSpacing(v, layout, file.pages[std::size_t(full[0])]);
  return v;
}

std::vector<Path> planesOf(const Path& folder) {
  std::vector<Path> tiffs, pngs;
  for (const auto& file : filesInOrder(folder)) {
    std::string e = lowerExtension(file);
    if (e == ".tif" || e == ".tiff") tiffs.push_back(file);
    if (e == ".png") pngs.push_back(file);
  }
  if (tiffs.empty() && pngs.empty()) refuse(folder, "the folder has no .tif or .png planes");
  return tiffs.empty() ? pngs : tiffs;
}

Volume readFolder(const Path& folder, Progress& progress) {
  auto planes = planesOf(folder);
  double stored = 0;
  for (const auto& path : planes) stored += double(std::filesystem::file_size(path));
  Volume v;
  PlaneShape first;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    progress.report(double(i) / double(planes.size()), "reading planes");
    const Path& path = planes[i];
    double most = 1100.0 * double(std::filesystem::file_size(path));
    if (lowerExtension(path) != ".png") {
      TiffPages file = scanPages(path);
      if (fullPages(file, path).size() > 1)
        refuse(path, fmt::format("a plane of a folder must have one page, this has {}", file.pages.size()));
      most = mostBytes(file);
    }
    auto in = openInput(path);
    PlaneShape shape = shapeOf(in->spec(), path);
    if (i > 0 && shape != first)
      refuse(path, fmt::format("the slice is {}, but the first, '{}', is {}; all slices of a folder must agree",
                               words(shape), planes[0].filename().string(), words(first)));
    checkedBytes(path, {shape.width, shape.height, 1}, shape.channels, 1, sampleSize(shape.type), most);
    if (i == 0) {
      first = shape;
      setShape(v, shape, planes.size(), 1, 1);
      v.voxels.resize(checkedBytes(folder, v.dims, v.channels, 1, sampleSize(v.type), mostExpansion(5) * stored));
    }
    readPlane(*in, 0, shape, v, {0, i, 0, 0}, path);
  }
  v.isSpacingKnown = false;
  return v;
}

}  // namespace

Volume plugin::readTiff(const scene::Source& source, Progress& progress) {
  progress.report(0, "reading TIFF");
  const Path path = source.path;
  Volume volume = std::filesystem::is_directory(path) ? readFolder(path, progress) : readFile(path, progress);
  volume.isOrientationKnown = false;
  // Cameras of microscopes give 16 bits; scanners write other files.
  bool isOfCamera = volume.type == SampleType::UInt16 && volume.channels == 1;
  if (volume.modality == Modality::Unknown && isOfCamera) volume.modality = Modality::Microscopy;
  progress.report(1, "reading TIFF");
  return volume;
}

}  // namespace velum::io
