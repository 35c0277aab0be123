#include "session/command/CutCommands.h"

#include <algorithm>

#include "scene/timeline/Tracks.h"
#include "session/command/CommandRow.h"
#include "session/cut/CutEdit.h"
#include "session/extrusion/Pull.h"
#include "session/membrane/FirstPlace.h"

namespace velum::session {

std::string cutKey(const scene::Scene& scene, int id) { return detail::keyOf(scene.cuts, id); }

const scene::Cut& cutOf(const scene::Scene& scene, const std::string& key) {
  if (!key.empty()) return scene.cuts[scene::detail::findByKey(scene.cuts, key, "cuts")];
  if (scene.cuts.size() == 1) return scene.cuts[0];
  throw ArgumentError(scene.cuts.empty() ? "there is no cut; cut.add adds one"
                                         : "there are several cuts; say which, by cut=NAME");
}

scene::Cut& cutOf(scene::Scene& scene, const std::string& key) {
  return const_cast<scene::Cut&>(cutOf(std::as_const(scene), key));
}

PlaceCut placeOf(const scene::Cut& cut, const std::string& key) {
  return {cut.centre, cut.axis, cut.size, cut.spinDeg, key};
}

namespace detail {

namespace {

using scene::Cut;
using scene::Scene;

void expectRoom(const Scene& scene) {
  if (!scene::hasData(scene)) throw ArgumentError("nothing is open that could be cut");
  if (scene.cuts.size() >= scene::kMostCuts)
    throw ArgumentError(fmt::format("a scene holds {} cuts at most; remove one first", scene::kMostCuts));
}

void put(Scene& scene, Cut cut, const std::string& name) {
  expectRoom(scene);
  if (!name.empty()) cut.name = name;
  if (cut.name.empty()) cut.name = newCutName(scene, cut.shape);
  scene::addCut(scene, cut);
}

void add(Scene& scene, const AddCut& a, Progress& progress) {
  expectRoom(scene);
  bool isMembrane = a.shape == scene::CutShape::Membrane;
  put(scene, isMembrane ? newMembrane(scene, progress) : makeCut(scene, a.shape), a.name);
}

void duplicate(Scene& scene, const DuplicateCut& a) {
  expectRoom(scene);
  const Cut& cut = cutOf(std::as_const(scene), a.cut);
  int place = scene::cutPlace(scene, cut.id);
  Cut copy = cut;
  copy.id = scene::nextCutId(scene);
  copy.name = fmt::format("{} copy", cut.name.empty() ? fmt::format("Cut {}", place + 1) : cut.name);
  scene.cuts.insert(scene.cuts.begin() + place + 1, copy);
}

/// What was pulled out of the cut goes along.
void place(Scene& scene, const PlaceCut& a) {
  Cut moved = cutOf(std::as_const(scene), a.cut);
  moved.centre = a.centre;
  moved.axis = a.axis;
  moved.size = a.size;
  moved.spinDeg = a.spinDeg;
  moveCut(scene, std::move(moved));
}

void moveInList(Scene& scene, const MoveCutInList& a) {
  int from = scene::cutPlace(scene, cutOf(std::as_const(scene), a.cut).id);
  int to = std::clamp(from + a.by, 0, int(scene.cuts.size()) - 1);
  Cut cut = scene.cuts[std::size_t(from)];
  scene.cuts.erase(scene.cuts.begin() + from);
  scene.cuts.insert(scene.cuts.begin() + to, cut);
}

/// Changes a cut, with what stands out of it.
template <class Arguments>
auto changeCut(void (*change)(Cut&, const Arguments&)) {
  return [change](Scene& scene, const Arguments& a) {
    Cut& cut = cutOf(scene, a.cut);
    Cut before = cut;
    change(cut, a);
    carryPulled(scene, before);
  };
}

}  // namespace

std::vector<Command> cutCommands() {
  return {
      editRow<AddCut>(
          "Adds a cut where it is of use at once.", "cut.add box",
          [](const Scene&, const AddCut& a) {
            return std::string(a.shape == scene::CutShape::Membrane ? "Add membrane" : "Add cut");
          },
          add),
      editRow<CutAlongView>("Adds a plane through the middle that faces the eye.", "cut.alongView",
                            "Cut along the view",
                            [](Scene& scene, const CutAlongView&) { put(scene, cutFacingCamera(scene), ""); }),
      editRow<RemoveCut>("Removes a cut.", "cut.remove \"Plane 1\"", "Remove cut",
                         [](Scene& scene, const RemoveCut& a) {
                           int place = scene::cutPlace(scene, cutOf(std::as_const(scene), a.cut).id);
                           scene.cuts.erase(scene.cuts.begin() + place);
                           scene::dropLostTracks(scene);
                         }),
      editRow<DuplicateCut>("Adds a copy of a cut, right behind it.", "cut.duplicate \"Plane 1\"", "Duplicate cut",
                            duplicate),
      editRow<PlaceCut>("Puts a cut elsewhere, with what was pulled out of it.",
                        "cut.place 0,0,40 0,0,1 cut=\"Plane 1\"", "Move cut", place),
      editRow<FlipCut>("Lets a cut take away the other side.", "cut.flip", "Flip cut",
                       changeCut<FlipCut>([](Cut& cut, const FlipCut&) { cut.invert = !cut.invert; })),
      editRow<EnableCut>(
          "Turns a cut on or off.", "cut.enable \"Plane 1\" false",
          [](const Scene&, const EnableCut& a) { return std::string(a.enabled ? "Turn cut on" : "Turn cut off"); },
          [](Scene& scene, const EnableCut& a) { cutOf(scene, a.cut).enabled = a.enabled; }),
      editRow<RenameCut>(
          "Gives a cut another name.", "cut.rename 1 window", "Rename cut",
          [](Scene& scene, const RenameCut& a) { cutOf(scene, a.cut).name = std::string(trimmed(a.name)); }),
      editRow<MoveCutInList>("Moves a cut up or down in the list.", "cut.moveInList \"Plane 1\" -1",
                             "Move cut in the list", moveInList),
  };
}

}  // namespace detail

}  // namespace velum::session
