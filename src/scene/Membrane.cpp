#include "scene/Membrane.h"

namespace velum::scene {

double strengthOf(const ForceField& field, std::string_view path) {
  const TypeStrength* nearest = nullptr;
  for (const TypeStrength& one : field.byType) {
    bool leads = path.starts_with(one.path) && (path.size() == one.path.size() || path[one.path.size()] == '.');
    if (leads && (!nearest || one.path.size() >= nearest->path.size())) nearest = &one;
  }
  return nearest ? nearest->strength : 0.0;
}

}  // namespace velum::scene
