#include <fmt/format.h>
#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>

#include "Readers.h"
#include "VdbNotes.h"
#include "read/Refuse.h"
#include "read/SinkStream.h"

namespace velum::io {

namespace {

using vdb::kDims, vdb::kOriented, vdb::kSpacing, vdb::kUnit;
using Dense = openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ>;

/// Voxels shorter than this many millimetres are written in angstrom: OpenVDB takes a matrix whose determinant is near
/// 1e-15 for a singular one.
constexpr double kShortestMm = 1e-4;

/// What openvdb::io::File is, onto a stream of ours: the library's own file hides that the disk is full.
struct VdbArchive : openvdb::io::Archive {
  using Archive::write;
};
constexpr bool kSeekable = true;  ///< With offsets of grids, so that others need not read all of it.

LengthUnit unitToWrite(const Volume& volume) {
  glm::dvec3 mm = spacingOf(volume) * unitsPer(volume.lengthUnit, LengthUnit::Millimetre);
  return glm::min(mm.x, glm::min(mm.y, mm.z)) < kShortestMm ? LengthUnit::Angstrom : volume.lengthUnit;
}

}  // namespace

void writeVdb(const Volume& volume, ReplaceFile& file, Progress& progress) try {
  if (volume.channels != 1 || volume.timeSteps != 1)
    refuse(file.target(), fmt::format("a .vdb of ours holds one channel and one time step, not {} and {}",
                                      volume.channels, volume.timeSteps));
  progress.report(0, "writing OpenVDB");
  openvdb::initialize();
  auto background = float(volume.range.x);
  auto grid = openvdb::FloatGrid::create(background);
  std::size_t row = std::size_t(volume.dims.x), plane = row * std::size_t(volume.dims.y);
  // Slab by slab, as high as a leaf, so that no dense float copy of the whole is needed.
  constexpr int kSlab = 8;
  std::vector<float> slab(plane * kSlab);
  for (int z = 0; z < volume.dims.z; z += kSlab) {
    progress.report(0.8 * z / volume.dims.z, "writing OpenVDB");
    int depth = std::min(kSlab, volume.dims.z - z);
    visitSamples(volume, [&](auto* p) {
      const auto* from = p + std::size_t(z) * plane;
      for (std::size_t i = 0; i < plane * std::size_t(depth); ++i)
        slab[i] = float(double(from[i]) * volume.scale + volume.offset);
    });
    openvdb::CoordBBox box({0, 0, z}, {volume.dims.x - 1, volume.dims.y - 1, z + depth - 1});
    openvdb::tools::copyFromDense(Dense(box, slab.data()), *grid, 0.0f);
  }
  openvdb::tools::prune(grid->tree());
  openvdb::math::Mat4d m;
  LengthUnit unit = unitToWrite(volume);
  glm::dmat4 world = worldFromVoxelIn(unit, volume);
  for (int column = 0; column < 4; ++column)
    for (int r = 0; r < 4; ++r) m(column, r) = world[column][r];
  grid->setTransform(openvdb::math::Transform::createLinearTransform(m));
  grid->setName(volume.name.empty() ? "density" : volume.name);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->insertMeta(kDims, openvdb::Vec3IMetadata(openvdb::Vec3i(volume.dims.x, volume.dims.y, volume.dims.z)));
  grid->insertMeta(kOriented, openvdb::BoolMetadata(volume.isOrientationKnown));
  grid->insertMeta(kSpacing, openvdb::BoolMetadata(volume.isSpacingKnown));
  grid->insertMeta(kUnit, openvdb::StringMetadata(std::string(enumName(unit))));
  {
    SinkStream out(file);
    VdbArchive().write(out, openvdb::GridPtrVec{grid}, kSeekable);
  }
  progress.report(1, "writing OpenVDB");
} catch (const openvdb::Exception& e) {
  file.throwIfRefused();
  refuse(file.target(), fmt::format("cannot be written ({})", e.what()));
}

}  // namespace velum::io
