#pragma once
#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>

#include "scene/ModelLayer.h"
#include "session/model/WhatHides.h"

namespace velum::gui {

/// The answer to "What hides this?": the types that stand before a type or compartment, with the share of it that each
/// hides, and buttons to clear them.
class HidersBox : public QFrame {
  Q_OBJECT
 public:
  explicit HidersBox(QWidget* parent);
  void showHiding(const session::Hiding& hiding, const scene::ModelLayer& layer);
  const session::Hiding& hiding() const { return mHiding; }

 signals:
  /// The instances that stand before a type are to be cleared.
  void clearAsked(const QString& path);
  /// A type that hides others is to be hidden itself.
  void hideAsked(const QString& path);
  void selectAsked(const QString& path);

 private:
  void addRow(const session::Hider& hider, const scene::ModelLayer& layer);

  session::Hiding mHiding;
  QLabel* mWords;
  QVBoxLayout* mRows;
};

}  // namespace velum::gui
