#include "session/document/Open.h"
#include "session/document/Body.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>
#include <variant>

#include "core/FileName.h"
#include "core/Log.h"
#include "core/ReplaceFile.h"
#include "io/images/ImageFile.h"
#include "io/kinds/FileKind.h"
#include "io/labels/ReadLabels.h"
#include "io/meshes/ReadMesh.h"
#include "io/models/ReadModel.h"
#include "io/volumes/ReadVolume.h"
#include "scene/FirstLook.h"
#include "scene/ModelLooks.h"
#include "scene/Presets.h"
#include "scene/TypesFromLabels.h"
#include "scene/VisibleFrame.h"
#include "scene/json/Json.h"
#include "scene/timeline/Tracks.h"
#include "session/document/Folders.h"
#include "session/document/LabelPlace.h"
#include "session/document/PaperFile.h"
#include "session/document/PutData.h"
#include "session/document/StructureShapes.h"
#include "session/growth/Growths.h"
#include "session/model/LegendLacks.h"
#include "session/model/LevelCache.h"
#include "vector/Description.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestSceneFile = 64u << 20;

std::string readText(const fs::path& path) {
  std::error_code error;
  auto size = fs::file_size(path, error);
  if (error) throw InputError(fmt::format("{}: {}", path.string(), error.message()));
  if (size > kLargestSceneFile)
    throw InputError(fmt::format("{}: {} MiB is too much for a scene file", path.string(), size >> 20));
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The notes of one opening.
struct Notes {
  std::vector<std::string>* list;
  void add(const std::string& note) const { list ? list->push_back(note) : log::warning(note); }
};

/// Makes a saved source one that can be read: its path whole, found again where it has moved.
/// @return false when it is not to be found and the policy goes on without it
bool placeSource(scene::Source& source, const MissingData& missing, const fs::path& folder, Progress& progress,
                 const DataPolicy& policy, const Notes& notes) {
  fs::path path(source.path);
  if (path.is_relative() && !folder.empty()) source.path = (folder / path).lexically_normal().string();
  std::error_code error;
  if (!fs::exists(source.path, error)) {
    auto found = findMoved(source, folder, policy.folders, progress);
    if (!found && policy.keepsWithoutData) return false;
    if (!found) throw InputError(sayMissing({missing.field, missing.what, source.path}));
    notes.add(fmt::format("{} has moved; it was found as {}", path.filename().string(), found->string()));
    source.path = fs::absolute(*found).lexically_normal().string();
  } else if (!source.fingerprint.empty() && fingerprintOf(source.path) != source.fingerprint) {
    notes.add(fmt::format("{} has changed since the scene was saved", path.filename().string()));
  }
  return true;
}

void readSurfaceInto(scene::Surface& surface, Progress& progress) {
  Mesh mesh = io::readMesh(surface.source.path, progress);
  warnAll(surface.source.path, mesh.warnings);
  surface.data = Shared<Mesh>(std::move(mesh));
  surface.source.fingerprint = fingerprintOf(surface.source.path);
}

void readModelInto(scene::ModelLayer& layer, Progress& progress, const DataPolicy& policy, const Notes& notes) {
  Model model = io::readModel(layer.source.path, progress, {.completes = layer.completes});
  warnAll(layer.source.path, model.warnings);
  for (const auto& line : model.added) notes.add(line);
  layer.levels = Shared<LevelSet>(policy.quickLevels ? keptOrQuickLevels(model, levelFolder(), progress)
                                                     : cachedLevels(model, levelFolder(), progress));
  layer.data = Shared<Model>(std::move(model));
  layer.source.fingerprint = fingerprintOf(layer.source.path);
}

scene::Scene fromText(const std::string& text, const fs::path& file, Progress& progress, const DataPolicy& policy,
                      std::vector<std::string>* notes) {
  scene::Scene scene;
  try {
    scene = scene::fromJson(text);
    if (policy.beforeData) policy.beforeData(scene);
    loadData(scene, file.parent_path(), progress, policy, notes);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  scene::placeSections(scene);
  return scene;
}

fs::path relativeTo(const std::string& path, const fs::path& folder) {
  if (path.empty()) return {};
  fs::path whole = fs::absolute(path).lexically_normal(), base = fs::absolute(folder).lexically_normal();
  // With nothing but the root in common the two do not travel together.
  bool isNear = whole.has_parent_path() && *std::next(whole.begin()) == *std::next(base.begin());
  std::error_code error;
  fs::path relative = isNear ? fs::relative(whole, base, error) : whole;
  return error || relative.empty() ? whole : relative;
}

scene::Scene withRelativePaths(scene::Scene scene, const fs::path& folder) {
  for (scene::Source* source :
       {&scene.volume.source, &scene.labels.source, &scene.model.source, &scene.finish.ownPaper.source})
    source->path = relativeTo(source->path, folder).string();
  for (auto& surface : scene.surfaces) surface.source.path = relativeTo(surface.source.path, folder).string();
  for (auto& sphere : scene.finish.spheres) sphere.source.path = relativeTo(sphere.source.path, folder).string();
  return scene;
}

}  // namespace

std::optional<std::string> readSceneText(const fs::path& path) {
  if (io::FileKind kind = io::kindOf(path); kind != io::FileKind::Picture)
    return kind == io::FileKind::Scene ? std::optional(readText(path)) : std::nullopt;
  std::string text = io::isDrawing(path) ? vector::readDescription(path) : io::readImageDescription(path);
  if (text.empty()) throw InputError(fmt::format("{}: the picture holds no scene of ours", path.string()));
  return text;
}

scene::Scene open(const scene::Source& source, Progress& progress, const DataPolicy& policy,
                  std::vector<std::string>* notes) {
  fs::path path(source.path);
  if (!fs::exists(path)) throw InputError(fmt::format("{}: there is no such file or folder", source.path));
  if (auto text = readSceneText(path)) return fromText(*text, path, progress, policy, notes);
  scene::Scene scene;
  if (policy.beforeData) policy.beforeData(scene);
  add(scene, source, progress, notes, policy);
  seeAll(scene);
  return scene;
}

void addLabels(scene::Scene& scene, const scene::Source& source, Progress& progress) {
  takeLabels(scene, source, io::readLabels(source, progress, gridOfScan(scene)), progress);
}

void add(scene::Scene& scene, const scene::Source& source, Progress& progress, std::vector<std::string>* notes,
         const DataPolicy& policy) {
  if (!fs::exists(source.path)) throw InputError(fmt::format("{}: there is no such file or folder", source.path));
  io::FileKind kind = io::kindOf(source);
  if (kind == io::FileKind::Look)
    throw InputError(
        fmt::format("{}: a look, which is put on what is open: Look > Import look, or --transfer", source.path));
  if (kind == io::FileKind::Surface) {
    scene::Surface surface;
    surface.source = source;
    readSurfaceInto(surface, progress);
    if (surface.data->color) surface.color = *surface.data->color;
    scene.surfaces.push_back(std::move(surface));
    return;
  }
  if (kind == io::FileKind::Model) {
    if (scene.model.data)
      throw InputError(fmt::format("{}: the scene has a model already; open it by itself", source.path));
    adoptUnit(scene, LengthUnit::Angstrom);
    bool isAlone = !scene::hasData(scene);
    scene.model.source = source;
    readModelInto(scene.model, progress, policy, Notes{notes});
    if (isAlone) scene::applyFirstModelLook(scene);
    return;
  }
  if (scene.volume.data) return addLabels(scene, source, progress);
  auto voxels = io::readVoxels(source, progress);
  if (auto* labels = std::get_if<LabelVolume>(&voxels)) return takeLabels(scene, source, std::move(*labels), progress);
  takeVolume(scene, source, std::move(std::get<Volume>(voxels)), progress);
}

void loadData(scene::Scene& scene, const fs::path& folder, Progress& progress, const DataPolicy& policy,
              std::vector<std::string>* notes) {
  auto isPlaced = [&](scene::Source& source, bool hasData, std::string part, std::string what) {
    MissingData missing{part + ".source.path", std::move(what), source.path};
    return !source.path.empty() && !hasData && placeSource(source, missing, folder, progress, policy, Notes{notes});
  };
  if (isPlaced(scene.volume.source, bool(scene.volume.data), "volume", "volume")) {
    putVolume(scene, io::readVolume(scene.volume.source, progress));
    placeLabels(scene, progress);
    if (scene.volume.transfer.opacities.empty()) {
      scene::applyFirstLook(scene);
      scene::completeChannels(scene.volume);
    }
  }
  settleBody(scene, progress);
  if (isPlaced(scene.labels.source, bool(scene.labels.data), "labels", "labels"))
    putLabels(scene, readLabelsOf(scene, progress), progress);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    auto& surface = scene.surfaces[i];
    if (isPlaced(surface.source, bool(surface.data), fmt::format("surfaces.{}", i), "surface"))
      readSurfaceInto(surface, progress);
  }
  if (isPlaced(scene.model.source, bool(scene.model.data), "model", "model"))
    readModelInto(scene.model, progress, policy, Notes{notes});
  scene::typesFromLabels(scene);
  try {
    for (const auto& note : settleGrowths(scene, progress)) Notes{notes}.add(note);
  } catch (const ArgumentError& error) {
    throw InputError(fmt::format("labels.growths: {}", error.what()));  // of a file, or of another volume
  }
  for (const std::string& note : loadOwnPictures(scene, folder)) Notes{notes}.add(note);
  if (std::string note = whatLegendLacks(scene); !note.empty()) Notes{notes}.add(note);
  for (const std::string& note : scene::joinTracks(scene)) Notes{notes}.add(note);
}

std::string sceneTextFor(const scene::Scene& scene, const fs::path& path) {
  return scene::toJson(withRelativePaths(scene, fs::absolute(path).parent_path()));
}

void saveScene(const scene::Scene& scene, const fs::path& path) {
  std::string text = sceneTextFor(scene, path);
  if (text.size() > kLargestSceneFile)
    throw InputError(
        fmt::format("{}: {} MiB is too much for a scene file; it was not written", path.string(), text.size() >> 20));
  replaceFile(path, text);
}

}  // namespace velum::session
