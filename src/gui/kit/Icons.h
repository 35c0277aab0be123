#pragma once
#include <QColor>
#include <QIcon>

namespace velum::gui {

/// An icon of the program by its name: resources/icons/NAME.svg. A command's icon has the command's id as its name.
/// Icons are drawn in two tones, currentColor and #5fb0ea, which stand for the text colour and the accent of the theme
/// that is in use when the icon is painted. @param color  takes the place of both tones, for icons over pictures;
/// invalid: the theme's colours
QIcon makeIcon(const QString& name, const QColor& color = {});

}  // namespace velum::gui
