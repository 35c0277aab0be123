#pragma once
#include <span>
#include <string_view>

#include "scene/Lettering.h"

namespace velum::scene {

/// A style of lettering by name: its letters, lines, colours and page.
struct PlateStyle {
  std::string_view name;   ///< "journal"
  std::string_view title;  ///< "Journal"
  std::string_view tip;    ///< what it is for, for people
};

/// Every style, in the order of the window; the first, "screen", is that of a fresh scene.
std::span<const PlateStyle> plateStyles();

/// Gives lettering a style by name: typeface, weight, sizes on the page, colour and halo. A style for print keeps the
/// width of a page that the lettering has already. @throw ArgumentError for an unknown name, listing the known ones
void applyPlateStyle(Lettering& lettering, std::string_view name);

/// The name of the style whose values the lettering has, on whatever width of page; empty when there is none: the user
/// has set the values.
std::string_view plateStyleName(const Lettering& lettering);

}  // namespace velum::scene
