#pragma once
#include <string>
#include <string_view>

#include "session/model/ModelEdit.h"

namespace velum::session {

/// A type, or a compartment with all types below it.
struct TypesAt {
  std::string path;   ///< the whole of it
  TypeNumbers types;  ///< ascending; several of one path count as one
  bool isCompartment = false;
};

/// What people mean by a name: a path ("root.capsid.surface.CA"), or as much of its end as only one has ("CA").
/// @throw InputError when nothing has it, with what is nearest, or when several have
TypesAt typesAt(const Model& model, std::string_view name);

/// The path of the type, or else of the compartment, that most likely is meant by a name that none has; empty: none is
/// near.
std::string nearestPath(const Model& model, std::string_view name);

/// A path without what leads to it: "CA".
std::string_view shortName(std::string_view path);

}  // namespace velum::session
