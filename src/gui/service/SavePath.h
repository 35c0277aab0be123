#pragma once
#include <QString>
#include <QWidget>

#include "session/document/FileKinds.h"

namespace velum::gui {

/// Asks where a file is to be written. What is typed is the name, with blanks, quotes and letters of any script in it;
/// a name that does not end in a file's kind ("Fig. 3") gets the ending of the kind that is chosen.
/// @param start  folder and name that are proposed  @param filters  "PNG (*.png);;TIFF (*.tif)", the usual one first
/// @return empty: nothing is to be written
QString askSavePath(QWidget* parent, const QString& title, const QString& start, const QString& filters);

/// "*.nii.gz *.nii".
QString patternsOf(const session::FilePatterns& format);

/// The formats in which a kind is written, as askSavePath() takes them.
QString saveFilters(io::FileKind kind);

}  // namespace velum::gui
