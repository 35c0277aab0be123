#pragma once
#include <QListWidget>
#include <vector>

#include "session/extrusion/Extrusion.h"

namespace velum::gui {

/// The structures that stand out of cuts, a row each: colour, name, how far the structure stands out, and, where the
/// scene has several cuts, out of which.
class ExtrusionList : public QListWidget {
  Q_OBJECT
 public:
  explicit ExtrusionList(QWidget* parent);
  void showScene(const scene::Scene& scene, const std::vector<session::Extrusion>& extrusions);
  /// Selects the row of an extrusion; no row where the extrusion has none. Emits no signal.
  void select(int cut, int structure);
  /// The extrusion whose row is the current one.
  std::optional<session::Extrusion> current() const;
  std::vector<session::Extrusion> selected() const;

 signals:
  void chosen(const velum::session::Extrusion& extrusion);

 private:
  std::vector<session::Extrusion> mExtrusions;
};

}  // namespace velum::gui
