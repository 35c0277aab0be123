#pragma once
#include <QFrame>
#include <QLabel>
#include <QLayout>
#include <QProgressBar>
#include <QPushButton>
#include <string>
#include <vector>

namespace velum::gui {

/// One line over the views that says what went wrong, or gives a note. The bar stays until it is closed, and blocks
/// nothing.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent);
  void showError(const QString& text) { showText("error", text); }
  void showNote(const QString& text) { showText("note", text); }
  /// Shows a text and, behind a colon, further lines about it; where the text is empty, the lines alone.
  void showNote(const QString& text, const std::vector<std::string>& lines);
  QString text() const { return mText->text(); }

 private:
  void showText(const char* kind, const QString& text);
  QLabel* mText;
};

/// Shows what is being done and how far the work is, and offers to cancel it.
class ProgressStrip : public QFrame {
  Q_OBJECT
 public:
  explicit ProgressStrip(QWidget* parent);
  void begin(const QString& what);
  void setProgress(double fraction, const QString& what);

 signals:
  void cancelled();

 private:
  QString mTask;
  QLabel* mText;
  QProgressBar* mBar;
};

}  // namespace velum::gui
