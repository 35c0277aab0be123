#pragma once
#include <QApplication>
#include <QColor>

namespace velum::gui {

enum class ThemeKind { Dark, Light };

/// Colours of what is drawn over pictures; the same in both themes. Widgets take theirs from the palette: Base the
/// ground of fields, Window of panels, Mid thin lines, Dark edges, PlaceholderText what is said quietly, Link the
/// accent.
inline const QColor kAccent(0x5f, 0xb0, 0xea), kHandle(0xff, 0xb8, 0x5c), kAlarm(0xf0, 0x7a, 0x6a);

/// Calm, so that the picture is what the eye goes to: dark, or light for bright rooms.
void applyTheme(QApplication& application, ThemeKind kind = ThemeKind::Dark);

}  // namespace velum::gui
