#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/SheetIndices.h"
#include "scene/Scene.h"
#include "session/bar/Dial.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

/// Which number of a scene::TypeSpare a handle sets: the share of what lies in the cut's region, or the share of what
/// hides the cut's focus.
enum class DialField { Share, ViewShare };

/// The dial of one type path in some cuts: what its number, one and the same in these cuts, does; thresholds are from 0
/// to 1.
struct TypeDial : Dial {
  std::string path;
  TypeNumbers types;      ///< all types that have this path
  std::uint64_t now = 0;  ///< how many of the candidates stayed in the scene that the dial was made for
};

/// True when some cut that is on keeps something in view.
bool hasFocus(const scene::Scene& scene);
/// True when one of these cuts is on and keeps something else than these types in view: the cut then clears the types
/// where they hide its focus.
bool isCleared(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types);
/// A dial for each path of some types, in the order of the types.
std::vector<TypeDial> makeDials(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types,
                                DialField field, const render::SheetIndices& sheets, double aspect);

/// The range of all dials together.
CountRange rangeOf(const std::vector<TypeDial>& dials);

/// How many candidates of each dial are to stay where `count` of all candidates are. Where these are fewer than stay
/// now, each dial goes down in proportion to what it has; where they are more, each goes up in proportion to what it
/// lacks. So no type gets more when the number of its compartment goes down, and none fewer when it goes up.
std::vector<std::uint64_t> splitAmong(const std::vector<TypeDial>& dials, std::uint64_t count);

/// A number of a dial, and how many candidates stay with it.
struct DialSetting {
  double number = 0.0;
  std::uint64_t staying = 0;
};
DialSetting settingFor(const Dial& dial, std::uint64_t staying);

/// Sets the number of a path in cuts that are on; a row that a cut does not have is made from what holds for the path
/// there.
void setDial(scene::Scene& scene, const std::vector<int>& cuts, const std::string& path, DialField field,
             double number);

/// Sets the numbers of all dials so that `count` of their candidates stay, counted by render::keptInstances().
/// @param field  the number that the dials are for  @return how many instances of the dials' types are drawn then
std::uint64_t turnDials(scene::Scene& scene, const std::vector<int>& cuts, const std::vector<TypeDial>& dials,
                        DialField field, std::uint64_t count, const render::SheetIndices& sheets, double aspect);

/// How many instances of these types are drawn.
std::uint64_t countRendered(const scene::Scene& scene, const TypeNumbers& types, const render::SheetIndices& sheets,
                            double aspect);

}  // namespace velum::session
