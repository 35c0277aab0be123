#pragma once
#include <QComboBox>
#include <QLineEdit>
#include <QWidget>

#include "gui/mark/CaptionForm.h"
#include "gui/rows/FieldForm.h"
#include "session/document/Document.h"

namespace velum::gui {

/// What is written over pictures beside marks, and how all of it looks: style and page, names, legend, scale bar, time
/// stamp, captions.
class LetteringForm : public QWidget {
  Q_OBJECT
 public:
  LetteringForm(session::Document& document, QWidget* parent);
  /// Shows the document as it is now.
  void refresh();
  CaptionForm& captions() { return *mCaptions; }

 private:
  QWidget* makeStyle();
  QComboBox* makeStyles(QWidget* parent);
  QWidget* makeWidths(QWidget* parent);
  QWidget* makeNames();
  QWidget* makeCorners();
  void addCorner(const char* part, const char* corner, bool scene::Lettering::*isOn, const QString& title,
                 const QString& tip, const std::function<bool()>& canBe);
  void nameThese();

  session::Document& mDocument;
  FieldForm mForm;
  QComboBox* mStyle = nullptr;
  QLineEdit* mNamed = nullptr;
  CaptionForm* mCaptions;
};

}  // namespace velum::gui
