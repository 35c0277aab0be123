#pragma once
#include <QWidget>

namespace velum::gui {

/// The key of bars of counts, which stands beside them: the colour and the word of each part of a bar.
class CountKey : public QWidget {
  Q_OBJECT
 public:
  enum class Of { Instances, Pixels };  ///< what the bars count
  CountKey(Of of, QWidget* parent);
};

}  // namespace velum::gui
