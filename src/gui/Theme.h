#pragma once
#include <QApplication>
#include <QColor>

namespace velum::gui {

/// The colours that widgets which paint themselves share with the style sheet.
inline const QColor kGround(0x1d, 0x20, 0x25), kPanel(0x25, 0x29, 0x2f), kLine(0x3a, 0x40, 0x49),
    kText(0xe3, 0xe7, 0xec), kMuted(0x9b, 0xa5, 0xb1), kAccent(0x5f, 0xb0, 0xea), kHandle(0xff, 0xb8, 0x5c),
    kAlarm(0xf0, 0x7a, 0x6a);

/// The slice views' own colours, axial, coronal, sagittal: of their titles and of their lines in the other views.
inline const QColor kSliceColors[] = {QColor(0xe8, 0x7d, 0x76), QColor(0x86, 0xc9, 0x8a), QColor(0x7f, 0xb4, 0xf0)};

/// Calm and dark, so that the picture is the brightest thing on the screen.
void applyTheme(QApplication& application);

}  // namespace velum::gui
