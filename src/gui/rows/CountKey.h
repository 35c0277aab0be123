#pragma once
#include <QWidget>

namespace velum::gui {

/// The key of bars of counts, which stands beside them: the colour and the word of each part of a bar.
class CountKey : public QWidget {
  Q_OBJECT
 public:
  /// @param tip  says what the parts are of
  CountKey(const QString& tip, QWidget* parent);
};

}  // namespace velum::gui
