#pragma once
#include <QObject>

namespace velum::gui {

/// What panels and views have selected together. Passing state: it is neither saved nor undone.
class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Label id; 0: none.
  int structure() const { return mStructure; }
  /// Place in scene.cuts; -1: none. May lie beyond the list for the time of an edit.
  int cut() const { return mCut; }

 public slots:
  void setStructure(int id) {
    if (mStructure == id) return;
    mStructure = id;
    emit structureChanged(id);
  }
  void setCut(int index) {
    if (mCut == index) return;
    mCut = index;
    emit cutChanged(index);
  }

 signals:
  void structureChanged(int id);
  void cutChanged(int index);

 private:
  int mStructure = 0;
  int mCut = -1;
};

}  // namespace velum::gui
