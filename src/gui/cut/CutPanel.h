#pragma once
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "gui/cut/CutForm.h"
#include "gui/cut/CutList.h"
#include "gui/cut/SpareList.h"
#include "gui/cut/TypeSpareList.h"
#include "gui/membrane/MembraneForm.h"
#include "gui/service/JobRunner.h"
#include "gui/service/Selection.h"
#include "session/document/Document.h"

namespace velum::gui {

/// The list of cuts, and all that can be done to the selected one.
class CutPanel : public QWidget {
  Q_OBJECT
 public:
  CutPanel(session::Document& document, Selection& selection, JobRunner& jobs, QWidget* parent);
  void refresh();

  /// The controls of the selected membrane; hidden when the selected cut is no membrane.
  MembraneForm& membraneForm() { return *mMembrane; }
  FocusForm& focusForm() { return mTypeSpares->focus(); }

  /// Adds a cut of a shape, placed where it is of use.
  void addShape(scene::CutShape shape);
  /// Adds a cut that the caller has placed. @param label  of the undo step
  void addCut(scene::Cut cut, const char* label = "Add cut");

 public slots:
  void addPlane() { addShape(scene::CutShape::Plane); }
  /// Adds a membrane, whose sheet keeps whole what the scene shows most.
  void addMembrane() { addShape(scene::CutShape::Membrane); }
  /// Adds a plane through the middle that faces the camera.
  void addAlongView();
  void removeSelected();
  void flipSelected();
  void duplicateSelected();
  /// Moves the selected cut in the list. @param by  -1: up, 1: down
  void moveSelected(int by);

 signals:
  void threePointsAsked();
  /// A row of the list was clicked, even if its cut was selected already.
  void cutClicked();
  /// In words: why nothing was done.
  void refused(const QString& why);

 private:
  /// Place of the selected cut in the list; -1: none.
  int place() const;
  void buildHead();
  QWidget* buildTools();
  void searchMembrane();
  /// Runs a command that adds a cut, and selects the new cut.
  void addAs(const session::Call& call);
  /// The text by which commands name a cut. @param id  of the cut
  std::string key(int id) const;
  bool hasData() const;
  /// The scene has room for one more cut; where it has none the user is told.
  bool hasRoom();

  session::Document& mDocument;
  Selection& mSelection;
  JobRunner& mJobs;
  CutList* mList;
  CutForm* mForm;
  MembraneForm* mMembrane;
  SpareList* mSpares;
  TypeSpareList* mTypeSpares;
  QWidget *mTools = nullptr, *mLine = nullptr;
  QLabel* mEmpty = nullptr;
  QPushButton *mUp = nullptr, *mDown = nullptr;
  /// What was last shown, so that a camera that moves costs nothing here.
  struct Shown {
    std::vector<scene::Cut> cuts;
    std::vector<scene::Structure> structures;
    std::uint64_t volume = 0, labels = 0, model = 0;
    int place = -2;
    std::vector<scene::Track> tracks = {};  ///< of the film, and where its playhead is: marks beside fields show keys
    std::optional<double> playhead = {};
    bool operator==(const Shown&) const = default;
  };
  Shown mShown;
};

}  // namespace velum::gui
