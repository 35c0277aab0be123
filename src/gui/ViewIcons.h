#pragma once
#include <QIcon>

namespace velum::gui {

enum class ViewIcon { FourUp, Volume, VolumeAndSlice, Slice, Maximise, Restore, Menu };

/// Small pictures of layouts, painted in the palette's text colour so that they suit every theme and pixel density.
QIcon makeViewIcon(ViewIcon icon);

}  // namespace velum::gui
