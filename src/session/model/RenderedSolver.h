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

/// Lets a handle set a quantity: finds the shares of cuts at which so many instances of a type, or of a compartment,
/// are drawn ([VE] 3, 7). Each instance begins to stay at some share (render::stayingShares); k instances are drawn at
/// a share above the k-th smallest of these. The solver puts the share midway between the k-th smallest and the next
/// one, so that rounding changes nothing.
///
/// To be made when a handle is taken hold of, and asked at every step of the pointer. Several cuts get the same share.
/// The number for a compartment is split among its types by splitAmong(): none gets more when it goes down. Types and
/// compartments within it whose numbers a hand has set (scene::ModelLayer::targets) keep what is drawn of them; where
/// the number is too small for that they go down, too, in proportion, and their numbers with them. Instances that cuts
/// clear for a view count as removed, unless the handle sets the share of just these (DialField::ViewShare). Any
/// thread; all cores.
class RenderedSolver {
 public:
  /// @param cuts  ids of the cuts whose shares are set; where none of them is enabled, nothing can be changed
  /// @param path  of a type or compartment, see typesAt()
  /// @param aspect  width by height of the picture; only views onto a focus depend on the aspect
  /// @throw InputError without a model, or when the model has no such type
  RenderedSolver(const scene::Scene& scene, std::vector<int> cuts, std::string_view path,
                 const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect,
                 DialField field = DialField::Share);
  /// A solver for the handle of a bar, where nobody says which cuts are set. Instances in the regions of cuts go first
  /// and come back last; only below the number of instances that lie outside of all regions, a cut that is everywhere
  /// thins the rest. Where there is no such cut, one is added. So one motion of the handle goes from all to none of a
  /// type, whatever cuts there are.
  static RenderedSolver ofAllCuts(const scene::Scene& scene, std::string_view path,
                                  const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect);
  ~RenderedSolver();
  RenderedSolver(RenderedSolver&&) noexcept;
  RenderedSolver& operator=(RenderedSolver&&) noexcept;

  /// The whole path of the type or compartment.
  const std::string& path() const;
  CountRange range() const;
  /// The scene with the shares at which so many instances are drawn, or the nearest number that is possible: each of
  /// the cuts gets a row of its own for the path of each type. The instances are counted by render::keptInstances(),
  /// which also decides where shares lie close to each other. @param wanted  rounded, and brought into the range
  Solved solve(double wanted) const;

 private:
  struct Part;
  struct Impl;
  explicit RenderedSolver(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> mImpl;
};

/// RenderedSolver::solve() for a single number.
Solved solveRendered(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                     const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect);

}  // namespace velum::session
