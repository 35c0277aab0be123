#pragma once
#include <QWidget>

#include "session/membrane/MembraneMover.h"

namespace velum::gui {

/// Three shares of the protected volume as one bar: kept whole, removed whole, cut.
class ShareBar : public QWidget {
  Q_OBJECT

 public:
  explicit ShareBar(QWidget* parent);
  void setShares(const membrane::Shares& shares);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  membrane::Shares mShares;
};

}  // namespace velum::gui
