#include "session/command/StructureCommands.h"

#include <algorithm>

#include "session/command/CommandRow.h"
#include "session/command/CutCommands.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/structure/StructureEdit.h"
#include "session/structure/StructureRow.h"

namespace velum::session {

std::vector<std::string> structureNames(const scene::Scene& scene, const std::vector<int>& ids) {
  std::vector<std::string> names;
  for (int id : ids) names.push_back(detail::keyOf(scene.labels.structures, id));
  return names;
}

std::vector<int> structureIds(const scene::Scene& scene, const std::vector<std::string>& names) {
  std::vector<int> ids;
  const auto& all = scene.labels.structures;
  for (const auto& name : names) ids.push_back(all[scene::detail::findByKey(all, name, "labels.structures")].id);
  return ids;
}

namespace detail {

namespace {

using scene::Scene;
using scene::Structure;

/// The name of a step from its first words.
template <class Arguments>
auto stepBy(const char* verb) {
  return [verb](const Scene& scene, const Arguments& arguments) {
    return structureLabel(scene, verb, structureIds(scene, arguments.structures));
  };
}

/// Changes each of the structures that are named.
template <class Arguments>
auto changeEach(void (*change)(Structure&, const Arguments&)) {
  return [change](Scene& scene, const Arguments& arguments) {
    changeStructures(scene, structureIds(scene, arguments.structures), [&](Structure& s) { change(s, arguments); });
  };
}

void setSphere(Scene& scene, const SetStructureSphere& arguments) {
  changeEach<SetStructureSphere>([](Structure& s, const auto& a) { s.litSphere = a.litSphere; })(scene, arguments);
  // A user who chooses a lit sphere wants to see it.
  if (arguments.litSphere.empty()) return;
  scene.finish.structureSpheres = true;
  if (scene.finish.litSphere == 0.0) scene.finish.litSphere = 0.5;
}

std::string soloStep(const Scene& scene, const SoloStructure& a) {
  std::vector<int> ids = structureIds(scene, {a.structure});
  return structureLabel(scene, soloStructure(scene) == ids[0] ? "End solo of" : "Solo", ids);
}

void solo(Scene& scene, const SoloStructure& a) {
  SoloMemory memory;
  if (!a.shown.empty()) memory = {soloStructure(scene).value_or(0), structureIds(scene, a.shown), a.unlabelled};
  std::sort(memory.visible.begin(), memory.visible.end());
  toggleSolo(scene, memory, structureIds(scene, {a.structure})[0]);
}

}  // namespace

std::vector<Command> structureCommands() {
  return {
      editRow<ShowStructures>(
          "Shows structures, or hides them.", "structure.show \"aorta,left kidney\" false",
          [](const Scene& scene, const ShowStructures& a) {
            return structureLabel(scene, a.visible ? "Show" : "Hide", structureIds(scene, a.structures));
          },
          changeEach<ShowStructures>([](Structure& s, const auto& a) { s.visible = a.visible; })),
      editRow<ShowLabels>(
          "Shows the labels, or hides them.", "structure.showLabels false",
          [](const Scene&, const ShowLabels& a) { return std::string(a.visible ? "Show labels" : "Hide labels"); },
          [](Scene& scene, const ShowLabels& a) { scene.labels.visible = a.visible; }),
      editRow<InvertStructures>(
          "Shows those that are hidden and hides those that are shown.", "structure.invert aorta,heart",
          "Invert what is shown",
          changeEach<InvertStructures>([](Structure& s, const auto&) { s.visible = !s.visible; })),
      editRow<SoloStructure>("Shows a structure alone; where it is alone already, what was shown before.",
                             "structure.solo heart", soloStep, solo),
      editRow<ColorStructures>("Gives structures a colour of their own.", "structure.color aorta 0.8,0.1,0.1",
                               stepBy<ColorStructures>("Colour"),
                               [](Scene& scene, const ColorStructures& a) {
                                 colorStructures(scene, structureIds(scene, a.structures), a.color);
                               }),
      editRow<SetStructureOpacity>(
          "Makes structures more or less opaque.", "structure.opacity skin 0.2",
          stepBy<SetStructureOpacity>("Opacity of"),
          changeEach<SetStructureOpacity>([](Structure& s, const auto& a) { s.opacity = a.opacity; })),
      editRow<ShowStructuresAs>(
          "Shows structures as material or as solid surfaces.", "structure.showAs heart solid",
          [](const Scene& scene, const ShowStructuresAs& a) {
            bool isSolid = a.showAs == scene::ShowAs::Solid;
            return structureLabel(scene,
                                  isSolid ? "Show solid:" : "Show as material:", structureIds(scene, a.structures));
          },
          changeEach<ShowStructuresAs>([](Structure& s, const auto& a) {
            s.showAs = a.showAs;
            s.visible = true;
          })),
      editRow<SetStructureSphere>("Gives structures a lit sphere of their own in a finished picture.",
                                  "structure.litSphere femur bone", stepBy<SetStructureSphere>("Lit sphere of"),
                                  setSphere),
      editRow<SmoothStructures>(
          "Smooths the shapes that structures have in their file.", "structure.smooth heart 1.5",
          stepBy<SmoothStructures>("Smooth"),
          changeEach<SmoothStructures>([](Structure& s, const auto& a) { s.smoothing = a.deviation; })),
      editRow<RenameStructure>(
          "Gives a structure another name.", "structure.rename 12 aorta",
          [](const Scene& scene, const RenameStructure& a) {
            return structureLabel(scene, "Rename", structureIds(scene, {a.structure}));
          },
          [](Scene& scene, const RenameStructure& a) {
            renameStructure(scene, structureIds(scene, {a.structure})[0], a.name);
          }),
      editRow<SpareStructures>(
          "Lets a cut leave structures whole, or go through them again.", "structure.spare aorta cut=\"Plane 1\"",
          [](const Scene& scene, const SpareStructures& a) {
            return structureLabel(scene, a.whole ? "Spare" : "Cut", structureIds(scene, a.structures));
          },
          [](Scene& scene, const SpareStructures& a) {
            for (int id : structureIds(scene, a.structures)) setSpared(cutOf(scene, a.cut), id, a.whole);
          }),
      editRow<ProtectStructures>(
          "Lets a membrane's sheet go around structures, or draws it to them.", "structure.protect heart 60",
          [](const Scene& scene, const ProtectStructures& a) {
            const char* verb = a.strength > 0   ? "Protect by membrane:"
                               : a.strength < 0 ? "Draw membrane to"
                                                : "No force of";
            return structureLabel(scene, verb, structureIds(scene, a.structures));
          },
          [](Scene& scene, const ProtectStructures& a) {
            scene::Cut& cut = cutOf(scene, a.cut);
            if (!scene::isMembrane(cut)) throw ArgumentError("structure.protect: the cut is no membrane");
            for (int id : structureIds(scene, a.structures)) protectStructure(*cut.membrane, id, a.strength);
          }),
  };
}

}  // namespace detail

}  // namespace velum::session
