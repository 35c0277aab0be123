#pragma once
#include <QFrame>
#include <QLabel>
#include <QLayout>
#include <QProgressBar>
#include <QPushButton>
#include <string>
#include <vector>

namespace velum::gui {

/// One line over the views that says what went wrong, or what to know; it waits to be closed and stops nothing.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent);
  void showError(const QString& text) { showText("error", text); }
  void showNote(const QString& text) { showText("note", text); }
  /// With what there is to know of it, one line each, behind a colon; no text: the lines alone.
  void showNote(const QString& text, const std::vector<std::string>& lines);
  QString text() const { return mText->text(); }

 private:
  void showText(const char* kind, const QString& text);
  QLabel* mText;
};

/// What is being done, how far it is, and a way out.
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
