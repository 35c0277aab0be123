#pragma once
#include <string>
#include <string_view>

#include "session/model/ModelEdit.h"

namespace velum::session {

/// A type, or a compartment with all types below it.
struct TypesAt {
  std::string path;   ///< the whole path
  TypeNumbers types;  ///< ascending; several types with the same path count as one
  bool isCompartment = false;
};

/// The type or compartment that people mean by a name: a path ("root.capsid.surface.CA"), or as much of the path's end
/// as no other path has ("CA"). @throw InputError when nothing has the name, with the nearest path, or when several
/// have it
TypesAt typesAt(const Model& model, std::string_view name);

/// The path of the type or compartment that is most likely meant by a name that none has; empty: none is near.
std::string nearestPath(const Model& model, std::string_view name);

/// The last name of a path: "CA".
std::string_view shortName(std::string_view path);

}  // namespace velum::session
