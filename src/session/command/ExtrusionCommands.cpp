#include "session/command/ExtrusionCommands.h"

#include "session/command/CommandRow.h"
#include "session/command/CutCommands.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/Pull.h"
#include "session/structure/StructureEdit.h"

namespace velum::session::detail {

namespace {

using scene::Scene;

void putBack(Scene& scene, const PutBack& a) {
  std::vector<int> ids = structureIds(scene, a.structures);
  int only = a.cut.empty() ? 0 : cutOf(std::as_const(scene), a.cut).id;
  for (auto& cut : scene.cuts)
    for (int id : ids)
      if ((only == 0 || cut.id == only) && extrusionOf(cut, id) > 0.0) setExtrusion(cut, id, 0.0);
}

}  // namespace

std::vector<Command> extrusionCommands() {
  return {
      editRow<PullStructure>(
          "Pulls a structure out of a cut.", "extrusion.pull aorta 40",
          [](const Scene& scene, const PullStructure& a) {
            return structureLabel(scene, "Pull out", structureIds(scene, {a.structure}));
          },
          [](Scene& scene, const PullStructure& a) {
            Extrusion wanted{cutOf(std::as_const(scene), a.cut).id, structureIds(scene, {a.structure})[0], 0.0};
            pullTo(scene, pullAgain(scene, wanted), a.distance);
          }),
      editRow<PutBack>(
          "Puts back what stands out.", "extrusion.putBack aorta",
          [](const Scene& scene, const PutBack& a) {
            return structureLabel(scene, "Put back", structureIds(scene, a.structures));
          },
          putBack),
      editRow<PutAllBack>("Puts back all that stands out.", "extrusion.putAllBack", "Put all back",
                          [](Scene& scene, const PutAllBack&) { resetExtrusions(scene); }),
      editRow<AddJoinedPlane>("Adds a second plane across one, so that the two open a wedge.", "extrusion.addPlane",
                              "Second plane",
                              [](Scene& scene, const AddJoinedPlane& a) {
                                if (!addJoinedPlane(scene, cutOf(std::as_const(scene), a.cut).id))
                                  throw ArgumentError("the cut is no plane, or there is no room for another");
                              }),
  };
}

}  // namespace velum::session::detail
