#pragma once
#include <QString>
#include <string_view>

#include "core/Links.h"

namespace velum::gui {

/// UTF-8 as Qt's text.
inline QString toText(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

/// A text of a file as it is shown: links are their words.
inline QString readableText(std::string_view text) { return toText(withoutLinks(text)); }

/// The name of a type or compartment of a model as it is shown.
inline QString nameText(std::string_view name) { return readableText(name).replace('_', ' '); }

}  // namespace velum::gui
