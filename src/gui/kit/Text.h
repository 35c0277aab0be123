#pragma once
#include <QString>
#include <string_view>

#include "core/Links.h"
#include "scene/ModelLayer.h"

namespace velum::gui {

/// UTF-8 as Qt's text.
inline QString toText(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

/// A text of a file as it is shown: links are their words.
inline QString readableText(std::string_view text) { return toText(withoutLinks(text)); }

/// The name of a type of a layer's model as it is shown. @param type  in Model::types
inline QString typeText(const scene::ModelLayer& layer, std::uint32_t type) {
  const MoleculeType& of = layer.data->types[type];
  return toText(scene::shownName(layer, pathOf(*layer.data, of), of.name));
}

/// The name of a type or compartment of a model as a file has it, as it is shown.
inline QString nameText(std::string_view name) { return readableText(name).replace('_', ' '); }

}  // namespace velum::gui
