#include "gui/service/SavePath.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>

namespace velum::gui {

namespace {

/// ".png" of "PNG (*.png *.apng)".
QString endingOf(const QString& filter) {
  static const QRegularExpression form(R"(\(\*(\.[^ )]+))");
  return form.match(filter).captured(1);
}

bool endsInKind(const QString& path) {
  static const QRegularExpression form("\\.[A-Za-z][A-Za-z0-9]{0,5}$");
  return form.match(QFileInfo(path).fileName()).hasMatch();
}

/// Qt's own dialog takes double quotes for marks between several names, and a file that is selected in the list for
/// what was typed. (No Q_OBJECT: Qt asks the system's dialog only for its own class.)
class SaveDialog : public QFileDialog {
 public:
  SaveDialog(QWidget* parent, const QString& title, const QString& start, const QString& filters)
      : QFileDialog(parent, title, QFileInfo(start).path(), filters) {
    setAcceptMode(QFileDialog::AcceptSave);
    setFileMode(QFileDialog::AnyFile);
    selectFile(QFileInfo(start).fileName());
    // The format of the name that is proposed is the one that a name without an ending gets.
    QRegularExpression own("\\*" + QRegularExpression::escape(start.mid(start.lastIndexOf('.'))) + "[ )]");
    for (const QString& filter : nameFilters())
      if (filter.contains(own)) selectNameFilter(filter);
  }
  /// As it was typed, with its ending.
  QString path() const {
    QString path = mTyped.isEmpty() ? selectedFiles().value(0) : mTyped;
    return endsInKind(path) || path.isEmpty() ? path : path + endingOf(selectedNameFilter());
  }

 protected:
  void accept() override {
    auto* edit = findChild<QLineEdit*>("fileNameEdit");
    QString text = edit ? edit->text() : QString();
    if (text.isEmpty() || QFileInfo(directory().absoluteFilePath(text)).isDir()) return QFileDialog::accept();
    mTyped = directory().absoluteFilePath(text);
    bool mayWrite =
        !QFileInfo::exists(path()) ||
        QMessageBox::question(this, windowTitle(), QFileDialog::tr("%1 already exists.\nReplace it?").arg(text)) ==
            QMessageBox::Yes;
    if (mayWrite) QDialog::accept();
  }

 private:
  QString mTyped;
};

}  // namespace

QString askSavePath(QWidget* parent, const QString& title, const QString& start, const QString& filters) {
  SaveDialog dialog(parent, title, start, filters);
  return dialog.exec() == QDialog::Accepted ? dialog.path() : QString();
}

QString patternsOf(const session::FilePatterns& format) {
  QStringList patterns;
  for (const std::string& pattern : format.patterns) patterns << QString::fromStdString(pattern);
  return patterns.join(' ');
}

QString saveFilters(io::FileKind kind) {
  QStringList filters;
  for (const session::FilePatterns& format : session::writtenPatterns(kind))
    filters << QString("%1 (%2)").arg(QString::fromStdString(format.name), patternsOf(format));
  return filters.join(";;");
}

QString volumeFilters(const QString& title) {
  QStringList patterns;
  for (const session::FilePatterns& format : session::volumePatterns()) patterns << patternsOf(format);
  return QString("%1 (%2);;%3").arg(title, patterns.join(' '), QObject::tr("All files (*)"));
}

}  // namespace velum::gui
