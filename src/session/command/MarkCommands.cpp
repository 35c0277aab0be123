#include "session/command/MarkCommands.h"

#include <algorithm>

#include "scene/PlateStyles.h"
#include "scene/Scene.h"
#include "scene/timeline/Tracks.h"
#include "session/command/CommandRow.h"
#include "session/command/ModelCommands.h"
#include "session/command/StructureCommands.h"

namespace velum::session::detail {

namespace {

using scene::Mark;
using scene::MarkKind;
using scene::Scene;

Mark markFrom(const Scene& scene, const AddMark& a) {
  Mark mark{.kind = a.kind, .points = a.points, .alongSurface = a.alongSurface, .type = a.type, .text = a.text};
  mark.instance = a.instance;
  mark.normal = a.normal;
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
