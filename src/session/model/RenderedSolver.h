#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/SheetIndices.h"
#include "render/kept/KeptInstances.h"
#include "scene/Scene.h"
#include "session/bar/Dial.h"
#include "session/model/TypeDials.h"

namespace velum::session {

/// The ids of all enabled cuts.
std::vector<int> enabledCuts(const scene::Scene& scene);

/// What makes a handle set a quantity: the shares of cuts at which so many instances of a type, or of a compartment,
/// are drawn ([VE] 3, 7). The k-th smallest of the shares at which its instances begin to stay (render::stayingShares)
/// has k of them below it; the share is put midway to the next one, so that rounding changes nothing.
///
/// To be made when a handle is taken hold of, and asked at every step of the pointer. Several cuts share one number. A
/// compartment's is given to its types in proportion to what each can have, by largest remainders. What cuts clear for
/// a view counts as taken, where the handle does not set just that. Any thread; all cores.
class RenderedSolver {
 public:
  /// @param cuts  the ids of those whose shares are set; none that is enabled: nothing can be changed
  /// @param path  of a type or compartment, see typesAt()
  /// @param aspect  width by height of the picture; only views onto a focus depend on it
  /// @throw InputError without a model, or when it has no such type
  RenderedSolver(const scene::Scene& scene, std::vector<int> cuts, std::string_view path,
                 const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect,
                 DialField field = DialField::Share);
  /// What the handle of a bar sets where nobody says which cuts: what lies in the regions of cuts goes first and comes
  /// back last, and only below what lies outside of all of them a cut that is everywhere thins the rest. It is added
  /// where there is none. So one motion goes from all to none of a type, whatever cuts there are.
  static RenderedSolver ofAllCuts(const scene::Scene& scene, std::string_view path,
                                  const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect);
  ~RenderedSolver();
  RenderedSolver(RenderedSolver&&) noexcept;
  RenderedSolver& operator=(RenderedSolver&&) noexcept;

  const std::string& path() const;
  CountRange range() const;
  /// The scene with a row for exactly each path in each of the cuts, of shares at which so many are drawn, or the
  /// nearest number to it that can be; told by render::keptInstances(), which also has the last word where shares lie
  /// close to each other. @param wanted  rounded, and brought into the range
  Solved solve(double wanted) const;

 private:
  struct Part;
  struct Impl;
  explicit RenderedSolver(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> mImpl;
};

/// The same for one number.
Solved solveRendered(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                     const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect);

}  // namespace velum::session
