#pragma once
#include <QObject>

#include "gui/kit/Messages.h"
#include "gui/look/ShowThisTool.h"
#include "gui/service/ActionTable.h"
#include "session/document/Document.h"

namespace velum::gui {

/// What the menus do to the look: import, export, and "show this", the tool that makes clicked tissue visible.
class LookCommands : public QObject {
  Q_OBJECT
 public:
  LookCommands(session::Document& document, Toolbox& toolbox, MessageBar& messages, QWidget* window);
  /// Adds the commands to a menu, and "show this" to the tool bar.
  void build(ActionTable& actions, QMenu* menu);

  /// Gives the open scene the look of a file, as one undo step; what is wrong goes to the message bar.
  void importFrom(const QString& path);
  void exportTo(const QString& path);
  /// While it is on, a click in a view shows the tissue there.
  bool isShowing() const { return mShowThis->isActive(); }

 private:
  void askImport();
  void askExport();

  session::Document& mDocument;
  Toolbox& mToolbox;
  MessageBar& mMessages;
  QWidget* mWindow;
  ShowThisTool* mShowThis;
  QString mFolder;  ///< Of the last file.
};

}  // namespace velum::gui
