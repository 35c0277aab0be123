#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/Counts.h"
#include "session/model/RenderedSolver.h"

namespace velum::session {

/// The most pictures that are looked at before the best result so far is taken: for one target, and for several at
/// once.
constexpr int kMostPicturesOfOne = 12;
constexpr int kMostPictures = 24;

/// How close a result comes to one target.
struct TargetReport {
  std::string path;
  std::optional<std::uint64_t> wantedRendered, wantedVisible;
  std::uint64_t rendered = 0, total = 0;
  std::optional<std::uint64_t> visible;  ///< none: no picture was asked for
  bool isMet = false;
  std::string words;  ///< one short sentence for people: what was reached, and where the target is not met, why
  bool operator==(const TargetReport&) const = default;
};

/// How close a result comes to all targets.
struct TargetsReport {
  scene::Scene scene;  ///< with the shares set
  std::vector<TargetReport> targets;
  int pictures = 0;  ///< how many pictures were looked at
  /// By how many instances the numbers reached are off the numbers wanted, all targets together.
  std::uint64_t residual = 0;
};

/// Sets the shares of cuts so that wanted numbers of instances are drawn, or show, of several types and compartments at
/// once.
///
/// Numbers of drawn instances are met exactly, as by RenderedSolver. How many instances show is known only from
/// pictures, which the caller draws: each round sets all shares anew by what one picture says of each instance. The
/// instances of a type come in a fixed order; which of them showed in the last pictures says how many must be drawn for
/// so many to show. What other instances hide or uncover meanwhile is made up for in the next round. The best round is
/// the result. Where a cut keeps something in view and a type hides it, the share of the type's instances that stay in
/// the way (the view share) is set; where too many still show without them, or at once where that share changes
/// nothing, the share of all its instances in the region is set. A type that has a target of its own does not count
/// among the types that its compartment's target moves.
///
/// A window asks for pictures as they come: next(), take(), next() ... @throw InputError as of typesAt(). Any thread.
class TargetSolver {
 public:
  /// @param cuts  ids of the cuts whose shares are set, see RenderedSolver; of cuts with regions and cuts that are
  /// everywhere the former take away first  @param aspect  of the pictures, width by
  /// height
  TargetSolver(const scene::Scene& scene, std::vector<int> cuts, const std::vector<scene::TypeTarget>& targets,
               const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect,
               int mostPictures = kMostPictures);
  ~TargetSolver();
  TargetSolver(TargetSolver&&) noexcept;
  TargetSolver& operator=(TargetSolver&&) noexcept;

  /// The scene of which the solver needs a picture; null: the solver is done. Without targets of what shows it is done
  /// at once.
  const scene::Scene* next() const;
  /// Takes what became of the instances in a picture of the scene of next().
  void take(const render::InstanceBits& bits);
  /// The best result so far.
  TargetsReport report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> mImpl;
};

/// Draws a scene and says what became of its model's instances.
using CountPicture = std::function<render::InstanceBits(const scene::Scene&)>;

/// Runs a TargetSolver to its end. @param picture  draws the pictures
TargetsReport solveTargets(const scene::Scene& scene, const std::vector<int>& cuts,
                           const std::vector<scene::TypeTarget>& targets, const CountPicture& picture,
                           const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect,
                           int mostPictures = kMostPictures);

/// The same by all cuts that are on: what lies in their regions goes first and comes back last, and where that is not
/// enough, a cut that is everywhere thins the rest; where there is none, one is added to the result's scene.
TargetsReport solveTargets(const scene::Scene& scene, const std::vector<scene::TypeTarget>& targets,
                           const CountPicture& picture, const render::SheetIndices& sheets = {},
                           double aspect = render::kUsualAspect, int mostPictures = kMostPictures);

/// The scene in which so many instances of a type or compartment show, or the nearest number that was found in
/// kMostPicturesOfOne pictures. Numbers that hands have set within the compartment stay. @param cuts  none: all that
/// are on, as above
Solved solveVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                    const CountPicture& picture, const render::SheetIndices& sheets = {},
                    double aspect = render::kUsualAspect);

/// Adds a cut that is everywhere and removes nothing until shares say so. @return its id
int addCutEverywhere(scene::Scene& scene);

}  // namespace velum::session
