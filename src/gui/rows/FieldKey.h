#pragma once
#include <QAbstractButton>
#include <QMenu>
#include <functional>
#include <optional>
#include <string>

#include "session/document/Document.h"

namespace velum::gui {

/// Adds what a film can do with a field to a menu: make a key of it at the playhead, or remove the one that is there.
/// Nothing for a field that a film cannot change. @param path  of the field: "cuts.0.opacity"  @param what  is keyed,
/// for a menu of several fields: "Key opacity"; empty: "Key this"
void addKeyEntry(QMenu& menu, session::Document& document, const std::string& path, const QString& what = {});

/// A small diamond that says that a film changes a field; filled where a key is at the playhead. A click makes that
/// key, or removes it. The menu of the field's control does the same. Hidden where no track is of the field.
class FieldKey : public QAbstractButton {
  Q_OBJECT
 public:
  /// @param path  the field's; empty: none now
  FieldKey(session::Document& document, const QString& title, std::function<std::string()> path, QWidget* parent);

  /// Adds to the menus of a control, and of what is in it.
  void watch(QWidget* control);
  /// Stands over the end of a control that has no row of its own.
  void standOver(QWidget* control);
  /// @param isShown  the field's row is shown
  void refresh(bool isShown);
  QSize sizeHint() const override { return {12, 15}; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void place();
  void showMenu(QWidget& control, QPoint globalPlace);

  session::Document& mDocument;
  std::function<std::string()> mPath;
  QWidget* mOver = nullptr;  ///< as of standOver()
  bool mIsHere = false;      ///< a key is at the playhead
};

}  // namespace velum::gui
