#pragma once
#include <QColor>
#include <QIcon>

namespace velum::gui {

/// An icon of the program by its name: resources/icons/NAME.svg. Commands have theirs by their id. They are drawn in
/// two tones, currentColor and #5fb0ea, that stand for the text colour and the accent of the theme there is when they
/// are painted.
/// @param color  for both tones instead, of what stands over pictures
QIcon makeIcon(const QString& name, const QColor& color = {});

}  // namespace velum::gui
