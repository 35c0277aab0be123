#pragma once
#include <QColor>
#include <QMenu>
#include <QObject>
#include <vector>

#include "gui/service/Selection.h"
#include "gui/structure/StructureMeter.h"
#include "gui/view/CameraFlight.h"
#include "session/document/Document.h"
#include "session/structure/StructureEdit.h"

namespace velum::gui {

/// What can be done to structures, from the panel, the menus and the views alike. Each is one undo step with a name.
class StructureCommands : public QObject {
  Q_OBJECT
 public:
  using Ids = std::vector<int>;
  StructureCommands(session::Document& document, Selection& selection, QObject* parent);

  void setVisible(const Ids& ids, bool visible);
  /// Shows those that are hidden and hides those that are shown.
  void invertVisible(const Ids& ids);
  /// Shows a structure alone, or what was shown before.
  void toggleSolo(int id);
  void setColor(const Ids& ids, glm::vec3 color);
  /// Joins one undo step until endMerge() of the document.
  void dragOpacity(const Ids& ids, double opacity);
  /// Gives structures a lit sphere of their own in a finished picture; empty: that of the finish.
  void setShowAs(const Ids& ids, scene::ShowAs as);
  void setLitSphere(const Ids& ids, const QString& name);
  void rename(int id, const QString& name);
  /// Whether the selected cut leaves structures whole; nothing without a cut.
  void setSpared(const Ids& ids, bool whole);
  bool isSpared(int id) const;
  /// The force of structures on the sheet of the selected membrane; nothing without one.
  /// @param strength  > 0 keeps them whole, < 0 draws the sheet to them, 0 takes them off
  void setStrength(const Ids& ids, double strength);
  /// Brings the camera near and the crosshair into the structure's middle, at once or when its size is known.
  void goTo(int id);

  /// The entries for one or several structures.
  void fillMenu(QMenu& menu, const Ids& ids);

  StructureMeter& meter() { return mMeter; }
  session::Document& document() { return mDocument; }
  /// The name of the selected cut; empty without one.
  QString cutName() const;

 signals:
  /// Somebody wants the row of a structure to be seen, e.g. "Rename" in a menu.
  void renameAsked(int id);
  /// These are to be written for other programs.
  void exportAsked(const std::vector<int>& ids);

 private:
  std::vector<std::string> named(const Ids& ids) const;
  const scene::Cut* cut() const;
  const scene::Membrane* membrane() const;
  double strengthOf(int id) const;
  void fillShowMenu(QMenu& menu, const Ids& ids);
  void fillSphereMenu(QMenu& menu, const Ids& ids);
  void fillMembraneMenu(QMenu& menu, const Ids& ids);

  session::Document& mDocument;
  Selection& mSelection;
  StructureMeter mMeter;
  session::SoloMemory mSolo;
  int mGoTo = 0;  ///< Wants to be gone to when its size is known.
  CameraFlight mFlight;
};

}  // namespace velum::gui
