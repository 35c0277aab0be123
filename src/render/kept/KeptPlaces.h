#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// How far a place is from where the cuts together begin to remove a structure.
struct KeptDistance {
  double distance = 1e30;  ///< scene units; below 0: the place is removed
  int cut = 0;             ///< id of the cut whose face is next; 0: none is
};

/// Tells of single places whether the cuts of a scene leave what is there: decided by the same functions as in drawing.
/// Sheets of membranes are as their shapes in the scene say. Any thread; made in a few milliseconds.
class KeptPlaces {
 public:
  /// @param middle  near the places that will be asked, so that floats are precise; world
  explicit KeptPlaces(const scene::Scene& scene, glm::dvec3 middle, const SheetIndices& sheets = {});
  ~KeptPlaces();
  KeptPlaces(KeptPlaces&&) noexcept;

  /// No cut is on: everything is left.
  bool isEmpty() const;
  bool keeps(glm::dvec3 world, std::uint16_t structure) const { return distance(world, structure).distance >= 0.0; }
  /// Exact in sign, and in size near faces. Of membranes that are steep the size may be too large further away.
  KeptDistance distance(glm::dvec3 world, std::uint16_t structure) const;
  /// Some cut is a membrane.
  bool hasSheets() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> mParts;
};

}  // namespace velum::render
