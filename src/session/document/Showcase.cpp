#include "session/document/Showcase.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

#include "core/Error.h"
#include "io/labels/WriteLabels.h"
#include "io/models/WriteModel.h"
#include "io/phantoms/Sample.h"
#include "io/phantoms/Virion.h"
#include "io/volumes/WriteVolume.h"
#include "scene/Presets.h"
#include "scene/VisibleFrame.h"
#include "scene/json/Paths.h"
#include "session/document/Open.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

using Fields = std::span<const std::pair<const char*, const char*>>;

/// A scene as one would say it on the command line.
struct Row {
  Showcase showcase;
  const char* phantom;
  int voxels;
  const char* preset;
  scene::StandardView view;
  Fields fields;
};

constexpr std::pair<const char*, const char*> kHead[] = {
    {"labels.tint", "0"},
    {"volume.transfer.colors",
     R"([{"value": -600, "color": [0.93, 0.76, 0.65]}, {"value": -100, "color": [0.91, 0.7, 0.58]},
         {"value": 0, "color": [0.95, 0.9, 0.79]}, {"value": 1000, "color": [0.98, 0.95, 0.88]}])"},
    {"cuts.+.shape", "membrane"},
    {"cuts.0.axis", "-1,0,0"},
    {"cuts.0.centre", "-10,0,0"},
    {"cuts.0.size", "230,230,190"},
    {"cuts.0.membrane.field.byValue",
     R"([{"value": 300, "strength": 0}, {"value": 340, "strength": 300}, {"value": 3100, "strength": 300}])"}};
constexpr std::pair<const char*, const char*> kTrunk[] = {
    {"camera.fieldOfViewDeg", "22"},
    {"camera.eye", "210,-760,640"},
    {"camera.target", "0,-5,-62"},
    {"labels.tint", "0.85"},
    {"cuts.+.shape", "plane"},
    {"cuts.0.centre", "0,0,-45"},
    {"cuts.0.axis", "0,0,1"},
    {"cuts.0.spares",
     R"([{"structure": 10, "distance": 120}, {"structure": 16, "distance": 120}, {"structure": 27, "distance": 95},
         {"structure": 28, "distance": 95}, {"structure": 29, "distance": 70}, {"structure": 5, "distance": 55},
         {"structure": 6, "distance": 55}, {"structure": 7, "distance": 45}, {"structure": 33, "distance": 70},
         {"structure": 34, "distance": 70}, {"structure": 35, "distance": 70}])"}};
constexpr std::pair<const char*, const char*> kVirus[] = {
    {"camera.fieldOfViewDeg", "26"},
    {"cuts.+.shape", "sphere"},
    {"cuts.0.centre", "0,-900,0"},
    {"cuts.0.size", "1700,1700,1700"},
    {"cuts.0.model.spares", R"([{"type": "root", "share": 0.0, "falloff": 300}])"}};

constexpr Row kRows[] = {
    {{"head", "A head", "a membrane goes round the skull"},
     "skull",
     128,
     "ct-skin",
     scene::StandardView::Oblique,
     kHead},
    {{"trunk", "A trunk", "organs pulled out of a cut"},
     "torso",
     128,
     "ct-muscle",
     scene::StandardView::Oblique,
     kTrunk},
    {{"virus", "A virus", "a cell model, cut open"}, "virion", 0, "", scene::StandardView::Anterior, kVirus}};

constexpr auto kShowcases = [] {
  std::array<Showcase, std::size(kRows)> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = kRows[i].showcase;
  return all;
}();

/// The phantom, which is made if it is not there.
scene::Scene openPhantom(const Row& row, const fs::path& folder, Progress& progress, std::vector<std::string>* notes) {
  std::string name = row.phantom;
  fs::create_directories(folder);
  fs::path model = folder / (name + ".cif.gz"), volume = folder / (name + ".nrrd"),
           labels = folder / (name + "_labels.seg.nrrd");
  scene::Source source;
  if (row.voxels == 0) {
    if (!fs::exists(model)) io::writeModel(io::makeVirion(progress), model, progress);
    source.path = model.string();
    return open(source, progress, {}, notes);
  }
  if (!fs::exists(volume) || !fs::exists(labels)) return openSample(name, row.voxels, folder, progress);
  source.path = volume.string();
  scene::Scene scene = open(source, progress, {}, notes);
  source.path = labels.string();
  add(scene, source, progress, notes);
  return scene;
}

}  // namespace

std::vector<std::string> sampleNames() {
  std::vector<std::string> names;
  for (const auto& sample : io::samples()) names.emplace_back(sample.name);
  return names;
}

scene::Scene openSample(const std::string& name, int size, const fs::path& folder, Progress& progress) {
  io::Sample sample = io::makeSample(name, size, progress);
  fs::create_directories(folder);
  scene::Source volume, labels;
  volume.path = (folder / (name + ".nrrd")).string();
  labels.path = (folder / (name + "_labels.seg.nrrd")).string();
  io::writeVolume(sample.volume, volume.path, progress);
  io::writeLabels(sample.labels, labels.path, progress);
  scene::Scene scene = open(volume, progress);
  // Labels have no time: over what moves they would lie wrong.
  if (sample.volume.timeSteps == 1) add(scene, labels, progress);
  return scene;
}

std::span<const Showcase> showcases() { return kShowcases; }

Loaded readShowcase(std::string_view name, const fs::path& folder, Progress& progress) {
  auto row = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& r) { return r.showcase.name == name; });
  if (row == std::end(kRows)) throw ArgumentError(fmt::format("{}: there is no such sample", name));
  Loaded loaded;
  std::vector<std::string> notes;  // what was made up of a phantom is no news
  scene::Scene scene = openPhantom(*row, folder, progress, &notes);
  if (*row->preset) scene::applyPreset(scene, row->preset);
  scene.camera = scene::frameVisible(scene, row->view, 4.0 / 3.0);
  for (auto [path, value] : row->fields) scene::setField(scene, path, value);
  scene.sections.layout = scene::Layout::Volume;
  loaded.scene = std::move(scene);
  loaded.isScene = true;
  return loaded;
}

}  // namespace velum::session
