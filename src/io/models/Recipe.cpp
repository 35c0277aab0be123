#include "io/models/Recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/FileName.h"
#include "core/Text.h"
#include "io/read/JsonParts.h"
#include "io/read/ByteSource.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {

constexpr int kMostDepth = 64;

double numberOr(const Json& value, double other) {
  return value.is_number() && std::abs(value.get<double>()) < 1e12 ? value.get<double>() : other;
}

void gather(const Json& node, std::vector<std::string> path, std::vector<RecipeIngredient>& all, const Path& file,
            int depth) {
  if (depth > kMostDepth) refuse(file, "has compartments within compartments without end");
  const Json& groups = memberOf(node, "IngredientGroups");
  if (groups.is_array())
    for (const Json& group : groups) {
      std::vector<std::string> within = path;
      if (std::string name = wordOf(memberOf(group, "name")); !name.empty()) within.push_back(name);
      const Json& ingredients = memberOf(group, "Ingredients");
      if (!ingredients.is_array()) continue;
      for (const Json& json : ingredients) {
        RecipeIngredient ingredient{.id = std::int64_t(numberOr(memberOf(json, "ingredient_id"), -1.0)),
                                    .path = within};
        ingredient.type = wordOf(memberOf(json, "name"));
        ingredient.structure = wordOf(memberOf(memberOf(json, "source"), "pdb"));
        ingredient.description = wordOf(memberOf(json, "description"));
        ingredient.hasCopies = isTrue(memberOf(memberOf(json, "source"), "biomt"));
        ingredient.radius = float(std::clamp(numberOr(memberOf(json, "encapsulatingRadius"), 50.0), 1.0, 1e4));
        ingredient.mass = numberOr(memberOf(json, "molecularweight"), 0.0);
        all.push_back(std::move(ingredient));
      }
    }
  const Json& compartments = memberOf(node, "Compartments");
  if (!compartments.is_array()) return;
  for (const Json& child : compartments) {
    std::vector<std::string> within = path;
    if (std::string name = wordOf(memberOf(child, "name")); !name.empty()) within.push_back(name);
    gather(child, std::move(within), all, file, depth + 1);
  }
}

}  // namespace

bool looksLikeRecipe(std::string_view head) {
  return head.find("\"Compartments\"") != std::string_view::npos ||
         head.find("\"IngredientGroups\"") != std::string_view::npos;
}

std::optional<std::vector<RecipeIngredient>> parseRecipe(const std::string& text, const Path& path) {
  if (!looksLikeRecipe(text)) return std::nullopt;
  std::vector<RecipeIngredient> all;
  gather(parseJson(text, path), {}, all, path, 0);
  return all;
}

std::optional<Path> recipePathBeside(const Path& packing) {
  Path folder = std::filesystem::absolute(packing).parent_path();
  std::string own = lowerCase(titleOf(packing));
  std::optional<Path> best;
  std::size_t most = 0;
  for (const Path& file : filesInOrder(folder)) {
    if (lowerExtension(file) != ".json") continue;
    std::string name = lowerCase(titleOf(file));
    std::size_t alike = 0;
    while (alike < std::min(name.size(), own.size()) && name[alike] == own[alike]) ++alike;
    // "cytoplasm_low" and "cytoplasme": so much at least is not by chance.
    if (alike <= most || alike < 4 || !looksLikeRecipe(readHead(file, 1 << 16))) continue;
    most = alike;
    best = file;
  }
  return best;
}

std::optional<std::vector<RecipeIngredient>> recipeBeside(const Path& packing) {
  auto file = recipePathBeside(packing);
  return file ? parseRecipe(textOf(*file), *file) : std::nullopt;
}

}  // namespace velum::io
