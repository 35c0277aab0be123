#pragma once
#include <QApplication>
#include <QColor>

namespace velum::gui {

enum class ThemeKind { Dark, Light };

/// A colour of a theme by its name in the style sheet: "panel", "muted" ...; invalid where no colour has that name.
QColor themeColor(ThemeKind kind, const QString& name);

/// The theme that a widget is painted in.
ThemeKind themeOf(const QPalette& palette);

/// Colours of handles, lines and warnings that are drawn over pictures; the same in both themes. Widgets take their
/// colours from the palette: Base the ground of fields, Window of panels, Mid thin lines, Dark edges, PlaceholderText
/// words of less weight, Link the accent.
inline const QColor kAccent(0x5f, 0xb0, 0xea), kHandle(0xff, 0xb8, 0x5c), kAlarm(0xf0, 0x7a, 0x6a);

/// The colours of the axial, coronal and sagittal view: each view's title and its line in the other views have its
/// colour.
inline const QColor kSectionColors[] = {QColor(0xe8, 0x7d, 0x76), QColor(0x86, 0xc9, 0x8a), QColor(0x7f, 0xb4, 0xf0)};
/// Words and signs over pictures.
inline const QColor kOverPicture(0xf0, 0xf3, 0xf7);

/// Gives the program its look, which is calm, so that the eye goes to the picture: dark, or light for bright rooms.
void applyTheme(QApplication& application, ThemeKind kind = ThemeKind::Dark);

}  // namespace velum::gui
