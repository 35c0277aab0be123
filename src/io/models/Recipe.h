#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/models/ModelParts.h"

namespace velum::io {

/// A type of a serialized recipe of cellPACKgpu.
struct RecipeIngredient {
  std::int64_t id = 0;
  std::vector<std::string> path;  ///< Path of its compartment.
  std::string type, structure, description;
  bool hasCopies = false;
  float radius = 50.0f;  ///< Radius of a ball around the ingredient.
  double mass = 0.0;     ///< 0: unknown
};

/// The types of a recipe; nothing where the text is not a recipe. @throw InputError for a recipe that is damaged
std::optional<std::vector<RecipeIngredient>> parseRecipe(const std::string& text, const Path& path);
bool looksLikeRecipe(std::string_view head);

/// The recipe that lies beside a packing: the one with the packing's name, else the only one whose name begins like the
/// packing's.
std::optional<std::vector<RecipeIngredient>> recipeBeside(const Path& packing);
std::optional<Path> recipePathBeside(const Path& packing);

}  // namespace velum::io
