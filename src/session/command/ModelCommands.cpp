#include "session/command/ModelCommands.h"

#include <algorithm>

#include "core/NearestName.h"
#include "session/command/CommandRow.h"
#include "session/command/CutCommands.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/model/ClipState.h"
#include "session/model/CountPictures.h"
#include "session/model/InstanceNumber.h"
#include "session/model/ModelScale.h"
#include "session/model/RenderedSolver.h"
#include "session/model/TargetSolver.h"
#include "session/model/TypesAt.h"
#include "session/model/WhatHides.h"
#include "session/picture/Picture.h"

namespace velum::session {

std::vector<std::string> typeNames(const scene::Scene& scene, const TypeNumbers& types) {
  std::vector<std::string> names;
  if (!scene.model.data) return names;
  const Model& model = *scene.model.data;
  for (std::uint32_t type : types)
    if (type < model.types.size()) names.push_back(pathOf(model, model.types[type]));
  return names;
}

TypeNumbers typeNumbers(const scene::Scene& scene, const std::vector<std::string>& names) {
  if (!scene.model.data) throw ArgumentError("there is no model whose types could be named");
  const Model& model = *scene.model.data;
  TypeNumbers numbers;
  std::vector<std::string> paths;
  for (const auto& type : model.types) paths.push_back(pathOf(model, type));
  for (const auto& name : names) {
    std::size_t before = numbers.size();
    for (std::uint32_t i = 0; i < paths.size(); ++i)
      if (paths[i] == name || paths[i].starts_with(name + ".")) numbers.push_back(i);
    if (numbers.size() > before) continue;
    std::string meant = nearestName(name, paths);
    throw ArgumentError(fmt::format("the model has no type or compartment '{}'{}", name,
                                    meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant)));
  }
  return numbers;
}

std::string rowsLabel(const scene::Scene& scene, const std::vector<std::string>& paths) {
  if (paths.size() != 1) return fmt::format("{} rows", paths.size());
  return paths[0].find('.') == std::string::npos ? "all types" : nameAt(scene, paths[0]);
}

