#pragma once
#include <QObject>

namespace velum::gui {

/// What panels and views have selected together. Passing state: the selection is neither saved nor undone.
class Selection : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Label id of the selected structure; 0: none.
  int structure() const { return mStructure; }
  /// Id of the selected cut; 0: none. During an edit it may be the id of a cut that was just removed.
  int cut() const { return mCut; }
  /// The selected type of the scene's model, by its place among the model's types; -1: none.
  int type() const { return mType; }
  /// Id of the selected mark; 0: none. During an edit it may be the id of a mark that was just removed.
  int mark() const { return mMark; }

 public slots:
  void setStructure(int id) {
    if (mStructure == id) return;
    mStructure = id;
    emit structureChanged(id);
  }
  void setCut(int id) {
    if (mCut == id) return;
    mCut = id;
    emit cutChanged(id);
  }
  void setType(int type) {
    if (mType == type) return;
    mType = type;
    emit typeChanged(type);
  }
  void setMark(int id) {
    if (mMark == id) return;
    mMark = id;
    emit markChanged(id);
  }

 signals:
  void structureChanged(int id);
  void cutChanged(int id);
  void typeChanged(int type);
  void markChanged(int id);

 private:
  int mStructure = 0;
  int mCut = 0;
  int mType = -1;
  int mMark = 0;
};

}  // namespace velum::gui
