#include "session/command/LetteringCommands.h"

#include "scene/Scene.h"
#include "scene/timeline/Tracks.h"
#include "session/command/CommandRow.h"
#include "session/structure/StructureEdit.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

/// Without line ends and other space that no name has.
std::string inOneLine(const std::string& text) {
  std::string line;
  for (char c : text) {
    bool isSpace = static_cast<unsigned char>(c) <= ' ';
    if (!isSpace) line += c;
    if (isSpace && !line.empty() && line.back() != ' ') line += ' ';
  }
  if (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

}  // namespace

std::vector<Command> letteringCommands() {
  return {
      editRow<RenameType>(
          "Gives a type or compartment the name by which it is shown.", "model.rename root.capsid Capsid of the virus",
          [](const Scene& scene, const RenameType& a) {
            return a.name.empty() ? "Name of " + nameAt(scene, a.type) + " as in the file"
                                  : "Rename " + nameAt(scene, a.type) + " to " + inOneLine(a.name);
          },
          [](Scene& scene, const RenameType& a) {
            typeNumbers(scene, {a.type});  // says where there is none
            rename(scene, a.type, inOneLine(a.name));
          }),
      editRow<ListInLegend>(
          "Lists types, and compartments as one entry each, in the legend, or takes them out of its list; with an "
          "empty list it names what is seen most.",
          "model.listInLegend root.capsid,root.blood",
          [](const Scene& scene, const ListInLegend& a) {
            return (a.listed ? "List in legend: " : "Take out of legend: ") + rowsLabel(scene, a.types);
          },
          [](Scene& scene, const ListInLegend& a) {
            typeNumbers(scene, a.types);  // says which are none
            listInLegend(scene, a.types, a.listed);
          }),
      editRow<ListStructuresInLegend>(
          "Lists structures in the legend, or takes them out of its list; with an empty list it names what is shown.",
          "structure.listInLegend heart,aorta",
          [](const Scene& scene, const ListStructuresInLegend& a) {
            return structureLabel(
                scene, a.listed ? "List in legend:" : "Take out of legend:", structureIds(scene, a.structures));
          },
          [](Scene& scene, const ListStructuresInLegend& a) {
            std::vector<std::string> entries;
            for (int id : structureIds(scene, a.structures)) entries.push_back(structureName(scene, id));
            listInLegend(scene, entries, a.listed);
          }),
      editRow<AddCaption>(
          "Adds a caption over the picture, whose fields are set as any other: set lettering.captions[#1].opacity 0.5.",
          "caption.add place=top size=2 The aorta, opened", "Add caption",
          [](Scene& scene, const AddCaption& a) {
            scene::addCaption(scene.lettering.captions, {.text = a.text, .place = a.place, .size = a.size});
          }),
      editRow<RemoveCaption>("Removes a caption.", "caption.remove 1", "Remove caption",
                             [](Scene& scene, const RemoveCaption& a) {
                               auto& all = scene.lettering.captions;
                               std::size_t place = scene::detail::findByKey(all, a.caption, "lettering.captions");
                               all.erase(all.begin() + std::ptrdiff_t(place));
                               scene::dropLostTracks(scene);
                             }),
  };
}

}  // namespace velum::session::detail
