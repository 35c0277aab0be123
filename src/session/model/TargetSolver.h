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

/// So many pictures are looked at before the best that was found is taken: of one target, of several at once.
constexpr int kMostPicturesOfOne = 12;
constexpr int kMostPictures = 24;

/// What became of a target.
struct TargetReport {
  std::string path;
  std::optional<std::uint64_t> wantedRendered, wantedVisible;
  std::uint64_t rendered = 0, total = 0;
  std::optional<std::uint64_t> visible;  ///< none: no picture was asked for
  bool isMet = false;
  std::string words;  ///< one short sentence for people: what it came to, and where it is not met, why
  bool operator==(const TargetReport&) const = default;
};

/// What became of all.
struct TargetsReport {
  scene::Scene scene;  ///< with the shares set
  std::vector<TargetReport> targets;
  int pictures = 0;  ///< that were looked at
  /// By how many instances what was reached is off what was wanted, all targets together.
  std::uint64_t residual = 0;
};

/// Sets the shares of cuts so that wanted numbers of instances are drawn, or show, of several types and compartments at
/// once.
///
/// Drawn ones are met exactly, as by RenderedSolver. How many show is known only from pictures, which whoever draws
/// gives: each round sets all numbers anew from what one picture says of each instance. Of a type its instances come in
/// a fixed order, so that those of the last pictures which showed say how many are to be drawn for so many to show;
/// what others hide or uncover meanwhile is made up for in the next round. The best round stands. Where a cut keeps
/// something in view and the type hides it, the share of those that stay in the view is set, and where too many show
/// without them, too, or else at once, that of all in the region. A type that has a target of its own does not count
/// among those that its compartment's target moves.
///
/// A window asks for pictures as they come: next(), take(), next() ... @throw InputError as of typesAt(). Any thread.
class TargetSolver {
 public:
  /// @param cuts  whose shares are set, see RenderedSolver  @param aspect  of the pictures
  TargetSolver(const scene::Scene& scene, std::vector<int> cuts, const std::vector<scene::TypeTarget>& targets,
               const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect,
               int mostPictures = kMostPictures);
  ~TargetSolver();
  TargetSolver(TargetSolver&&) noexcept;
  TargetSolver& operator=(TargetSolver&&) noexcept;

  /// The scene of which it wants to know what shows; null: it is done. Without targets of what shows it is done at
  /// once.
  const scene::Scene* next() const;
  /// What became of the instances in a picture of next().
  void take(const render::InstanceBits& bits);
  /// The best so far.
  TargetsReport report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> mImpl;
};

/// Draws a scene and says what became of its model's instances.
using CountPicture = std::function<render::InstanceBits(const scene::Scene&)>;

/// The same with pictures at hand.
TargetsReport solveTargets(const scene::Scene& scene, const std::vector<int>& cuts,
                           const std::vector<scene::TypeTarget>& targets, const CountPicture& picture,
                           const render::SheetIndices& sheets = {}, double aspect = render::kUsualAspect,
                           int mostPictures = kMostPictures);

/// So many instances of a type or compartment show, or the nearest number that was found in kMostPicturesOfOne
/// pictures.
Solved solveVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                    const CountPicture& picture, const render::SheetIndices& sheets = {},
                    double aspect = render::kUsualAspect);

/// Adds a cut that is everywhere and removes nothing until shares say so. @return its id
int addCutEverywhere(scene::Scene& scene);

/// Adds a cut everywhere, which removes nothing until shares say so, where no cut is on whose share could be set.
/// @return the ids of the cuts that are on
std::vector<int> cutsToSet(scene::Scene& scene);

}  // namespace velum::session
