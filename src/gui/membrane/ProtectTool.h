#pragma once
#include <QObject>

#include "kit/Bars.h"
#include "kit/Selection.h"
#include "velum/session/document/Document.h"
#include "view/ViewGrid.h"

namespace velum::gui {

/// One click in any view says what the selected membrane is to keep whole, or to let the sheet through: a structure
/// where labels are shown, else tissue by its values. Shift goes on with the next; Esc gives up.
class ProtectTool : public QObject {
  Q_OBJECT
 public:
  ProtectTool(session::Document& document, ViewGrid& views, Selection& selection, MessageBar& messages,
              QObject* parent);

  bool isActive() const { return mActive; }

 public slots:
  void start(bool letThrough);
  void stop();

 signals:
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void clickedInPicture(QPointF place, Qt::KeyboardModifiers keys);
  void protectAt(glm::dvec3 worldMm, int structure, Qt::KeyboardModifiers keys);

  session::Document& mDocument;
  ViewGrid& mViews;
  Selection& mSelection;
  MessageBar& mMessages;
  bool mActive = false, mLetThrough = false;
};

}  // namespace velum::gui
