#pragma once
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "gui/extrusion/ExtrusionList.h"
#include "gui/extrusion/GrowthForm.h"
#include "gui/extrusion/LeakBox.h"
#include "gui/extrusion/PullSteps.h"
#include "gui/kit/Widgets.h"
#include "gui/service/Selection.h"
#include "session/Session.h"

namespace velum::gui {

/// The page "Pull out": the steps to a picture, the structures that stand out of the cuts, how far each stands out, and
/// how it was grown.
class ExtrusionPanel : public QWidget {
  Q_OBJECT
 public:
  ExtrusionPanel(session::Session& session, Selection& selection, QWidget* parent);
  void refresh();

  PullSteps& steps() { return *mSteps; }
  QPushButton& pullButton() { return *mPull; }
  QPushButton& barrierButton() { return mGrowth->barrierButton(); }

 public slots:
  /// Adds a second plane, joined to the selected plane.
  void addPlane();
  void putBack();
  void putAllBack();

 signals:
  /// In words: why growing is held.
  void held(const QString& why);
  /// The user is going to show which parts do not belong to the selected structure.
  void notThisAsked();
  /// In words: why nothing was done.
  void refused(const QString& why);

 private:
  /// What was last shown, so that a camera that moves costs nothing here.
  struct Shown {
    std::vector<session::Extrusion> extrusions;
    std::vector<scene::Structure> structures;
    std::vector<scene::Growth> growths;
    std::vector<std::pair<int, std::string>> cuts;  ///< ids and names, in their order
    std::vector<std::uint64_t> data;  ///< ids; the size of the data limits how far a structure may stand out
    bool isGrown = false;             ///< the labels hold all growths, so that it is known where each ends
    bool isPlane = false;             ///< the selected cut is a plane
    int cut = -1, structure = -1;     ///< selected
    bool operator==(const Shown&) const = default;
  };
  Shown shownOf(const scene::Scene& scene) const;
  QWidget* buildForm();
  void showRows();
  void showForm();
  void setDistance(double distance);
  QLayout* buildRow(QWidget* form);
  void rename();
  void setColor(glm::vec3 color);

  session::Session& mSession;
  session::Document& mDocument;
  Selection& mSelection;
  PullSteps* mSteps;
  QPushButton *mPull, *mSecond, *mBack = nullptr, *mAllBack = nullptr;
  ExtrusionList* mList;
  LeakBox* mLeak;
  QWidget* mForm;
  QLineEdit* mName = nullptr;
  ColorButton* mColor = nullptr;
  NumberRow* mDistance = nullptr;
  GrowthForm* mGrowth = nullptr;
  Shown mShown;
};

}  // namespace velum::gui
