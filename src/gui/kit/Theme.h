#pragma once
#include <QApplication>
#include <QColor>

namespace velum::gui {

enum class ThemeKind { Dark, Light };

/// A colour of a theme by its name in the style sheet: "panel", "muted" ...; invalid where there is none.
QColor themeColor(ThemeKind kind, const QString& name);

/// The theme that a widget is painted in.
ThemeKind themeOf(const QPalette& palette);

/// Colours of what is drawn over pictures; the same in both themes. Widgets take theirs from the palette: Base the
/// ground of fields, Window of panels, Mid thin lines, Dark edges, PlaceholderText what is said quietly, Link the
/// accent.
inline const QColor kAccent(0x5f, 0xb0, 0xea), kHandle(0xff, 0xb8, 0x5c), kAlarm(0xf0, 0x7a, 0x6a);

/// The section views' own colours, axial, coronal, sagittal: of their titles and of their lines in the other views.
inline const QColor kSectionColors[] = {QColor(0xe8, 0x7d, 0x76), QColor(0x86, 0xc9, 0x8a), QColor(0x7f, 0xb4, 0xf0)};
/// Words and signs over pictures.
inline const QColor kOverPicture(0xf0, 0xf3, 0xf7);

/// Calm, so that the picture is what the eye goes to: dark, or light for bright rooms.
void applyTheme(QApplication& application, ThemeKind kind = ThemeKind::Dark);

}  // namespace velum::gui
