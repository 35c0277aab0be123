// Several inputs as one scene, or beside one.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>

#include "core/Error.h"
#include "core/Log.h"
#include "io/kinds/FileKind.h"
#include "io/volumes/ReadLevel.h"
#include "io/volumes/StoreSeries.h"
#include "scene/VisibleFrame.h"
#include "session/document/Open.h"
#include "session/model/ModelScale.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

/// Opens each source. One that cannot be read does not keep the others from being opened, unless `refusesOne`.
/// @return why sources were refused, one line each. @throw InputError when all were: the reason of the first
std::vector<std::string> openEach(const std::vector<scene::Source>& sources, bool refusesOne,
                                  const std::function<void(const scene::Source&)>& open) {
  std::vector<std::string> refused;
  std::exception_ptr first;
  for (const auto& source : sources) {
    try {
      open(source);
    } catch (const InputError& error) {
      if (refusesOne) throw;
      if (!first) first = std::current_exception();
      refused.push_back(error.what());
    }
  }
  if (refused.size() == sources.size() && first) std::rethrow_exception(first);
  return refused;
}

/// A source that names no level of detail at the level that the policy wants.
scene::Source atLevel(scene::Source source, const DataPolicy& policy) {
  if (policy.level >= 0 && source.level < 0 && fs::exists(source.path))
    source.level = io::levelNear(source, policy.level);
  return source;
}

/// @param notes  null: they are warnings on stderr
void tell(const std::vector<std::string>& lines, std::vector<std::string>* notes) {
  for (const auto& line : lines) notes ? notes->push_back(line) : log::warning(line);
}

/// Nobody finds a virion beside a head.
void tellScale(const scene::Scene& scene, std::vector<std::string>* notes) {
  if (std::string words = scaleWords(scene); !words.empty())
    tell({words + "; \"Bring to size\" on the page Model enlarges it, or the command model.bringToSize"}, notes);
}

}  // namespace

scene::Source foundInStore(scene::Source source) {
  std::error_code error;
  if (source.path.empty() || !source.series.empty() || fs::exists(source.path, error)) return source;
  auto place = io::placeInStore(source.path);
  if (!place) return source;
  source.path = place->store.string();
  source.series = place->key;
  return source;
}

std::vector<scene::Source> sourcesOf(const std::vector<std::string>& paths) {
  std::vector<scene::Source> sources;
  for (const auto& path : paths) {
    sources.emplace_back();
    sources.back().path = path;
  }
  return sources;
}

Opened openAll(std::vector<scene::Source> sources, Progress& progress, const DataPolicy& policy,
               std::vector<std::string>* notes) {
  if (sources.empty()) throw ArgumentError("nothing was named to open");
  for (auto& source : sources) source = foundInStore(std::move(source));
  std::stable_partition(sources.begin(), sources.end(), [](const scene::Source& source) {
    io::FileKind kind = fs::exists(source.path) ? io::kindOf(source) : io::FileKind::Volume;
    return kind != io::FileKind::Surface && kind != io::FileKind::Labels;
  });
  Opened opened;
  std::vector<std::string> refused = openEach(sources, policy.refusesOne, [&](const scene::Source& named) {
    scene::Source source = atLevel(named, policy);
    if (!opened.path.empty()) return add(opened.scene, source, progress, notes, policy);
    opened.scene = open(source, progress, policy, notes);
    opened.path = source.path;
  });
  tell(refused, notes);
  const scene::Scene& scene = opened.scene;
  if (sources.size() > 1) tellScale(scene, notes);
  bool hasCamera = io::holdsScene(io::kindOf(fs::path(opened.path)));
  if (sources.size() > 1 && !hasCamera && (!scene.surfaces.empty() || scene.model.data))
    opened.scene.camera = scene::firstCamera(scene, 4.0 / 3.0);
  return opened;
}

void addAll(scene::Scene& scene, const std::vector<std::string>& paths, Progress& progress,
            std::vector<std::string>* notes, const DataPolicy& policy) {
  auto refused = openEach(sourcesOf(paths), false, [&](const scene::Source& source) {
    add(scene, atLevel(foundInStore(source), policy), progress, notes, policy);
  });
  tell(refused, notes);
  tellScale(scene, notes);
}

}  // namespace velum::session
