#pragma once
#include <string>
#include <vector>

#include "render/Counts.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A type or a compartment with what became of its instances.
struct CountRow {
  std::string path;
  std::string name;
  bool isCompartment = false;
  int depth = 0;  ///< in the tree; the root: 0
  Counts count;
};

/// Rows for all compartments and types of a layer's model, in the order of the tree: a compartment, its types, the
/// compartments in it. They have the names that the author gave, else the file's.
std::vector<CountRow> countRows(const scene::ModelLayer& layer, const std::vector<Counts>& types);

/// One line for each row: kind, path, name, the numbers of kCountKinds, total. The bars of a picture for tables and
/// plots.
std::string countsCsv(const std::vector<CountRow>& rows);

/// One line for each instance: its number over all copies, the path of its type, what became of it.
std::string instancesCsv(const Model& model, const render::InstanceBits& bits);

/// The rows as stacked bars, each bar over the row's own total: the parts of kCountKinds, with their numbers.
/// @param title  stands above the bars
std::string countsSvg(const std::vector<CountRow>& rows, const std::string& title);

}  // namespace velum::session
