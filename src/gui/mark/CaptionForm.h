#pragma once
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QWidget>

#include "gui/mark/OwnColor.h"
#include "gui/rows/FieldForm.h"
#include "scene/Caption.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The captions over the picture: a list of them, and the text and the fields of the one that is selected.
class CaptionForm : public QWidget {
  Q_OBJECT
 public:
  CaptionForm(session::Document& document, int labelWidth, QWidget* parent);
  /// Shows the document as it is now.
  void refresh();

 public slots:
  /// Adds a caption whose words are selected: what is typed next takes their place.
  void add();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeFields(int labelWidth);
  void addRows();
  int place() const;  ///< of the selected caption in its list; -1: none is selected
  const std::vector<scene::Caption>& captions() const;
  void select(int id);
  void remove();
  void setField(const char* field, const std::string& value, const QString& step, bool merge = false);
  void showList();
  void showText();

  session::Document& mDocument;
  int mSelected = 0;  ///< id of a caption; 0: none
  QPushButton *mAdd, *mRemove;
  QListWidget* mList;
  QPlainTextEdit* mText;
  QWidget* mFields;
  OwnColor* mOwnColor;
  FieldForm mForm;
};

}  // namespace velum::gui
