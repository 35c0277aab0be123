#include "session/command/GrowthCommands.h"

#include <algorithm>

#include "scene/StructureAt.h"
#include "session/Session.h"
#include "session/command/CommandRow.h"
#include "session/command/CutCommands.h"
#include "session/command/StructureCommands.h"
#include "session/extrusion/GrowStructure.h"
#include "session/extrusion/Pull.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

/// @throw ArgumentError where it was not grown
int grownOf(const Scene& scene, const std::string& structure) {
  int id = structureIds(scene, {structure})[0];
  if (!lastGrowth(scene, id)) throw ArgumentError(fmt::format("{} was not grown", structureName(scene, id)));
  return id;
}

template <class Arguments>
auto stepOfGrown(const char* verb) {
  return [verb](const Scene& scene, const Arguments& a) {
    return structureLabel(scene, verb, structureIds(scene, {a.structure}));
  };
}

void pullAt(Scene& scene, const PullAt& a) {
  int cut = cutOf(std::as_const(scene), a.cut).id;
  int structure = scene.labels.data && scene.labels.visible ? scene::structureAt(scene, a.place).id : 0;
  auto pull = beginPull(scene, cut, a.place, structure);
  if (!pull)
    throw ArgumentError(fmt::format("growth.pullAt {}: there is nothing that could be pulled", textOf(a.place)));
  pullTo(scene, *pull, a.distance);
}

std::vector<std::string> grow(Session& session, const GrowStructure& a, Progress&) {
  try {
    scene::Growth step = stepOf(session.shown(), a);
    if (!a.guard) session.growth().trust(step.structure);
    if (!a.range.empty()) session.growth().takeTypedRange(step.structure);
    session.document().edit(
        "Grow " + (a.name.empty() ? std::string("structure") : a.name),
        [&](Scene& scene) { addGrowth(scene, step, a.name); }, false, Call(a).line());
  } catch (const ArgumentError& error) {
    throw ArgumentError(fmt::format("{} {}", GrowStructure::kName, error.what()));
  }
  return {};
}

/// A user who lets a structure grow on has seen where it leaks.
std::vector<std::string> growFurther(Session& session, const GrowOn& a, Progress&) {
  int id = grownOf(session.shown(), a.structure);
  session.growth().trust(id);
  session.document().edit(
      structureLabel(session.shown(), "Grow on:", {id}), [id](Scene& scene) { growOn(scene, id); }, false,
      Call(a).line());
  return {};
}

/// What has grown so far stays.
/// A script says by fields how far it has come: whoever runs it again waits until all has grown.
std::vector<std::string> stopGrowing(Session& session, const StopGrowing&, Progress&) {
  if (auto reached = session.growth().stop())
    session.document().edit("Stop growing", [&](Scene& scene) { holdGrowth(scene, *reached); });
  return {};
}

template <class Arguments>
std::vector<glm::dvec3> placesOf(const Arguments& a) {
  std::vector<glm::dvec3> places{a.place};
  places.insert(places.end(), a.more.begin(), a.more.end());
  return places;
}

void addSeed(Scene& scene, const AddSeed& a) {
  if (addSeeds(scene, grownOf(scene, a.structure), placesOf(a)) == 0)
    throw ArgumentError(fmt::format("growth.addSeed {}: the value there is none of its range", textOf(a.place)));
}

void notThis(Scene& scene, const NotThis& a) {
  if (addOthers(scene, grownOf(scene, a.structure), placesOf(a)) == 0)
    throw ArgumentError(fmt::format("growth.notThis {}: it does not grow there", textOf(a.place)));
}

void drawBarrier(Scene& scene, const DrawBarrier& a) {
  if (a.path.empty()) throw ArgumentError("growth.barrier wants the points of a stroke: [[X,Y,Z],[X,Y,Z]]");
  changeGrowth(scene, grownOf(scene, a.structure), [&](scene::Growth& growth) {
    growth.barriers.push_back({a.path, a.radius});
  });
}

void change(Scene& scene, const ChangeGrowth& a) {
  constexpr std::string_view kFields[] = {"low", "high", "steepest", "closing", "fillHoles"};
  if (std::ranges::find(kFields, a.field) == std::end(kFields))
    throw ArgumentError(fmt::format("growth.change changes {}, not '{}'", fmt::join(kFields, ", "), a.field));
  changeGrowth(scene, grownOf(scene, a.structure),
               [&](scene::Growth& growth) { scene::detail::assignMember(growth, a.field, a.value, "growths"); });
}

}  // namespace

std::vector<Command> growthCommands() {
  return {
      actRow<GrowStructure>("Grows a structure out of the volume, from places on it.",
                            "growth.grow [[12.0,-40.0,80.0]] 200,3000 name=bone", grow),
      editRow<PullAt>("Pulls out of a cut what is in a place of its face; what has no label grows from there.",
                      "growth.pullAt 12,-40,80 30", "Pull out", pullAt),
      editRow<AddSeed>("Lets a structure that was grown go on from another place.",
                       "growth.addSeed \"structure 1\" 12,-40,80", stepOfGrown<AddSeed>("Add to"), addSeed),
      editRow<NotThis>("Says of a place that it is not of a structure that was grown.",
                       "growth.notThis \"structure 1\" 12,-40,80", stepOfGrown<NotThis>("Not this:"), notThis),
      actRow<GrowOn>("Lets a structure that was held grow as far as it is pulled, and minds no leak of it any more.",
                     "growth.growOn \"structure 1\"", growFurther),
      actRow<StopGrowing>("Ends what is growing: what has grown so far stays.", "growth.stop", stopGrowing),
      editRow<DrawBarrier>("Draws a stroke that a structure does not grow through.",
                           "growth.barrier \"structure 1\" [[12.0,-40.0,80.0],[18.0,-40.0,80.0]]", "Draw barrier",
                           drawBarrier),
      editRow<ChangeGrowth>(
          "Changes how a structure grows: it grows anew.", "growth.change \"structure 1\" closing 1.5",
          [](const Scene& scene, const ChangeGrowth& a) {
            return structureLabel(scene, "Change growth of", structureIds(scene, {a.structure}));
          },
          change),
      editRow<ForgetGrown>("Forgets a structure that was grown.", "growth.forget \"structure 1\"",
                           stepOfGrown<ForgetGrown>("Forget"),
                           [](Scene& scene, const ForgetGrown& a) { removeGrown(scene, grownOf(scene, a.structure)); }),
  };
}

}  // namespace velum::session::detail
