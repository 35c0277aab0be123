#pragma once
#include <string>
#include <string_view>

namespace velum {

/// The text as people read it: of a link the words under which it stands ("[text](url)", "<a href=...>text</a>"; of a
/// link without words the address), without tags of HTML, and with the letters that &amp; and the like stand for. What
/// is no link stays, such as the brackets in the name of a chemical.
std::string withoutLinks(std::string_view text);

}  // namespace velum
