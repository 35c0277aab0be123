#pragma once
#include <span>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"
#include "vector/Drawing.h"
#include "vector/TraceSteps.h"

namespace velum::session {

/// Whose a line is, by names for people.
struct Owner {
  std::string group;  ///< the compartment of a type, "capsid / surface"; empty: none
  std::string name;   ///< of a structure or type
  auto operator<=>(const Owner&) const = default;
};

/// @param structure  id  @param type  of the scene's model; below 0: what is seen is none of it
Owner ownerOf(const scene::Scene& scene, int structure, int type);

/// Strokes of one owner and one width together, owners of a group one after the other.
/// @param owners  by id - 1 of strokes  @param widest  width of a stroke of strength 1, pixels  @param least  of any:
/// what is finer is as wide, and as much fainter
std::vector<vector::Item> itemsOf(std::vector<vector::Stroke> strokes, std::span<const Owner> owners,
                                  const vector::Pen& pen, double widest, double least);

}  // namespace velum::session
