#include "gui/mark/MarkKinds.h"

#include <QtGlobal>
#include <iterator>

namespace velum::gui {

namespace {

using scene::MarkKind;

constexpr MarkKindRow kMarkRows[] = {
    {MarkKind::Distance, "mark.distance", QT_TRANSLATE_NOOP("Words", "&Distance"),
     QT_TRANSLATE_NOOP("Words", "Measure a distance: click two points, in the picture or on sections"),
     "M -6 4 L 6 -4 M -7.5 1.7 L -4.5 6.3 M 4.5 -6.3 L 7.5 -1.7"},
    {MarkKind::Angle, "mark.angle", QT_TRANSLATE_NOOP("Words", "&Angle"),
     QT_TRANSLATE_NOOP("Words", "Measure an angle: click three points, the second is where its legs meet"),
     "M 5 -6 L -6 5 L 7 5 M -1.5 0.5 C 0.3 1.8 0.8 3 1 5"},
    {MarkKind::Path, "mark.path", QT_TRANSLATE_NOOP("Words", "&Path"),
     QT_TRANSLATE_NOOP("Words", "Measure a way along points; a double click or Enter ends it"),
     "M -7 4 L -3 -4 L 2 2 L 7 -5"},
    {MarkKind::Area, "mark.area", QT_TRANSLATE_NOOP("Words", "A&rea"),
     QT_TRANSLATE_NOOP("Words", "Measure the area within points; a double click or Enter ends it"),
     "M -6 5 L -5 -4 L 2 -6 L 7 0 L 3 5.5 Z"},
    {MarkKind::Arrow, "mark.arrow", QT_TRANSLATE_NOOP("Words", "Arro&w"),
     QT_TRANSLATE_NOOP("Words", "Point at something: click where the arrow begins, then its head"),
     "M -6 6 L 6 -6 M 0 -6 L 6 -6 L 6 0"},
    {MarkKind::Label, "mark.label", QT_TRANSLATE_NOOP("Words", "&Label"),
     QT_TRANSLATE_NOOP("Words", "Write words beside a place: click it, then type"),
     "M -5 -6 L 5 -6 M 0 -6 L 0 6 M -2 6 L 2 6"},
    {MarkKind::Name, "mark.name", QT_TRANSLATE_NOOP("Words", "&Name"),
     QT_TRANSLATE_NOOP("Words", "Name structures and molecules: click them"),
     "M -7 -4 L 2 -4 L 7 0 L 2 4 L -7 4 Z O 2.5 0 1 1"},
    {MarkKind::Circle, "mark.circle", QT_TRANSLATE_NOOP("Words", "&Circle"),
     QT_TRANSLATE_NOOP("Words", "Values in a ball: click its middle, then its rim"), "O 0 0 6.5 6.5 M 0 0 L 6.5 0"},
    {MarkKind::Box, "mark.box", QT_TRANSLATE_NOOP("Words", "&Box"),
     QT_TRANSLATE_NOOP("Words", "Values in a box along the volume's axes: click two corners"),
     "M -6 -5 L 6 -5 L 6 5 L -6 5 Z"},
    {MarkKind::Region, nullptr, nullptr, nullptr, "M -5 1 C -6 -6 1 -7 4 -4 C 8 0 5 6 0 5 C -3 5 -5 4 -5 1 Z"},
    {MarkKind::Profile, "mark.profile", QT_TRANSLATE_NOOP("Words", "Pro&file"),
     QT_TRANSLATE_NOOP("Words", "Values along a line: click its two ends"),
     "M -7 5 L 7 5 M -7 2 L -3 1 L 0 -6 L 3 0 L 7 -1"},
};
static_assert(std::size(kMarkRows) == std::size(EnumNames<MarkKind>::kNames), "each kind has its row");

}  // namespace

std::span<const MarkKindRow> markKinds() { return kMarkRows; }

const MarkKindRow& rowOf(MarkKind kind) { return kMarkRows[static_cast<std::size_t>(kind)]; }

}  // namespace velum::gui
