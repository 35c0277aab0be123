#pragma once
#include <QString>
#include <string_view>

namespace velum::gui {

/// UTF-8 as Qt's text.
inline QString toText(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }

}  // namespace velum::gui
