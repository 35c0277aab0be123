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
  /// Of these structures, shows those that are hidden and hides those that are shown.
  void invertVisible(const Ids& ids);
  /// Shows a structure alone, or, where it is shown alone already, the structures that were shown before.
  void toggleSolo(int id);
  void setColor(const Ids& ids, glm::vec3 color);
  /// Sets opacities. Changes join one undo step until endMerge() of the document.
  void dragOpacity(const Ids& ids, double opacity);
  /// Sets how structures are shown; setLitSphere() gives them a lit sphere of their own in a finished picture, or, for
  /// an empty name, that of the finish.
  void setShowAs(const Ids& ids, scene::ShowAs as);
  void setLitSphere(const Ids& ids, const QString& name);
  void rename(int id, const QString& name);
  /// Lists structures in the legend of pictures, or takes them out of its list.
  void listInLegend(const Ids& ids, bool listed);
  /// Sets whether the selected cut leaves structures whole; does nothing when no cut is selected.
  void setSpared(const Ids& ids, bool whole);
  bool isSpared(int id) const;
  /// Sets the force of structures on the sheet of the selected membrane; does nothing when no membrane is selected.
  /// @param strength  > 0 keeps the structures whole, < 0 draws the sheet to them, 0 gives them no force
  void setStrength(const Ids& ids, double strength);
  /// Brings the camera near a structure and the crosshair into its middle, at once or as soon as the structure's size
  /// is known.
  void goTo(int id);

  /// Adds the entries for one or several structures to a menu.
  void fillMenu(QMenu& menu, const Ids& ids);

  StructureMeter& meter() { return mMeter; }
  session::Document& document() { return mDocument; }
  /// The name of the selected cut; empty when no cut is selected.
  QString cutName() const;

 signals:
  /// The row of a structure is to be seen and its name edited, e.g. by "Rename" in a menu.
  void renameAsked(int id);
  /// These structures are to be written for other programs.
  void exportAsked(const std::vector<int>& ids);

 private:
  std::vector<std::string> named(const Ids& ids) const;
  const scene::Cut* cut() const;
  const scene::Membrane* membrane() const;
  double strengthOf(int id) const;
  void fillShowMenu(QMenu& menu, const Ids& ids);
  void fillSphereMenu(QMenu& menu, const Ids& ids);
  void fillLegendEntry(QMenu& menu, const Ids& ids);
  void fillMarkEntries(QMenu& menu, int id);
  void fillKeyEntries(QMenu& menu, int id);
  void fillMembraneMenu(QMenu& menu, const Ids& ids);

  session::Document& mDocument;
  Selection& mSelection;
  StructureMeter mMeter;
  session::SoloMemory mSolo;
  int mGoTo = 0;  ///< The structure that goTo() waits for, until its size is known; 0: none.
  CameraFlight mFlight;
};

}  // namespace velum::gui
