#pragma once
#include <QIcon>

namespace velum::gui {

enum class ViewIcon { FourUp, Volume, VolumeAndSection, Section, Maximise, Restore, Menu };

/// Small pictures of layouts, for every pixel density.
/// @param color  what they are painted in; an invalid one: the palette's text colour, so that they suit every theme
QIcon makeViewIcon(ViewIcon icon, const QColor& color = {});

}  // namespace velum::gui
