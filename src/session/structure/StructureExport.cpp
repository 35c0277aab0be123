#include "session/structure/StructureExport.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/Error.h"
#include "core/FileName.h"
#include "core/NearestName.h"
#include "io/labels/WriteLabels.h"
#include "io/meshes/ExtractSurface.h"
#include "io/meshes/WriteMesh.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"
#include "session/structure/StructureSizes.h"

namespace velum::session {

namespace {

using Path = std::filesystem::path;
using Lines = std::vector<std::string>;

const LabelInfo* findLabel(const std::vector<LabelInfo>& table, int id) {
  auto found = std::find_if(table.begin(), table.end(), [id](const LabelInfo& label) { return label.id == id; });
  return found == table.end() ? nullptr : &*found;
}

std::string nameOf(const std::vector<LabelInfo>& table, int id) {
  const LabelInfo* label = findLabel(table, id);
  return label && !label->name.empty() ? label->name : fmt::format("structure {}", id);
}

/// Ids in their order, each once. @throw ArgumentError for one without voxels
std::vector<int> chosenOf(const LabelVolume& labels, const std::map<int, StructureSize>& sizes,
                          const StructureExport& what) {
  std::set<int> chosen(what.structures.begin(), what.structures.end());
  if (chosen.empty())
    for (const auto& [id, size] : sizes) chosen.insert(id);
  for (int id : chosen)
    if (!sizes.contains(id)) throw ArgumentError(fmt::format("{} has no voxels to export", nameOf(labels.table, id)));
  if (chosen.empty()) throw ArgumentError("there are no structures to export: nothing is labelled");
  return {chosen.begin(), chosen.end()};
}

/// With nothing but these structures, in the same grid.
LabelVolume keepOnly(const LabelVolume& labels, const std::vector<int>& ids, Progress& progress) {
  LabelVolume kept(labels.dims(), labels.worldFromVoxel(), labels.lengthUnit());
  kept.name = labels.name;
  for (const LabelInfo& label : labels.table)
    if (std::binary_search(ids.begin(), ids.end(), int(label.id))) kept.table.push_back(label);
  std::vector<char> isKept(65536, 0);
  for (int id : ids) isKept[std::size_t(id)] = 1;
  constexpr int kBrick = LabelVolume::kBrickSize;
  std::vector<std::uint16_t> voxels;
  glm::ivec3 dims = labels.dims(), grid = labels.brickGrid(), at;
  for (at.z = 0; at.z < grid.z; ++at.z) {
    progress.report(0.2 * double(at.z) / grid.z, "Choosing structures");
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        const LabelVolume::Brick& brick = labels.brick(at);
        if (brick.size() == 1) {
          if (isKept[brick[0]]) kept.fillBrick(at, brick[0]);
          continue;
        }
        glm::ivec3 first = at * kBrick, size = glm::min(dims - first, glm::ivec3(kBrick));
        voxels.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
        labels.read(first, size, voxels);
        for (std::uint16_t& id : voxels)
          if (!isKept[id]) id = 0;
        kept.write(first, size, voxels);
      }
  }
  return kept;
}

/// What is written, with names and colours.
struct Structures {
  LabelVolume labels;
  std::shared_ptr<const StructureField> field;  ///< their borders
  std::map<int, StructureSize> sizes;
};

/// Told within a part of the whole. What is cancelled outside is cancelled in it.
Mesh surfaceOf(const Structures& of, int id, double smoothness, double from, double to, Progress& progress) {
  Progress* part = nullptr;
  std::string what = "Surface of " + nameOf(of.labels.table, id);
  const StructureSize& size = of.sizes.at(id);
  Progress inner([&](double fraction, const std::string&) {
    if (progress.isCancelled())
      part->cancel();
    else
      progress.report(from + (to - from) * fraction, what);
  });
  part = &inner;
  progress.report(from, what);
  Mesh mesh = io::extractSurface(*of.field, std::uint16_t(id), size.low, size.high, smoothness, inner);
  progress.throwIfCancelled();
  mesh.name = nameOf(of.labels.table, id);
  if (const LabelInfo* label = findLabel(of.labels.table, id)) mesh.color = label->color;
  return mesh;
}

/// Letters and digits of a name, joined by single hyphens: fit for every file system.
std::string fileWord(const std::string& name) {
  std::string word;
  for (char c : lowerCase(name)) {
    bool isPlain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (isPlain)
      word += c;
    else if (!word.empty() && word.back() != '-')
      word += '-';
  }
  while (!word.empty() && word.back() == '-') word.pop_back();
  return word;
}

/// NAME-aorta.stl; with its number where another of that name came before.
Path fileOf(const Path& path, const std::string& name, int id, std::set<std::string>& taken) {
  std::string file = path.filename().string();
  std::string extension = file.substr(file.size() - lowerExtension(path).size());
  if (lowerCase(file).ends_with(".seg.nrrd")) extension = file.substr(file.size() - 9);
  std::string word = fileWord(name);
  if (word.empty() || !taken.insert(word).second) word += (word.empty() ? "" : "-") + std::to_string(id);
  Path result(path);
  result.replace_filename(file.substr(0, file.size() - extension.size()) + "-" + word + extension);
  return result;
}

void addNew(Lines& to, const Lines& lines) {
  for (const std::string& line : lines)
    if (std::find(to.begin(), to.end(), line) == to.end()) to.push_back(line);
}

Lines writeSurfaces(const Structures& of, const std::vector<int>& ids, const Path& path, double smoothness,
                    Progress& progress) {
  std::vector<Mesh> meshes;
  double step = 0.9 / double(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
    meshes.push_back(surfaceOf(of, ids[i], smoothness, 0.05 + step * double(i), 0.05 + step * double(i + 1), progress));
  progress.report(0.95, "Writing " + path.filename().string());
  return io::writeMeshes(meshes, path, of.labels.lengthUnit());
}

Lines writeOnly(const Structures& of, const std::vector<int>& ids, const Path& path, double smoothness,
                Progress& progress) {
  if (isSurfaceFile(path)) return writeSurfaces(of, ids, path, smoothness, progress);
  if (ids.size() == of.sizes.size()) return io::writeLabels(of.labels, path, progress);
  return io::writeLabels(keepOnly(of.labels, ids, progress), path, progress);
}

}  // namespace

bool isSurfaceFile(const std::filesystem::path& path) {
  auto formats = io::meshFormats();
  std::string extension = lowerExtension(path);
  return std::any_of(formats.begin(), formats.end(), [&](const auto& f) { return f.extension == extension; });
}

std::vector<std::string> exportStructures(const scene::Scene& scene, const std::filesystem::path& path,
                                          const StructureExport& what, Progress& progress) {
  Structures of{labelsOf(scene), scene::structureFieldOf(scene), {}};
  of.sizes = countStructures(of.labels, progress);
  auto ids = chosenOf(of.labels, of.sizes, what);
  LengthUnit unit = of.labels.lengthUnit();
  Lines losses;
  if (isSurfaceFile(path) && unit != LengthUnit::Millimetre && lowerExtension(path) != ".glb")
    losses.push_back(fmt::format("lengths are in {}, which no file of surfaces says", enumName(unit)));
  if (!what.apart) {
    addNew(losses, writeOnly(of, ids, path, what.smoothness, progress));
    return losses;
  }
  std::set<std::string> taken;
  for (int id : ids) {
    Path file = fileOf(path, nameOf(of.labels.table, id), id, taken);
    addNew(losses, writeOnly(of, {id}, file, what.smoothness, progress));
  }
  return losses;
}

LabelVolume labelsOf(const scene::Scene& scene) {
  if (!scene.labels.data) throw ArgumentError("there are no structures: open labels first, or grow some");
  LabelVolume labels = *scene.labels.data;
  if (scene.labels.structures.empty()) return labels;
  std::vector<LabelInfo> table;
  for (const scene::Structure& structure : scene.labels.structures)
    table.push_back({std::uint16_t(structure.id), structure.name, structure.color, float(structure.opacity),
                     scene::fileIdOf(structure)});
  labels.table = std::move(table);
  return labels;
}

std::vector<int> findStructures(const std::vector<LabelInfo>& table, const std::vector<std::string>& words) {
  std::vector<int> ids;
  for (const std::string& word : words) {
    auto found = std::find_if(table.begin(), table.end(), [&](const LabelInfo& label) {
      return std::to_string(label.id) == word || lowerCase(label.name) == lowerCase(word);
    });
    if (found == table.end()) {
      std::vector<std::string> names;
      for (const LabelInfo& label : table) names.push_back(label.name);
      std::string meant = nearestName(word, names);
      throw ArgumentError(fmt::format("there is no structure '{}'{}; name one, or give its number (see info)", word,
                                      meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant)));
    }
    ids.push_back(found->id);
  }
  return ids;
}

}  // namespace velum::session
