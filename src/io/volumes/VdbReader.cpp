#include <fmt/format.h>
#include <openvdb/io/io.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>
#include <string_view>

#include "core/Error.h"
#include "core/Parallel.h"
#include "io/Plugins.h"
#include "io/read/FileBytes.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/Readers.h"
#include "io/volumes/VdbNotes.h"
#include "io/volumes/VdbWalk.h"

/// OpenVDB. Its world units are taken as millimetres, and a grid has no patient axes, unless we wrote it.
namespace velum::io {

namespace {

/// A few bytes of a sparse file can span any box, so the file's size cannot justify the dense voxels; this limit does.
constexpr double kMaxBytes = 2147483648.0;
/// A flipped integer may put a node far off. Of real sparse grids a smoke fills a tenth of its box, a level set a
/// hundredth, vessels and points that were scattered a thousandth, and these take as many bytes.
constexpr double kVoxelsPerActive = 1000, kVoxelsPerByte = 64, kVoxelsPerTile = 512;
/// So many may be read whatever the file says: 256^3. Where we have noted the size of what we wrote, 512^3: it may be
/// empty but for a few voxels.
constexpr double kFreeVoxels = 1 << 24, kNotedVoxels = 1 << 27;

using openvdb::GridBase;

/// Reads what walkVdb() has looked over. The notes stay outside: OpenVDB allocates by what they say.
GridBase::Ptr readGrid(const Path& path, const VdbGrid& found) {
  auto streamData = openvdb::SharedPtr<openvdb::io::StreamMetadata>(new openvdb::io::StreamMetadata);
  std::ifstream bytes(path, std::ios::binary);
  // OpenVDB does not look whether its reads succeed; should the file be cut meanwhile, the stream throws.
  bytes.exceptions(std::ios::eofbit | std::ios::failbit | std::ios::badbit);
  openvdb::io::setStreamMetadataPtr(bytes, streamData, false);
  openvdb::io::setVersion(bytes, {found.libraryMajor, found.libraryMinor}, found.fileVersion);
  openvdb::io::setDataCompression(bytes, found.compression);
  openvdb::io::setGridClass(bytes, openvdb::GRID_UNKNOWN);
  openvdb::io::setHalfFloat(bytes, found.isHalf);
  openvdb::io::setGridBackgroundValuePtr(bytes, nullptr);
  GridBase::Ptr grid = openvdb::FloatGrid::create();
  if (found.isDouble) grid = openvdb::DoubleGrid::create();
  grid->setSaveFloatAsHalf(found.isHalf);
  bytes.seekg(std::streamoff(found.transformAt));
  grid->readTransform(bytes);
  grid->readTopology(bytes);
  grid->readBuffers(bytes);
  return grid;
}

/// A note of a type of fixed size.
template <class T>
std::optional<T> noteOf(const VdbGrid& grid, const char* name, std::string_view type) {
  auto at = grid.notes.find(name);
  if (at == grid.notes.end() || at->second.type != type || at->second.bytes.size() != sizeof(T)) return std::nullopt;
  T value;
  std::memcpy(&value, at->second.bytes.data(), sizeof(T));
  return value;
}

bool flagOf(const VdbGrid& grid, const char* name, bool otherwise) {
  return noteOf<std::uint8_t>(grid, name, "bool").value_or(otherwise) != 0;
}

void place(Volume& v, const GridBase& grid, const openvdb::Coord& origin, const Path& path) {
  auto affine = grid.transform().baseMap()->getAffineMap();
  if (!grid.transform().isLinear() || !affine) refuse(path, "the grid's transform is not linear; resample it first");
  // OpenVDB multiplies row vectors from the left, so that its rows are our columns.
  openvdb::math::Mat4d m = affine->getMat4();
  glm::dmat4 world;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) world[column][row] = m(column, row);
  glm::dmat3 axes(world);
  placeInWorld(v, axes, world[3], {glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  v.worldFromVoxel[3] = v.worldFromVoxel * glm::dvec4(origin.x(), origin.y(), origin.z(), 1.0);
}

glm::dvec3 sizeOf(const openvdb::CoordBBox& box) {
  // In doubles: the corners may be as far apart as 32 bits allow.
  return {double(box.max().x()) - box.min().x() + 1, double(box.max().y()) - box.min().y() + 1,
          double(box.max().z()) - box.min().z() + 1};
}

/// The box that becomes the volume: what we noted when we wrote it, else the active voxels.
/// @throw InputError when neither the active voxels nor the file's size justify so many dense ones
openvdb::CoordBBox boxOf(const GridBase& grid, const VdbGrid& found, const FileBytes& file) {
  openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  bool isNoted = false;
  if (auto d = noteOf<std::array<std::int32_t, 3>>(found, vdb::kDims, "vec3i"); d && glm::min((*d)[0], (*d)[1]) > 0) {
    openvdb::CoordBBox whole({0, 0, 0}, {(*d)[0] - 1, (*d)[1] - 1, (*d)[2] - 1});
    isNoted = (*d)[2] > 0 && (box.empty() || whole.isInside(box));
    if (isNoted) box = whole;
  }
  if (box.empty()) refuse(file.path(), "the grid has no active voxels");
  glm::dvec3 dims = sizeOf(box);
  double voxels = dims.x * dims.y * dims.z;
  std::size_t sample = found.isDouble ? sizeof(double) : sizeof(float);
  if (voxels * double(sample) > kMaxBytes || glm::any(glm::greaterThan(dims, glm::dvec3(4096.0))))
    refuse(file.path(),
           fmt::format("the active voxels span {:.0f} x {:.0f} x {:.0f}; at most 4096 along an axis and 2 GiB of "
                       "voxels are read",
                       dims.x, dims.y, dims.z));
  // A tile is one value for up to 4096^3 voxels: one flipped bit.
  const openvdb::TreeBase& tree = grid.baseTree();
  auto active = double(tree.activeLeafVoxelCount()) + kVoxelsPerTile * double(tree.activeTileCount());
  double most =
      std::max({isNoted ? kNotedVoxels : kFreeVoxels, kVoxelsPerActive * active, kVoxelsPerByte * double(file.size())});
  if (voxels > most)
    refuse(file.path(), fmt::format("{:.0f} active voxels in a file of {} bytes span {:.0f} x {:.0f} x {:.0f}; at most "
                                    "{:.0f} voxels for each active one, or {:.0f} for each byte, are read. If the file "
                                    "is not damaged, crop the grid",
                                    active, file.size(), dims.x, dims.y, dims.z, kVoxelsPerActive, kVoxelsPerByte));
  return box;
}

template <class Grid>
void copyVoxels(const GridBase& grid, const openvdb::CoordBBox& box, Volume& v) {
  using Value = typename Grid::ValueType;
  const auto& typed = static_cast<const Grid&>(grid);
  auto* values = reinterpret_cast<Value*>(v.voxels.data());
  std::size_t slice = std::size_t(v.dims.x) * std::size_t(v.dims.y);
  // Leaf by leaf in our own loop, which the thread sanitizer knows, rather than in the library's.
  constexpr int kLeaf = 8;
  int low = box.min().z(), high = box.max().z(), first = low & ~(kLeaf - 1);
  parallelFor(0, (high - first) / kLeaf + 1, [&](int i) {
    openvdb::CoordBBox layer = box;
    layer.min().z() = std::max(low, first + i * kLeaf);
    layer.max().z() = std::min(high, first + (i + 1) * kLeaf - 1);
    Value* to = values + slice * std::size_t(layer.min().z() - low);
    openvdb::tools::Dense<Value, openvdb::tools::LayoutXYZ> dense(layer, to);
    openvdb::tools::copyToDense(typed, dense, true);
  });
}

void takeNotes(Volume& v, const VdbGrid& found) {
  auto text = [&](const char* name) {
    auto at = found.notes.find(name);
    return at == found.notes.end() ? std::string() : at->second.bytes;
  };
  v.lengthUnit = enumValue<LengthUnit>(text(vdb::kUnit)).value_or(LengthUnit::Millimetre);
  v.isOrientationKnown = flagOf(found, vdb::kOriented, false);
  v.isSpacingKnown = flagOf(found, vdb::kSpacing, true);
  if (!found.notes.contains(vdb::kSpacing))
    v.warnings.push_back("an OpenVDB file has no unit; its world units are taken as mm");
  v.unit = text(vdb::kValueUnit);
  v.modality = enumValue<Modality>(text(vdb::kModality)).value_or(Modality::Unknown);
  v.name = text("name");
  if (found.gridsInFile > 1)
    v.warnings.push_back(
        fmt::format("of {} grids the first of floats or doubles, {}, was taken", found.gridsInFile, inQuotes(v.name)));
}

}  // namespace

Volume plugin::readVdb(const scene::Source& source, Progress& progress) try {
  const Path path = source.path;
  progress.report(0, "reading OpenVDB");
  openvdb::initialize();
  FileBytes file(path);
  VdbGrid found = walkVdb(file);
  progress.report(0.2, "reading OpenVDB");
  auto grid = readGrid(path, found);
  progress.report(0.5, "reading OpenVDB");
  openvdb::CoordBBox box = boxOf(*grid, found, file);
  Volume v;
  v.dims = glm::ivec3(sizeOf(box));
  v.type = found.isDouble ? SampleType::Float64 : SampleType::Float32;
  v.voxels.resize(checkedBytes(path, v.dims, 1, 1, sampleSize(v.type), kMaxBytes));
  (found.isDouble ? copyVoxels<openvdb::DoubleGrid> : copyVoxels<openvdb::FloatGrid>)(*grid, box, v);
  takeNotes(v, found);
  place(v, *grid, box.min(), path);
  progress.report(1, "reading OpenVDB");
  return v;
} catch (const openvdb::Exception& e) {
  refuse(source.path, fmt::format("cannot be read by OpenVDB ({})", e.what()));
} catch (const Error&) {
  throw;
} catch (const std::bad_alloc&) {
  refuse(source.path, "is damaged, or needs more memory than there is");
} catch (const std::exception& e) {
  refuse(source.path, fmt::format("is damaged ({})", e.what()));
}

}  // namespace velum::io
