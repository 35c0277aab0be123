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

  /// Gives the open scene the look in a file, as one undo step; errors go to the message bar.
  void importFrom(const QString& path);
  void exportTo(const QString& path);
  /// True while "show this" is active: a click in a view shows the tissue there.
  bool isShowing() const { return mShowThis->isActive(); }

 private:
  void askImport();
  void askExport();

  session::Document& mDocument;
  Toolbox& mToolbox;
  MessageBar& mMessages;
  QWidget* mWindow;
  ShowThisTool* mShowThis;
  QString mFolder;  ///< The folder of the last look that was imported or exported.
};

}  // namespace velum::gui
