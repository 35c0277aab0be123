#pragma once
#include <QLineEdit>
#include <QTextBrowser>
#include <QWidget>

namespace velum::gui {

/// The user guide, which is part of the program: it needs no network and no browser.
class HelpWindow : public QWidget {
  Q_OBJECT
 public:
  explicit HelpWindow(QWidget* parent);
  const QTextBrowser& page() const { return *mPage; }

 private:
  void find();
  QTextBrowser* mPage;
  QLineEdit* mWords;
};

}  // namespace velum::gui
