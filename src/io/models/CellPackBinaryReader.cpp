#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/FileName.h"
#include "core/Parallel.h"
#include "core/SayCount.h"
#include "io/models/Completion.h"
#include "io/models/ModelReaders.h"
#include "io/models/Recipe.h"
#include "io/models/StructureFiles.h"
#include "io/read/FileNames.h"
#include "io/read/JsonParts.h"

/// Packings of cellPACKgpu and cellVIEW: places and rotations as bare 32-bit numbers, and beside them a recipe in JSON
/// that names the types. They are left-handed: x is mirrored here, and so are the rotations.
namespace velum::io {

namespace {

/// What a file of so many bytes holds, and where.
struct Layout {
  std::size_t header = 0, instances = 0, points = 0;
};

/// Files without a header, with one of two numbers (instances, points of curves), or of three (and curves).
std::optional<Layout> layoutOf(std::string_view bytes) {
  std::int32_t counts[3] = {0, 0, 0};
  std::memcpy(counts, bytes.data(), std::min(bytes.size(), sizeof(counts)));
  auto n = std::size_t(std::max(counts[0], 0)), points = std::size_t(std::max(counts[1], 0)),
       curves = std::size_t(std::max(counts[2], 0));
  if (n > 0 && counts[1] >= 0 && bytes.size() == 8 + 32 * n + 48 * points) return Layout{8, n, points};
  if (n > 0 && counts[1] >= 0 && counts[2] >= 0 && bytes.size() == 12 + 32 * n + 48 * points + 16 * curves)
    return Layout{12, n, points};
  if (bytes.size() >= 32 && bytes.size() % 32 == 0) return Layout{0, bytes.size() / 32, 0};
  return std::nullopt;
}

class BinaryReader {
 public:
  BinaryReader(const Path& path, Progress& progress)
      : mPath(path), mProgress(progress), mBytes(textOf(path)), mBuilder(titleOf(path)) {}

  Model read(const ModelReading& reading) {
    auto layout = layoutOf(mBytes);
    if (!layout) refuse(mPath, fmt::format("is no packing of cellPACKgpu: {} bytes are none that fit", mBytes.size()));
    auto recipe = recipeBeside(mPath);
    if (!recipe) refuse(mPath, "its recipe, a JSON file that names its types, does not lie beside it");
    for (std::size_t i = 0; i < recipe->size(); ++i) mTypes.try_emplace((*recipe)[i].id, i);
    readPlaces(*layout, *recipe);
    addTypes(*recipe);
    if (layout->points > 0) mBuilder.warn("its curves are left out");
    if (reading.completes) completeVirus(mBuilder, mPath);
    return mBuilder.build();
  }

 private:
  glm::vec4 four(std::size_t at) const {
    float v[4];
    std::memcpy(v, mBytes.data() + at, sizeof(v));
    return {v[0], v[1], v[2], v[3]};
  }

  void readPlaces(const Layout& layout, const std::vector<RecipeIngredient>& recipe) {
    static_assert(std::endian::native == std::endian::little);
    mPoses.resize(recipe.size());
    for (std::size_t i = 0; i < layout.instances; ++i) {
      glm::vec4 p = four(layout.header + 16 * i), q = four(layout.header + 16 * (layout.instances + i));
      if (!(glm::length(p) < 1e9f)) refuse(mPath, fmt::format("instance {} stands nowhere", i));
      auto type = p.w == std::floor(p.w) ? mTypes.find(std::int64_t(p.w)) : mTypes.end();
      if (type == mTypes.end()) refuse(mPath, fmt::format("instance {} is of type {}, which its recipe lacks", i, p.w));
      mPoses[type->second].push_back({glm::quat(q.w, q.x, -q.y, -q.z), glm::vec3(-p.x, p.y, p.z)});
    }
  }

  void addTypes(const std::vector<RecipeIngredient>& recipe) {
    StructureFiles files(mPath);
    std::vector<StructureParts> parts(recipe.size());
    parallelFor(std::size_t(0), recipe.size(), [&](std::size_t i) {
      mProgress.throwIfCancelled();
      auto file = mPoses[i].empty() ? std::nullopt : files.find(recipe[i].structure);
      // Some are named after a version by hand that nobody has.
      if (!file && !mPoses[i].empty()) file = files.find(withoutEnd(recipe[i].structure, "_manu.pdb"));
      // "ext__dLDL": what stands before the name is the compartment's.
      std::size_t bare = recipe[i].type.rfind("__");
      if (!file && !mPoses[i].empty())
        file = files.find(recipe[i].type.substr(bare == std::string::npos ? 0 : bare + 2));
      if (file) parts[i] = readStructure(*file, recipe[i].hasCopies);
    });
    std::size_t missing = 0;
    for (std::size_t i = 0; i < recipe.size(); ++i) {
      if (mPoses[i].empty()) continue;
      MoleculeType type{.name = recipe[i].type, .compartment = mBuilder.compartment(recipe[i].path)};
      type.structure = recipe[i].structure;
      type.description = recipe[i].description;
      if (recipe[i].mass > 0.0) type.mass = recipe[i].mass, type.massSource = MassSource::File;
      if (parts[i].isNucleic) type.kind = MoleculeKind::NucleicAcid;
      move(parts[i].atoms, -meanOf(parts[i].atoms));
      std::vector<std::vector<glm::vec4>> beads;
      if (!parts[i].beads.empty()) beads.push_back(std::move(parts[i].beads));
      if (parts[i].atoms.empty() && beads.empty()) {
        beads.push_back({glm::vec4(0, 0, 0, recipe[i].radius)});
        ++missing;
      }
      std::uint32_t molecule =
          mBuilder.addMolecule(mBuilder.addType(std::move(type)), std::move(parts[i].atoms), beads);
      for (const Pose& pose : mPoses[i]) place(mBuilder, mPath, molecule, pose);
    }
    if (missing > 0)
      mBuilder.sayAdded(sayCount(missing, "balls stand for 1 type whose structure is not to be found",
                                 "balls stand for {} types whose structures are not to be found"));
  }

  static std::string withoutEnd(const std::string& name, std::string_view end) {
    return name.ends_with(end) ? name.substr(0, name.size() - end.size()) : std::string();
  }

  const Path& mPath;
  Progress& mProgress;
  std::string mBytes;
  ModelBuilder mBuilder;
  std::map<std::int64_t, std::size_t> mTypes;
  std::vector<std::vector<Pose>> mPoses;  ///< By type.
};

}  // namespace

Model readCellPackBinary(const Path& path, Progress& progress, const ModelReading& reading) {
  return BinaryReader(path, progress).read(reading);
}

}  // namespace velum::io
