#pragma once
#include <string>
#include <vector>

#include "render/Counts.h"

namespace velum::session {

/// A type or a compartment with what became of its instances.
struct CountRow {
  std::string path;
  std::string name;
  bool isCompartment = false;
  int depth = 0;  ///< in the tree; the root: 0
  Counts count;
};

/// All compartments and types, as the tree has them: a compartment, its types, the compartments in it.
std::vector<CountRow> countRows(const Model& model, const std::vector<Counts>& types);

/// A line a row: kind, path, name, the numbers of kCountKinds, total. The bars of a picture for tables and plots.
std::string countsCsv(const std::vector<CountRow>& rows);

/// A line an instance: its number over all copies, the path of its type, its kind.
std::string instancesCsv(const Model& model, const render::InstanceBits& bits);

/// The rows as stacked bars, each over its own total: the parts of kCountKinds, with their numbers.
/// @param title  above them
std::string countsSvg(const std::vector<CountRow>& rows, const std::string& title);

}  // namespace velum::session
