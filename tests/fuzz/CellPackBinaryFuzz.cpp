#include <fstream>

#include "FuzzModel.h"

/// With a sound recipe of two types beside the packing.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static velum::io::FuzzFile file("packing.bin");
  static const bool hasRecipe = [] {
    std::ofstream("packing.json") << R"({"Compartments": [], "IngredientGroups": [{"name": "p", "Ingredients": [
      {"ingredient_id": 0, "name": "a", "source": {"pdb": "x"}}, {"ingredient_id": 1, "name": "b", "source": {}}]}]})";
    return true;
  }();
  velum::io::require(hasRecipe);
  return velum::io::fuzzModel(file, velum::io::readCellPackBinary, data, size);
}
