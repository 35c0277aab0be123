#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "render/SheetIndices.h"
#include "session/model/ModelEdit.h"
#include "session/model/RenderedSolver.h"

namespace velum::session {

/// An instance about which the number decides: it stays where the number is above this.
struct Candidate {
  float from = 0.0f;           ///< 0 to before 1
  std::uint32_t instance = 0;  ///< over all copies
};

/// What the number of one path in some cuts does.
struct Dial {
  std::string path;
  TypeNumbers types;                  ///< those of this path
  std::uint64_t always = 0;           ///< instances that are drawn whatever it is
  std::uint64_t total = 0;            ///< that the model has
  std::vector<Candidate> candidates;  ///< in no order
};

/// Some cut that is on keeps something in view.
bool hasFocus(const scene::Scene& scene);
/// A dial for each path of some types, in the order of the types.
std::vector<Dial> makeDials(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types,
                            DialField field, const render::SheetIndices& sheets, double aspect);

CountRange rangeOf(const std::vector<Dial>& dials);

/// How many candidates of each dial stay, where `count` of all are to: in proportion to how many each has, by largest
/// remainders.
std::vector<std::uint64_t> splitAmong(const std::vector<Dial>& dials, std::uint64_t count);

/// A number at which so many candidates stay, or the nearest number of them where several begin to stay at once.
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
std::uint64_t turnDials(scene::Scene& scene, const std::vector<int>& cuts, const std::vector<Dial>& dials,
                        DialField field, std::uint64_t count, const render::SheetIndices& sheets, double aspect);

/// Instances of these types that are drawn.
std::uint64_t countRendered(const scene::Scene& scene, const TypeNumbers& types, const render::SheetIndices& sheets,
                            double aspect);

/// For people: "12,345".
std::string countText(std::uint64_t count);

}  // namespace velum::session
