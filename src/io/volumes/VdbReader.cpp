#include <fmt/format.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>

#include "Readers.h"
#include "VdbNotes.h"
#include "read/FileBytes.h"
#include "read/SampleBytes.h"
#include "velum/core/Error.h"

/// OpenVDB. Its world units are taken as millimetres, and a grid has no patient axes, unless we wrote it.
namespace velum::io {

namespace {

/// A few bytes of a sparse file can span any box, so the file's size cannot justify the dense voxels; this limit does.
constexpr double kMaxBytes = 2147483648.0;

using vdb::kDims, vdb::kOriented, vdb::kSpacing, vdb::kUnit;
using Dense = openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ>;

openvdb::FloatGrid::Ptr firstFloatGrid(const Path& path) {
  FileBytes check(path);  // for its messages
  constexpr unsigned char kMagic[] = {0x20, 0x42, 0x44, 0x56};
  std::string head = check.head(16);
  if (head.size() < 16 || !std::equal(std::begin(kMagic), std::end(kMagic), head.begin(),
                                      [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); }))
    refuse(path, "is not an OpenVDB file");
  // OpenVDB does not look whether its reads succeed, and allocates by sizes that it never got: the stream throws.
  std::ifstream bytes(path, std::ios::binary);
  bytes.exceptions(std::ios::eofbit | std::ios::failbit | std::ios::badbit);
  openvdb::io::Stream stream(bytes, false);
  auto grids = stream.getGrids();
  for (const auto& grid : *grids)
    if (auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) return floats;
  std::string types;
  for (const auto& grid : *grids) types += (types.empty() ? "" : ", ") + grid->valueType();
  refuse(path, fmt::format("has no grid of floats (it has: {})", types.empty() ? "nothing" : types));
}

glm::dmat4 matrixOf(const openvdb::FloatGrid& grid, const openvdb::Coord& origin, const Path& path) {
  auto affine = grid.transform().baseMap()->getAffineMap();
  if (!grid.transform().isLinear() || !affine) refuse(path, "the grid's transform is not linear; resample it first");
  // OpenVDB multiplies row vectors from the left, so that its rows are our columns.
  openvdb::math::Mat4d m = affine->getMat4();
  glm::dmat4 out;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) out[column][row] = m(column, row);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (!std::isfinite(out[i][j])) refuse(path, "the grid's transform is not finite");
  if (!(std::abs(glm::determinant(glm::dmat3(out))) > 0)) refuse(path, "the grid's transform is singular");
  out[3] = out * glm::dvec4(origin.x(), origin.y(), origin.z(), 1.0);
  return out;
}

/// The box that becomes the volume: what we noted when we wrote it, else the active voxels.
openvdb::CoordBBox boxOf(const openvdb::FloatGrid& grid, const Path& path) {
  openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (auto noted = grid.getMetadata<openvdb::Vec3IMetadata>(kDims)) {
    openvdb::Vec3i d = noted->value();
    openvdb::CoordBBox whole({0, 0, 0}, {d[0] - 1, d[1] - 1, d[2] - 1});
    bool isSane = d[0] > 0 && d[1] > 0 && d[2] > 0;
    if (isSane && (box.empty() || whole.isInside(box))) box = whole;
  }
  if (box.empty()) refuse(path, "the grid has no active voxels");
  return box;
}

}  // namespace

Volume readVdb(const scene::Source& source, Progress& progress) try {
  const Path path = source.path;
  progress.report(0, "reading OpenVDB");
  openvdb::initialize();
  auto grid = firstFloatGrid(path);
  progress.report(0.5, "reading OpenVDB");
  openvdb::CoordBBox box = boxOf(*grid, path);
  // In doubles: the corners may be as far apart as 32 bits allow.
  glm::dvec3 dims(double(box.max().x()) - box.min().x() + 1, double(box.max().y()) - box.min().y() + 1,
                  double(box.max().z()) - box.min().z() + 1);
  if (dims.x * dims.y * dims.z * sizeof(float) > kMaxBytes || glm::any(glm::greaterThan(dims, glm::dvec3(4096.0))))
    refuse(
        path,
        fmt::format(
            "the active voxels span {:.0f} x {:.0f} x {:.0f}; at most 4096 along an axis and 2 GiB of voxels are read",
            dims.x, dims.y, dims.z));
  Volume v;
  v.dims = glm::ivec3(dims);
  v.type = SampleType::Float32;
  v.voxels.resize(checkedBytes(path, dims, 1, 1, sampleSize(v.type), kMaxBytes));
  Dense dense(box, reinterpret_cast<float*>(v.voxels.data()));
  openvdb::tools::copyToDense(*grid, dense);
  v.worldFromVoxel = matrixOf(*grid, box.min(), path);
  auto flag = [&](const char* name, bool otherwise) {
    auto noted = grid->getMetadata<openvdb::BoolMetadata>(name);
    return noted ? noted->value() : otherwise;
  };
  if (auto unit = grid->getMetadata<openvdb::StringMetadata>(kUnit))
    v.lengthUnit = enumValue<LengthUnit>(unit->value()).value_or(LengthUnit::Millimetre);
  v.isOrientationKnown = flag(kOriented, false);
  v.isSpacingKnown = flag(kSpacing, true);
  if (!grid->getMetadata<openvdb::BoolMetadata>(kSpacing))
    v.warnings.push_back("an OpenVDB file has no unit; its world units are taken as mm");
  v.name = grid->getName();
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
