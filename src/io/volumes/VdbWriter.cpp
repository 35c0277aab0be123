#include <fmt/format.h>
#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "io/Plugins.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"
#include "io/read/SinkStream.h"
#include "io/volumes/Readers.h"
#include "io/volumes/VdbNotes.h"

namespace velum::io {

namespace {

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

/// The value of a raw sample.
template <class Sample>
double valueOf(const Volume& volume, Sample raw) {
  return double(raw) * volume.scale + volume.offset;
}

bool fitsFloats(const Volume& volume) {
  return visitSamples(volume, [&](const auto* p) {
    return std::all_of(p, p + voxelCount(volume), [&](auto raw) {
      double value = valueOf(volume, raw);
      return double(float(value)) == value || std::isnan(value);
    });
  });
}

/// Voxels of a value that is no number. The library takes a block for uniform when its numbers are, and loses them.
std::vector<openvdb::Coord> placesOfNan(const Volume& volume) {
  std::vector<openvdb::Coord> places;
  if (volume.type != SampleType::Float32 && volume.type != SampleType::Float64) return places;
  visitSamples(volume, [&](const auto* p) {
    for (int z = 0; z < volume.dims.z; ++z)
      for (int y = 0; y < volume.dims.y; ++y)
        for (int x = 0; x < volume.dims.x; ++x, ++p)
          if (std::isnan(double(*p))) places.emplace_back(x, y, z);
  });
  return places;
}

/// @tparam Grid  of floats or of doubles
template <class Grid>
openvdb::GridBase::Ptr gridOf(const Volume& volume, Progress& progress) {
  using Value = typename Grid::ValueType;
  using Dense = openvdb::tools::Dense<Value, openvdb::tools::LayoutXYZ>;
  auto grid = Grid::create(Value(volume.range.x));
  std::size_t row = std::size_t(volume.dims.x), plane = row * std::size_t(volume.dims.y);
  // Slab by slab, as high as a leaf, so that no dense copy of the whole is needed.
  constexpr int kSlab = 8;
  std::vector<Value> slab(plane * kSlab);
  for (int z = 0; z < volume.dims.z; z += kSlab) {
    progress.report(0.8 * z / volume.dims.z, "writing OpenVDB");
    int depth = std::min(kSlab, volume.dims.z - z);
    visitSamples(volume, [&](auto* p) {
      const auto* from = p + std::size_t(z) * plane;
      for (std::size_t i = 0; i < plane * std::size_t(depth); ++i) slab[i] = Value(valueOf(volume, from[i]));
    });
    openvdb::CoordBBox box({0, 0, z}, {volume.dims.x - 1, volume.dims.y - 1, z + depth - 1});
    openvdb::tools::copyFromDense(Dense(box, slab.data()), *grid, Value(0));
  }
  auto noNumbers = placesOfNan(volume);
  auto accessor = grid->getAccessor();
  for (const openvdb::Coord& place : noNumbers) accessor.setValue(place, std::numeric_limits<Value>::quiet_NaN());
  if (noNumbers.empty()) openvdb::tools::prune(grid->tree());
  return grid;
}

void describe(openvdb::GridBase& grid, const Volume& volume, LengthUnit unit) {
  openvdb::math::Mat4d m;
  glm::dmat4 world = worldFromVoxelIn(unit, volume);
  for (int column = 0; column < 4; ++column)
    for (int r = 0; r < 4; ++r) m(column, r) = world[column][r];
  grid.setTransform(openvdb::math::Transform::createLinearTransform(m));
  grid.setName(volume.name.empty() ? "density" : volume.name);
  grid.setGridClass(openvdb::GRID_FOG_VOLUME);
  grid.insertMeta(vdb::kDims, openvdb::Vec3IMetadata(openvdb::Vec3i(volume.dims.x, volume.dims.y, volume.dims.z)));
  grid.insertMeta(vdb::kOriented, openvdb::BoolMetadata(volume.isOrientationKnown));
  grid.insertMeta(vdb::kSpacing, openvdb::BoolMetadata(volume.isSpacingKnown));
  grid.insertMeta(vdb::kUnit, openvdb::StringMetadata(std::string(enumName(unit))));
  if (!volume.unit.empty()) grid.insertMeta(vdb::kValueUnit, openvdb::StringMetadata(volume.unit));
  if (volume.modality != Modality::Unknown)
    grid.insertMeta(vdb::kModality, openvdb::StringMetadata(std::string(enumName(volume.modality))));
}

}  // namespace

std::vector<std::string> plugin::writeVdb(const Volume& volume, ReplaceFile& file, Progress& progress) try {
  if (volume.channels != 1 || volume.timeSteps != 1)
    refuse(file.target(), fmt::format("a .vdb of ours holds one channel and one time step, not {} and {}",
                                      volume.channels, volume.timeSteps));
  progress.report(0, "writing OpenVDB");
  openvdb::initialize();
  auto grid =
      fitsFloats(volume) ? gridOf<openvdb::FloatGrid>(volume, progress) : gridOf<openvdb::DoubleGrid>(volume, progress);
  LengthUnit unit = unitToWrite(volume);
  describe(*grid, volume, unit);
  {
    SinkStream out(file);
    VdbArchive().write(out, openvdb::GridPtrVec{grid}, kSeekable);
  }
  progress.report(1, "writing OpenVDB");
  Losses losses;
  losses.say(unit != volume.lengthUnit,
             "lengths are written in angstrom: OpenVDB takes so small voxels in mm for none");
  losses.say(!volume.channelNames.empty(), "the name of the channel is left out: OpenVDB has no place for it");
  return losses.take();
} catch (const openvdb::Exception& e) {
  file.throwIfRefused();
  refuse(file.target(), fmt::format("cannot be written ({})", e.what()));
}

}  // namespace velum::io
