#pragma once
#include <QDialog>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/window/FilmPreview.h"

namespace velum::gui {

/// What dialogs of films share: small pictures of the film above what is asked, and a row of buttons at the end.
class FilmDialog : public QDialog {
  Q_OBJECT
 public:
  FilmPreview& preview() { return *mPreview; }

 protected:
  /// @param pictureWidth  of each small picture, pixels
  FilmDialog(const QString& title, int pictureWidth, QWidget* parent);

  /// A button: what it says, by which name tests find it, and its tip.
  struct Act {
    QString text;
    const char* name;
    QString tip;
  };
  /// Adds the row of buttons: the one that closes the dialog and does it, another one, and Cancel.
  void addButtons(const Act& main, const Act& other);
  /// Called when the pictures have been drawn. @param why  they could not be, one line; empty: they are there
  virtual void tell(const QString& why) = 0;

  QVBoxLayout* mColumn;  ///< under the pictures
  FilmPreview* mPreview;
  QPushButton *mMain = nullptr, *mOther = nullptr;
};

}  // namespace velum::gui
