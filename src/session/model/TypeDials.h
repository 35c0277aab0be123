#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/SheetIndices.h"
#include "scene/Scene.h"
#include "session/bar/Dial.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

/// Which number of a scene::TypeSpare a handle sets: of what lies in the cut's region, or of what hides its focus.
enum class DialField { Share, ViewShare };

/// What the number of one path in some cuts does; of it 0 to 1 are the thresholds.
struct TypeDial : Dial {
  std::string path;
  TypeNumbers types;  ///< those of this path
};

/// Some cut that is on keeps something in view.
bool hasFocus(const scene::Scene& scene);
/// The focus of some of these cuts that are on holds none of the types, so that it clears them where they hide it.
bool isCleared(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types);
/// A dial for each path of some types, in the order of the types.
std::vector<TypeDial> makeDials(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types,
                                DialField field, const render::SheetIndices& sheets, double aspect);

/// Of all together.
CountRange rangeOf(const std::vector<TypeDial>& dials);

/// How many candidates of each dial stay, where `count` of all are to: in proportion to how many each has, by largest
/// remainders.
std::vector<std::uint64_t> splitAmong(const std::vector<TypeDial>& dials, std::uint64_t count);

/// A number at which so many candidates stay, or the nearest number of them, see gapFor().
struct DialSetting {
  double number = 0.0;
  std::uint64_t staying = 0;
};
DialSetting settingFor(const Dial& dial, std::uint64_t staying);

/// Sets the number of a path in cuts; a row that is not there is made from what holds for the path.
void setDial(scene::Scene& scene, const std::vector<int>& cuts, const std::string& path, DialField field,
             double number);

/// Sets the numbers of all dials so that `count` of their candidates stay, told by render::keptInstances().
/// @param field  that the dials are of  @return how many of the dials' instances are drawn then
std::uint64_t turnDials(scene::Scene& scene, const std::vector<int>& cuts, const std::vector<TypeDial>& dials,
                        DialField field, std::uint64_t count, const render::SheetIndices& sheets, double aspect);

/// Instances of these types that are drawn.
std::uint64_t countRendered(const scene::Scene& scene, const TypeNumbers& types, const render::SheetIndices& sheets,
                            double aspect);

}  // namespace velum::session
