#include "scene/PlateStyles.h"

#include "scene/NamedTable.h"

namespace velum::scene {

namespace {

/// What a style sets of lettering, under the names there.
struct PlateStyleRow {
  PlateStyle style;
  double pageWidth = 0.0, textPoints = 7.0, linePoints = 0.75;
  Typeface typeface = Typeface::Sans;
  bool bold = false;
  std::optional<glm::vec3> color = {};
  double halo = 1.0;
};

/// Letters on the page are as publishers ask for: 5 to 8 points in figures, 9 to 10 in plates of a book, 18 and more on
/// what is read from a distance.
const NamedTable<PlateStyleRow, PlateStyle>& plateStyleTable() {
  static const PlateStyleRow kTable[] = {
      {.style = {"screen", "Screen", "Sizes go with the picture's rows; no page"}},
      {.style = {"journal", "Journal", "A figure of a journal: 7 point letters without serifs, fine lines"},
       .pageWidth = 174.0},
      {.style = {"atlas", "Atlas", "A plate of a book: letters with serifs, hairlines, little halo"},
       .pageWidth = 210.0,
       .textPoints = 9.0,
       .linePoints = 0.5,
       .typeface = Typeface::Serif,
       .halo = 0.6},
      {.style = {"blackboard", "Blackboard", "Light and large, for dark grounds and talks"},
       .pageWidth = 254.0,
       .textPoints = 18.0,
       .linePoints = 1.5,
       .color = glm::vec3(1.0f)},
      {.style = {"poster", "Poster", "Heavy letters that are read from two metres"},
       .pageWidth = 400.0,
       .textPoints = 24.0,
       .linePoints = 2.0,
       .bold = true},
  };
  static const NamedTable all("style of lettering", std::span<const PlateStyleRow>(kTable), &PlateStyleRow::style);
  return all;
}

Lettering styled(Lettering lettering, const PlateStyleRow& row) {
  bool keepsPage = row.pageWidth > 0.0 && lettering.pageWidth > 0.0;
  if (!keepsPage) lettering.pageWidth = row.pageWidth;
  lettering.textPoints = row.textPoints;
  lettering.linePoints = row.linePoints;
  lettering.typeface = row.typeface;
  lettering.bold = row.bold;
  lettering.color = row.color;
  lettering.halo = row.halo;
  return lettering;
}

}  // namespace

std::span<const PlateStyle> plateStyles() { return plateStyleTable().names(); }

void applyPlateStyle(Lettering& lettering, std::string_view name) {
  lettering = styled(lettering, plateStyleTable().at(name));
}

std::string_view plateStyleName(const Lettering& lettering) {
  for (const PlateStyleRow& row : plateStyleTable().rows())
    if (styled(lettering, row) == lettering) return row.style.name;
  return {};
}

}  // namespace velum::scene
