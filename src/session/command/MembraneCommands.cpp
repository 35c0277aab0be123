#include "session/command/MembraneCommands.h"

#include "session/command/CommandRow.h"
#include "session/extrusion/Pull.h"
#include "session/membrane/FirstPlace.h"
#include "session/membrane/HangMembrane.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/SheetHands.h"

namespace velum::session::detail {

namespace {

using scene::Cut;
using scene::Scene;

Cut& membraneOf(Scene& scene, const std::string& key) {
  Cut& cut = cutOf(scene, key);
  if (!scene::isMembrane(cut)) throw ArgumentError("the cut is no membrane; cut.add membrane adds one");
  return cut;
}

/// @param avoided  of a strength that is not above 0
template <class Arguments>
auto stepByStrength(const char* kept, const char* avoided) {
  return [=](const Scene&, const Arguments& a) { return std::string(a.strength > 0.0 ? kept : avoided); };
}

void protectValuesOf(Scene& scene, const ProtectValues& a) {
  if (!(a.low < a.high)) throw ArgumentError("membrane.protectValues: low must be less than high");
  protectValues(*membraneOf(scene, a.cut).membrane, a.low, a.high, a.strength);
}

void protectAt(Scene& scene, const ProtectAt& a) {
  if (!protectTissue(*membraneOf(scene, a.cut).membrane, scene.volume, a.place, a.strength))
    throw ArgumentError(fmt::format("membrane.protectAt {}: that is outside the volume", textOf(a.place)));
}

void pushSheet(Scene& scene, const PushSheet& a) {
  Cut& cut = membraneOf(scene, a.cut);
  addKernel(*cut.membrane, a.centre, a.radius > 0.0 ? a.radius : defaultRadius(cut), a.strength);
}

void pinSheet(Scene& scene, const PinSheet& a) {
  Cut& cut = membraneOf(scene, a.cut);
  auto pin = pinOver(cut, a.place);
  if (!pin)
    throw ArgumentError(fmt::format("membrane.pin {}: that is beside the frame of the membrane", textOf(a.place)));
  cut.membrane->pins.push_back(*pin);
}

void moveToKeep(Scene& scene, const MoveToKeep& a, Progress& progress) {
  Cut& cut = membraneOf(scene, a.cut);
  Cut before = cut;
  cut = placedToKeep(scene, cut, progress, !a.keepsReach).value_or(cut);
  carryPulled(scene, before);
}

}  // namespace

std::vector<Command> membraneCommands() {
  return {
      editRow<HangMembrane>("Adds a membrane that protects what is said, as far as it can.",
                            "membrane.hang 200,3000 axis=0,-1,0", "Add membrane",
                            [](Scene& scene, const HangMembrane& a, Progress& progress) {
                              if (scene.cuts.size() >= scene::kMostCuts)
                                throw ArgumentError(fmt::format("a scene has at most {} cuts", scene::kMostCuts));
                              try {
                                scene::addCut(scene, hungMembrane(scene, a, progress));
                              } catch (const ArgumentError& error) {
                                throw ArgumentError(fmt::format("{} {}", HangMembrane::kName, error.what()));
                              }
                            }),
      editRow<ProtectValues>("Lets a membrane's sheet go around all values of a range.",
                             "membrane.protectValues 200 3000", "Protect values", protectValuesOf),
      editRow<ProtectAt>("Lets the sheet go around material like that in a place: what a click does.",
                         "membrane.protectAt 12,-40,80",
                         stepByStrength<ProtectAt>("Protect from sheet", "Let sheet through"), protectAt),
      editRow<PushSheet>("Puts a ball in that pushes the sheet away or draws it.", "membrane.kernel 12,-40,80 25",
                         stepByStrength<PushSheet>("Push sheet", "Pull sheet"), pushSheet),
      editRow<PinSheet>("Holds the sheet in a place.", "membrane.pin 12,-40,80", "Add pin", pinSheet),
      editRow<ChooseRule>(
          "Chooses how kernels push, with the cloth that goes with it.", "membrane.rule paper", "Change membrane: rule",
          [](Scene& scene, const ChooseRule& a) { setRule(*membraneOf(scene, a.cut).membrane, a.rule); }),
      editRow<MoveToKeep>("Moves a membrane along its axis to where it keeps what it protects.", "membrane.moveToKeep",
                          "Move to keep", moveToKeep),
  };
}

}  // namespace velum::session::detail
