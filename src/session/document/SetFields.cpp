#include "session/document/SetFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/Error.h"
#include "scene/timeline/Tracks.h"
#include "session/document/Body.h"
#include "session/document/LitSphereFiles.h"
#include "session/document/Open.h"
#include "session/document/PaperFile.h"
#include "session/document/StructureShapes.h"
#include "session/document/WorkFile.h"
#include "session/model/LegendLacks.h"

namespace velum::session {

namespace {

constexpr double kMillilitre = 1000.0;  ///< cubic millimetres

bool isSameFile(const scene::Source& a, const scene::Source& b) { return a.path == b.path && a.series == b.series; }
/// Read alike, they give the same data.
bool isSameData(const scene::Source& a, const scene::Source& b) {
  return isSameFile(a, b) && a.raw == b.raw && a.spacing == b.spacing;
}

/// True where a value is a file, the user's own paper, rather than the name of one of our papers.
bool isPaperFile(const std::string& value) {
  if (enumValue<scene::Paper>(value)) return false;
  return value.find_first_of("./") != std::string::npos || std::filesystem::exists(value);
}

/// Gives each item of a list the data of the item before the change that had the same source; a list that is set whole
/// comes without data.
/// @return true when an item is left without data that it did not have before
template <class Item>
bool keepData(std::vector<Item>& items, const std::vector<Item>& before) {
  bool isMissing = false;
  for (auto& item : items) {
    // Several may have one source, or, made in memory, none.
    bool isKept = std::any_of(before.begin(), before.end(), [&](const Item& other) {
      return item.data == other.data && isSameData(item.source, other.source);
    });
    if (isKept && item.data) continue;
    auto known = std::find_if(before.begin(), before.end(),
                              [&](const Item& other) { return isSameData(item.source, other.source); });
    bool isNew = known == before.end();
    if (isNew)
      item.data = {};
    else
      item.data = known->data;
    isMissing |= isNew && !item.source.path.empty();
  }
  return isMissing;
}

/// Gives up data that does not come from where the scene says. @return true when something is to be read in its place
bool dropStale(scene::Scene& after, const scene::Scene& before) {
  bool isMissing = keepData(after.surfaces, before.surfaces);
  isMissing |= keepData(after.finish.spheres, before.finish.spheres);
  if (!isSameData(after.volume.source, before.volume.source)) {
    after.volume.data = after.volume.given = {};
    isMissing |= !after.volume.source.path.empty();
  }
  if (!isSameData(after.labels.source, before.labels.source)) {
    auto& labels = after.labels;
    labels.data = labels.given = labels.unsmoothed = {};
    labels.smoothed.clear();
    labels.grown.clear();
    isMissing |= !labels.source.path.empty();
  }
  if (!isSameData(after.model.source, before.model.source) || after.model.completes != before.model.completes) {
    after.model.data = {};
    after.model.levels = {};
    isMissing |= !after.model.source.path.empty();
  }
  if (!isSameData(after.finish.ownPaper.source, before.finish.ownPaper.source)) {
    after.finish.ownPaper.data = {};
    isMissing |= !after.finish.ownPaper.source.path.empty();
  }
  return isMissing;
}

bool isOtherReading(const scene::Scene& after, const scene::Scene& before) {
  const scene::Source &now = after.volume.source, &was = before.volume.source;
  return before.volume.data && isSameFile(now, was) && !isSameData(now, was);
}

/// Data that was there before, or that was asked for only now, must be there: throws where it is missing.
void expectData(const scene::Scene& after, const scene::Scene& before) {
  auto known = missingData(before);
  for (const auto& missing : missingData(after)) {
    bool isNews = std::none_of(known.begin(), known.end(), [&](const MissingData& other) {
      return other.field == missing.field && other.path == missing.path;
    });
    if (isNews) throw InputError(sayMissing(missing));
  }
}

/// A sheet that becomes passive starts anew from flat: the place to which it had come while active is forgotten.
void followMembranes(scene::Scene& after, const scene::Scene& before) {
  for (scene::Cut& cut : after.cuts) {
    const scene::Cut* was = scene::findCut(before, cut.id);
    if (!cut.membrane || !was || !was->membrane || cut.membrane->repositioning == was->membrane->repositioning)
      continue;
    if (cut.membrane->repositioning == scene::Repositioning::Passive) cut.membrane->shape = {};
  }
}

std::vector<std::string> followPictures(scene::Scene& after, const scene::Scene& before) {
  const scene::Finish &now = after.finish, &was = before.finish;
  bool isNewlyOwn = now.paper == scene::Paper::Own && was.paper != scene::Paper::Own;
  if (isNewlyOwn && !now.ownPaper.data && now.ownPaper.source.path.empty())
    throw ArgumentError("finish.paper: own is without a picture; give the file of one");
  std::vector<std::string> notes;
  if (!(now.spheres == was.spheres) || now.sphere != was.sphere ||
      !(after.labels.structures == before.labels.structures))
    notes = loadLitSpheres(after, {});
  std::string paper = now.ownPaper.source.path;
  if (!paper.empty() && !now.ownPaper.data && !isSameData(now.ownPaper.source, was.ownPaper.source)) {
    scene::Paper chosen = now.paper;
    takePaper(after, paper);
    after.finish.paper = chosen;
  }
  if (after.lettering.entries != before.lettering.entries)
    if (std::string note = whatLegendLacks(after); !note.empty()) notes.push_back(note);
  return notes;
}

}  // namespace

void setField(scene::Scene& scene, const std::string& path, const std::string& value) {
  if (path == "finish.paper" && isPaperFile(value)) {
    scene::setField(scene, "finish.ownPaper.source.path", std::filesystem::absolute(value).string());
    return scene::setField(scene, path, "own");
  }
  if (!path.ends_with(".source.path")) return scene::setField(scene, path, value);
  bool isFile = !value.empty() && value != "\"\"";
  scene::setField(scene, path, isFile ? std::filesystem::absolute(value).string() : value);
  // Of another file nothing is known yet; by what was known of the one before, that would be found again.
  std::string source = path.substr(0, path.size() - std::string_view("path").size());
  scene::setField(scene, source + "fingerprint", "\"\"");
}

bool mustFollow(const scene::Scene& after, const scene::Scene& before) {
  scene::Scene kept = after;
  return dropStale(kept, before) || !bodyFits(after) || !shapesFit(after);
}

std::vector<std::string> followFields(scene::Scene& after, const scene::Scene& before, Progress& progress) {
  if (isOtherReading(after, before)) {
    scene::Source wanted = after.volume.source;
    after.volume.source = before.volume.source;
    rereadVolume(after, wanted, progress);
    scene::Scene reread = before;
    reread.volume = after.volume;
    reread.labels.source = after.labels.source;
    return followFields(after, reread, progress);
  }
  std::vector<std::string> notes;
  if (dropStale(after, before)) {
    DataPolicy policy;
    policy.keepsWithoutData = true;
    loadData(after, {}, progress, policy, &notes);
    expectData(after, before);
  }
  if (!bodyFits(after)) {
    double millimetres = millimetresPer(after.unit);
    double millilitres = settleBody(after, progress) * std::pow(millimetres, 3) / kMillilitre;
    if (millilitres > 0.0)
      notes.push_back(fmt::format("{:.3g} ml that are not part of the largest body are hidden", millilitres));
    else if (after.volume.bodyOnly)
      notes.push_back("nothing lies beside the body");
  }
  settleShapes(after, progress);
  followMembranes(after, before);
  if (after.timeline.tracks != before.timeline.tracks)
    for (const auto& note : scene::joinTracks(after)) notes.push_back(note);
  for (const auto& note : followPictures(after, before))
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  return notes;
}

std::vector<std::string> setFields(scene::Scene& scene, const std::vector<scene::FieldValue>& values,
                                   Progress& progress) {
  scene::Scene next = scene;
  for (const auto& [path, value] : values) setField(next, path, value);
  auto notes = followFields(next, scene, progress);
  scene = std::move(next);
  return notes;
}

}  // namespace velum::session