namespace detail {

namespace {

using scene::Cut;
using scene::Scene;

template <class Arguments>
auto stepOfTypes(const char* verb) {
  return
      [verb](const Scene& scene, const Arguments& a) { return typesLabel(scene, verb, typeNumbers(scene, a.types)); };
}

void leaveBy(Scene& scene, const LeaveTypesBy& a) {
  typeNumbers(scene, a.types);  // says which are none
  if (a.field == "type") throw ArgumentError("model.leaveBy type: say what is left of the types");
  for (const auto& path : a.types)
    scene::detail::assignMember(ownTypeSpare(cutOf(scene, a.cut), path), a.field, a.value, "model.spares");
  if (a.field == "share" || a.field == "viewShare")
    for (const auto& path : a.types) dropTargets(scene, path);
}

std::vector<int> cutIds(const Scene& scene, const std::vector<std::string>& keys) {
  std::vector<int> ids;
  for (const std::string& key : keys) ids.push_back(cutOf(scene, key).id);
  return ids;
}

std::vector<std::string> setDrawn(Scene& scene, const SetDrawn& a) {
  typeNumbers(scene, {a.type});  // says where there is none
  double wanted = instanceNumber(scene, a.type, a.drawn);
  RenderedSolver solver =
      a.cuts.empty() ? RenderedSolver::ofAllCuts(scene, a.type) : RenderedSolver(scene, cutIds(scene, a.cuts), a.type);
  Solved solved = solver.solve(wanted);
  scene = std::move(solved.scene);
  holdDrawn(scene, solver.path(), double(solved.reached));
  return {solved.words};
}

void soloTypes(Scene& scene, const SoloTypes& a) {
  TypeSoloMemory memory;
  if (!a.shown.empty() && scene.model.data) {
    std::vector<bool> now = visibleTypes(scene.model);
    for (std::uint32_t i = 0; i < now.size(); ++i)
      if (now[i]) memory.alone.push_back(i);
    memory.shown.assign(now.size(), false);
    for (std::uint32_t type : typeNumbers(scene, a.shown)) memory.shown[type] = true;
  }
  toggleSoloTypes(scene, memory, typeNumbers(scene, a.types));
}

void protectTypes(Scene& scene, const ProtectTypes& a) {
  Cut& cut = cutOf(scene, a.cut);
  if (!scene::isMembrane(cut)) throw ArgumentError("model.protect: the cut is no membrane");
  expectModelInReach(scene);
  const Model& model = *scene.model.data;
  for (std::uint32_t type : typeNumbers(scene, a.types))
    protectType(*cut.membrane, pathOf(model, model.types[type]), a.strength);
}

/// @return what could not be met
std::vector<std::string> meetTargets(Scene& scene, const MeetTargets& a, Progress& progress) {
  if (scene.model.targets.empty()) throw ArgumentError("no type has a number to be seen; model.target gives one");
  TargetsReport report = findTargets(scene, parsePictureSize(a.size, 0), progress);
  scene = std::move(report.scene);
  std::vector<std::string> told;
  for (const TargetReport& target : report.targets)
    if (!target.isMet) told.push_back(target.words);
  return told;
}

std::vector<std::string> letSee(Scene& scene, const LetSee& a, Progress& progress) {
  typeNumbers(scene, {a.type});  // says where there is none
  double wanted = instanceNumber(scene, a.type, a.visible);
  Solved solved = findVisible(scene, cutIds(scene, a.cuts), a.type, wanted, parsePictureSize(a.size, 0), progress);
  scene = std::move(solved.scene);
  setVisibleTarget(scene, a.type, wanted);
  return {solved.words};
}

/// How types look, and which show.
std::vector<Command> lookRows() {
  return {
      editRow<ShowTypes>(
          "Shows types of a model, or hides them.", "model.show root.blood false",
          [](const Scene& scene, const ShowTypes& a) {
            return typesLabel(scene, a.visible ? "Show" : "Hide", typeNumbers(scene, a.types));
          },
          [](Scene& scene, const ShowTypes& a) { setTypesVisible(scene, typeNumbers(scene, a.types), a.visible); }),
      editRow<ShowModel>(
          "Shows the model, or hides it.", "model.showModel false",
          [](const Scene&, const ShowModel& a) { return std::string(a.visible ? "Show model" : "Hide model"); },
          [](Scene& scene, const ShowModel& a) { scene.model.visible = a.visible; }),
      editRow<BringToSize>(
          "Enlarges the model, or makes it smaller, so that it is seen beside the other data, at their right.",
          "model.bringToSize", "Bring model to size",
          [](Scene& scene, const BringToSize&) {
            if (othersByModel(scene) == 1.0)
              throw ArgumentError("model.bringToSize: there is no other data beside a model");
            bringModelToSize(scene);
          }),
      editRow<ColorTypes>(
          "Gives types a colour of their own.", "model.color root.capsid 0.9,0.7,0.2",
          stepOfTypes<ColorTypes>("Colour"),
          [](Scene& scene, const ColorTypes& a) { setTypesColor(scene, typeNumbers(scene, a.types), a.color); }),
      editRow<TakePaletteColor>(
          "Gives types the palette's colours again.", "model.paletteColor root.capsid",
          stepOfTypes<TakePaletteColor>("Palette's colour of"),
          [](Scene& scene, const TakePaletteColor& a) { setTypesColor(scene, typeNumbers(scene, a.types), {}); }),
      editRow<ResetTypes>("Shows types as if nothing had been said of them.", "model.reset root",
                          stepOfTypes<ResetTypes>("Reset"),
                          [](Scene& scene, const ResetTypes& a) { resetTypes(scene, typeNumbers(scene, a.types)); }),
      editRow<SetTypeGhosts>("Says how instances of types show that cuts have removed.",
                             "model.ghosts root.blood contour", stepOfTypes<SetTypeGhosts>("Ghosts of"),
                             [](Scene& scene, const SetTypeGhosts& a) {
                               setTypesGhosts(scene, typeNumbers(scene, a.types),
                                              a.asModel ? std::nullopt : std::optional(a.ghosts));
                             }),
      editRow<SoloTypes>(
          "Shows types alone; where they are alone already, what was shown before.", "model.solo root.capsid",
          [](const Scene& scene, const SoloTypes& a) {
            TypeNumbers types = typeNumbers(scene, a.types);
            return typesLabel(scene, isSolo(scene, types) ? "End solo of" : "Solo", types);
          },
          soloTypes),
      editRow<ProtectTypes>(
          "Lets a membrane's sheet go around types of a model, or draws it to them.", "model.protect root.capsid 60",
          [](const Scene& scene, const ProtectTypes& a) {
            return typesLabel(scene, a.strength != 0.0 ? "Protect by membrane:" : "No force of",
                              typeNumbers(scene, a.types));
          },
          protectTypes),
  };
}

/// How many instances show, and what cuts leave.
std::vector<Command> numberRows() {
  return {
      editRow<SetTypeTarget>(
          "Says how many instances of a type or compartment are to be seen.", "model.target root.blood.albumin 400",
          [](const Scene& scene, const SetTypeTarget& a) {
            return fmt::format("Number of {} to be seen", nameAt(scene, a.type));
          },
          [](Scene& scene, const SetTypeTarget& a) {
            if (a.isAny) return setVisibleTarget(scene, a.type, std::nullopt);
            setVisibleTarget(scene, a.type, instanceNumber(scene, a.type, a.visible));
          }),
      editRow<MeetTargets>("Lets cuts leave as many instances as are to be seen of all types that have such a number.",
                           "model.meetTargets 1920x1080", "Meet numbers to be seen", meetTargets),
      editRow<LetSee>(
          "Lets cuts leave so many instances of a type that a number of them is seen.", "model.letSee root.capsid 200",
          [](const Scene& scene, const LetSee& a) {
            return fmt::format("Number of {} to be seen", nameAt(scene, a.type));
          },
          letSee),
      editRow<SetDrawn>(
          "Lets cuts leave so many instances of a type or compartment; its number stays when that of its group is set.",
          "model.setDrawn root.capsid 20%",
          [](const Scene& scene, const SetDrawn& a) { return fmt::format("Set number of {}", nameAt(scene, a.type)); },
          setDrawn),
      editRow<LetFollow>(
          "Forgets the numbers of types: they follow those of their group.", "model.letFollow root.capsid",
          [](const Scene& scene, const LetFollow& a) {
            return typesLabel(scene, "Let follow the group:", typeNumbers(scene, a.types));
          },
          [](Scene& scene, const LetFollow& a) {
            typeNumbers(scene, a.types);  // says which are none
            for (const auto& path : a.types) dropTargets(scene, path);
          }),
  };
}

/// What cuts leave, and what stands before a focus.
std::vector<Command> leaveRows() {
  return {
      editRow<LeaveTypes>(
          "Lets a cut leave a share of the instances of types.", "model.leave root.blood 0.25",
          [](const Scene& scene, const LeaveTypes& a) {
            return typesLabel(scene, "Leave of", typeNumbers(scene, a.types));
          },
          [](Scene& scene, const LeaveTypes& a) {
            typeNumbers(scene, a.types);  // says which are none
            for (const auto& path : a.types) {
              setTypeShare(cutOf(scene, a.cut), path, a.share);
              dropTargets(scene, path);
            }
          }),
      editRow<LeaveTypesBy>(
          "Sets how a cut leaves the instances of types.", "model.leaveBy root.blood falloff 20",
          [](const Scene& scene, const LeaveTypesBy& a) {
            return (a.field == "share" ? "Leave of " : "Change " + a.field + " of ") + rowsLabel(scene, a.types);
          },
          leaveBy),
      editRow<LeaveAsAbove>(
          "Lets a cut leave of types what it leaves of the compartment that they are in.",
          "model.leaveAsAbove root.blood",
          [](const Scene& scene, const LeaveAsAbove& a) { return "Leave " + rowsLabel(scene, a.types) + " as above"; },
          [](Scene& scene, const LeaveAsAbove& a) {
            typeNumbers(scene, a.types);  // says which are none
            for (const auto& path : a.types) {
              removeTypeSpare(cutOf(scene, a.cut), path);
              dropTargets(scene, path);
            }
          }),
      editRow<ShowUncut>("Turns all cuts off: no instance is removed.", "model.showUncut", "Show whole",
                         [](Scene& scene, const ShowUncut&) { showWhole(scene); }),
      editRow<ShowUnthinned>("Gives up shares and falloffs: where an instance is decides whether it is drawn.",
                             "model.showUnthinned", "Show cut",
                             [](Scene& scene, const ShowUnthinned&) { showCut(scene); }),
      editRow<KeepInView>(
          "Clears away what hides a type or compartment, or lets it be hidden again.", "model.keepInView root.capsid",
          [](const Scene& scene, const KeepInView& a) {
            std::string name = nameAt(scene, a.type);
            return a.kept ? "Keep " + name + " in view" : "Let " + name + " be hidden";
          },
          [](Scene& scene, const KeepInView& a) {
            std::vector<std::string> told;
            if (a.kept)
              clearTheWay(scene, a.type);
            else
              endKeepInView(scene, a.type);
            if (std::string words = clearingWords(scene); a.kept && !words.empty()) told.push_back(words);
            return told;
          }),
  };
}

}  // namespace

std::vector<Command> modelCommands() {
  std::vector<Command> rows = lookRows();
  for (const auto& more : {numberRows(), leaveRows()}) rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace detail

}  // namespace velum::session
