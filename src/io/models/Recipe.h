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
  std::vector<std::string> path;  ///< Of its compartment.
  std::string type, structure, description;
  bool hasCopies = false;
  float radius = 50.0f;  ///< Of a ball around it.
  double mass = 0.0;     ///< 0: unknown
};

/// The types of a recipe; nothing where the text is no recipe. @throw InputError for one that is damaged
std::optional<std::vector<RecipeIngredient>> parseRecipe(const std::string& text, const Path& path);
bool looksLikeRecipe(std::string_view head);

/// The recipe of a packing: the one of its name, else the only one whose name begins as its does.
std::optional<std::vector<RecipeIngredient>> recipeBeside(const Path& packing);
std::optional<Path> recipePathBeside(const Path& packing);

}  // namespace velum::io
