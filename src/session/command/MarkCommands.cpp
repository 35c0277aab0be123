#include "session/command/MarkCommands.h"

#include <algorithm>

#include "scene/PlateStyles.h"
#include "scene/Scene.h"
#include "scene/timeline/Tracks.h"
#include "session/command/CommandRow.h"
#include "session/command/ModelCommands.h"
#include "session/command/StructureCommands.h"
#include "session/measure/Follow.h"
#include "session/model/ModelEdit.h"

namespace velum::session::detail {

namespace {

using scene::Mark;
using scene::MarkKind;
using scene::Scene;

/// Points that follow something need not be given. @throw ArgumentError where what they follow is not there
void placeFollowing(const Scene& scene, Mark& mark) {
  std::size_t count = std::max(mark.pointInstances.size(), mark.pointStructures.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFollowing(mark, i)) continue;
    if (i < mark.pointInstances.size() && mark.pointInstances[i] >= 0) {
      if (!instancePlace(scene, std::uint32_t(mark.pointInstances[i])))
        throw ArgumentError(fmt::format("the model has no instance {}", mark.pointInstances[i]));
    } else if (!middleOfVoxels(scene, mark.pointStructures[i])) {
      throw ArgumentError(fmt::format("structure {} has no voxels that a point could follow", mark.pointStructures[i]));
    }
    if (i > mark.points.size())
      throw ArgumentError(fmt::format("point {} of the mark follows nothing and has no place", mark.points.size() + 1));
    if (i == mark.points.size()) mark.points.emplace_back(0.0);
  }
  mark = followed(scene, mark);
}

Mark markFrom(const Scene& scene, const AddMark& a) {
  Mark mark{.kind = a.kind, .points = a.points, .alongSurface = a.alongSurface, .type = a.type, .text = a.text};
  mark.normal = a.normal;
  mark.pointInstances = a.pointInstances;
  for (const std::string& name : a.pointStructures)
    mark.pointStructures.push_back(name.empty() || name == "0" ? 0 : structureIds(scene, {name})[0]);
  placeFollowing(scene, mark);
  if (!a.structure.empty()) mark.structure = structureIds(scene, {a.structure})[0];
  if (!a.type.empty()) typeNumbers(scene, {a.type});  // says where there is none
  if (a.kind == MarkKind::Name && mark.structure == 0 && a.type.empty())
    throw ArgumentError("a name is of a structure or of a type of the model: give structure=NAME or type=PATH");
  if (a.kind == MarkKind::Region && mark.structure == 0)
    throw ArgumentError("a region is of a structure: give structure=NAME");
  return mark;
}

/// Ids of the marks that are named, in their order.
std::vector<int> markIds(const Scene& scene, const std::vector<std::string>& marks) {
  std::vector<int> ids;
  const auto& all = scene.lettering.marks;
  for (const std::string& key : marks) ids.push_back(all[scene::detail::findByKey(all, key, "lettering.marks")].id);
  return ids;
}

Mark* markWithId(Scene& scene, int id) {
  auto& all = scene.lettering.marks;
  auto found = std::ranges::find(all, id, &Mark::id);
  return found == all.end() ? nullptr : &*found;
}

void follow(const Scene& scene, Mark& mark, bool follows, const Progress& progress) {
  Mark now = follows ? following(scene, mark, progress) : fixed(scene, mark);
  if (follows && now.pointInstances.empty() && now.pointStructures.empty())
    throw ArgumentError(
        fmt::format("no point of mark {} lies in a structure or in an instance that it could follow", mark.id));
  mark = std::move(now);
}

/// "Remove angle", "Remove 3 marks".
template <class Arguments>
auto stepOfMarks(const char* verb) {
  return [verb](const Scene& scene, const Arguments& a) {
    std::vector<int> ids = markIds(scene, a.marks);
    const auto& all = scene.lettering.marks;
    if (ids.size() != 1) return fmt::format("{} {} marks", verb, ids.size());
    return fmt::format("{} {}", verb, enumName(std::ranges::find(all, ids[0], &Mark::id)->kind));
  };
}

}  // namespace

std::vector<Command> markCommands() {
  return {
      editRow<AddMark>(
          "Adds a mark: a measure, an arrow, or words beside a place; its fields are set as any other: set "
          "lettering.marks[#1].wordsAt 0.1,0.",
          "mark.add distance [[3.0,-50.0,20.0],[3.0,-10.0,20.0]]",
          [](const Scene&, const AddMark& a) { return fmt::format("Add {}", enumName(a.kind)); },
          [](Scene& scene, const AddMark& a) { scene::addMark(scene.lettering.marks, markFrom(scene, a)); }),
      editRow<RemoveMarks>("Removes marks.", "mark.remove 1", stepOfMarks<RemoveMarks>("Remove"),
                           [](Scene& scene, const RemoveMarks& a) {
                             for (int id : markIds(scene, a.marks))
                               std::erase_if(scene.lettering.marks, [id](const Mark& m) { return m.id == id; });
                             scene::dropLostTracks(scene);
                           }),
      editRow<FollowMarks>(
          "Lets each point of marks follow what is there: the instance of the model that holds it, or the structure in "
          "which it lies, in its middle.",
          "mark.follow 1",
          [](const Scene& scene, const FollowMarks& a) {
            return stepOfMarks<FollowMarks>(a.follow ? "Let follow" : "Let go")(scene, a);
          },
          [](Scene& scene, const FollowMarks& a, Progress& progress) {
            for (int id : markIds(scene, a.marks)) follow(scene, *markWithId(scene, id), a.follow, progress);
          }),
      editRow<DuplicateMarks>("Adds a copy of each mark.", "mark.duplicate 1", stepOfMarks<DuplicateMarks>("Duplicate"),
                              [](Scene& scene, const DuplicateMarks& a) {
                                for (int id : markIds(scene, a.marks))
                                  scene::addMark(scene.lettering.marks, Mark(*markWithId(scene, id)));
                              }),
      editRow<ShowMarks>(
          "Shows or hides marks.", "mark.show 1 false",
          [](const Scene& scene, const ShowMarks& a) {
            return stepOfMarks<ShowMarks>(a.visible ? "Show" : "Hide")(scene, a);
          },
          [](Scene& scene, const ShowMarks& a) {
            for (int id : markIds(scene, a.marks)) markWithId(scene, id)->visible = a.visible;
          }),
      editRow<ChooseLetteringStyle>(
          "Gives all lettering a style by name: typeface, sizes on the page, colour, halo.", "lettering.style journal",
          [](const Scene&, const ChooseLetteringStyle& a) { return "Style of lettering: " + a.style; },
          [](Scene& scene, const ChooseLetteringStyle& a) { scene::applyPlateStyle(scene.lettering, a.style); }),
  };
}

}  // namespace velum::session::detail
