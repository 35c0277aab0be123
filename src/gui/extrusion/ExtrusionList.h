#pragma once
#include <QListWidget>
#include <vector>

#include "session/extrusion/Extrusion.h"

namespace velum::gui {

/// What stands out of cuts, a row each: colour, name, how far, and of several cuts out of which.
class ExtrusionList : public QListWidget {
  Q_OBJECT
 public:
  explicit ExtrusionList(QWidget* parent);
  void showScene(const scene::Scene& scene, const std::vector<session::Extrusion>& extrusions);
  /// Selects the row of one; none where it has none. Tells nobody.
  void select(int cut, int structure);
  /// The one whose row is selected.
  std::optional<session::Extrusion> current() const;
  std::vector<session::Extrusion> selected() const;

 signals:
  void chosen(const velum::session::Extrusion& extrusion);

 private:
  std::vector<session::Extrusion> mExtrusions;
};

}  // namespace velum::gui
