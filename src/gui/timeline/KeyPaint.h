#pragma once
#include <QIcon>
#include <QPainterPath>
#include <QPalette>
#include <QString>

#include "scene/Timeline.h"

namespace velum::gui {

/// How the ways from a key to the next one look and what they are called.

/// The outline of a key about the origin: a square for hold, a diamond for linear, triangles for in and out, a hexagon
/// for both, round for smooth. @param radius  pixels
QPainterPath keyShape(scene::Ease ease, double radius);
/// A picture of the way from a key to the next one, for menus; smooth passes one between.
QIcon easeIcon(scene::Ease ease, const QPalette& palette);
/// "Linear", for menus; and what it means.
QString easeName(scene::Ease ease);
QString easeMeaning(scene::Ease ease);

}  // namespace velum::gui
