#pragma once
#include <QString>
#include <QWidget>

#include "session/document/FileKinds.h"

namespace velum::gui {

/// Asks where a file is to be written. The typed text is taken as the name, with blanks, quotes and letters of any
/// script in it; a name without the ending of a file format ("Fig. 3") gets the ending of the format that is chosen.
/// @param start  folder and name that are proposed  @param filters  "PNG (*.png);;TIFF (*.tif)", the usual format first
/// @return empty: nothing is to be written
QString askSavePath(QWidget* parent, const QString& title, const QString& start, const QString& filters);

/// The patterns of a format's files, as "*.nii.gz *.nii".
QString patternsOf(const session::FilePatterns& format);

/// The formats in which a kind of file can be written, as askSavePath() takes its filters.
QString saveFilters(io::FileKind kind);

/// Files of volumes and of labels, as QFileDialog takes its filters. @param title  what is asked for
QString volumeFilters(const QString& title);

}  // namespace velum::gui
