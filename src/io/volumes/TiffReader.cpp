#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/Error.h"
#include "io/Plugins.h"
#include "io/read/FileNames.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/Readers.h"
#include "io/volumes/TiffStack.h"

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

PlaneShape shapeOf(const OIIO::ImageSpec& spec, const Path& path) {
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
    refuse(path, fmt::format("a plane of {} x {} x {} pixels is not read", spec.width, spec.height, spec.depth));
  // The library allocates a tile of the size that the header tells.
  if (double(spec.tile_width) > 4096.0 + 2.0 * spec.width || double(spec.tile_height) > 4096.0 + 2.0 * spec.height)
    refuse(path, fmt::format("tiles of {} x {} make no sense", spec.tile_width, spec.tile_height));
  return {spec.width, spec.height, spec.nchannels, sampleTypeOf(spec, path)};
}

std::unique_ptr<OIIO::ImageInput> openInput(const Path& path) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // samples as they are, never multiplied by alpha
  auto in = OIIO::ImageInput::open(path.string(), &config);
  if (!in) refuse(path, fmt::format("cannot be read as a picture ({})", OIIO::geterror()));
  return in;
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

void readPages(const TiffStack& stack, const PlaneShape& shape, OIIO::ImageInput& in, Volume& v,
               const std::vector<PlaneTarget>& planes, Progress& progress) {
  v.voxels.resize(timeStepBytes(v) * std::size_t(v.timeSteps));
  for (std::size_t i = 0; i < planes.size(); ++i) {
    progress.report(double(i) / double(planes.size()), "reading TIFF pages");
    int directory = stack.pages[std::size_t(planes[i].page)];
    if (directory != 0 && !(shapeOf(in.spec(directory), stack.path) == shape))
      refuse(stack.path, fmt::format("page {} is {}, but the first is {}", directory + 1,
                                     words(shapeOf(in.spec(directory), stack.path)), words(shape)));
    readPlane(in, directory, shape, v, planes[i], stack.path);
  }
}

Volume readFile(const Path& path, Progress& progress) {
  TiffStack stack = describeTiff(path);
  auto in = openInput(path);
  if (stack.pages[0] != 0 && !in->seek_subimage(stack.pages[0], 0)) refuse(path, "the first page cannot be read");
  PlaneShape shape = shapeOf(in->spec(stack.pages[0]), path);
  Volume v;
  if (isOnePageStack(stack)) {
    v = readSamples(describeOnePageStack(stack, shape), progress);
  } else {
    TiffVolume arranged = arrangePlanes(stack, shape);
    v = std::move(arranged.head);
    readPages(stack, shape, *in, v, arranged.planes, progress);
  }
  if (stack.file.pages[0].samples == 1 && shape.channels == 3)
    v.warnings.push_back("the pages have a colour table; they are read as colours");
  describeHead(v, stack);
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
      TiffStack plane = describeTiff(path);
      if (plane.pages.size() > 1)
        refuse(path, fmt::format("a plane of a folder must have one page, this has {}", plane.file.pages.size()));
      most = mostBytes(plane.file);
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
  markAsPlanes(volume);
  progress.report(1, "reading TIFF");
  return volume;
}

}  // namespace velum::io
