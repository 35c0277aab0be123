#pragma once
#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>

#include "scene/ModelLayer.h"
#include "session/model/WhatHides.h"

namespace velum::gui {

/// The answer to "What hides this?": the types that stand before another, by how much of it, and a way to clear them.
class HidersBox : public QFrame {
  Q_OBJECT
 public:
  explicit HidersBox(QWidget* parent);
  void showHiding(const session::Hiding& hiding, const scene::ModelLayer& layer);
  const session::Hiding& hiding() const { return mHiding; }

 signals:
  /// What stands before a type is to go.
  void clearAsked(const QString& path);
  /// One of those that hide it is to be hidden itself.
  void hideAsked(const QString& path);
  void selectAsked(const QString& path);

 private:
  void addRow(const session::Hider& hider, const scene::ModelLayer& layer);

  session::Hiding mHiding;
  QLabel* mWords;
  QVBoxLayout* mRows;
};

}  // namespace velum::gui
