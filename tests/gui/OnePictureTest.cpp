// A scene of a model is one picture: whatever has set its numbers, the window and the command line count the same in
// it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include "ModelFixture.h"
#include "RunBatch.h"
#include "core/Counts.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/DocumentCommands.h"
#include "session/command/ModelCommands.h"
#include "session/command/ViewCommands.h"
#include "session/cut/CutEdit.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {

class OnePicture : public ModelWindow {
 protected:
  Equalizer& equalizer() { return mWindow->models().equalizer(); }
  ModelCommands& commands() { return mWindow->models().commands(); }
  const Model& model() { return *scene().model.data; }
  std::string pathOf(std::size_t type) { return velum::pathOf(model(), model().types[type]); }
  Counts countOf(std::size_t type) { return equalizer().counts().types()[type]; }

  /// A virion that a plane opens, from a file. @return its types, those first of which most are seen
  std::vector<std::size_t> openCut() {
    runBatch({"sample", "virion", "-o", path("virion.cif")});
    mWindow->resize(900, 700);
    mWindow->openPaths({path("virion.cif")});
    EXPECT_TRUE(waitForJob());
    drawSoon();
    session::edit(mWindow->document(), session::AddCut{scene::CutShape::Plane, "Plane"});
    EXPECT_TRUE(settle());
    std::vector<std::size_t> order(model().types.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return countOf(a).visible() > countOf(b).visible(); });
    return order;
  }
  void set(const std::string& path, Equalizer::Handle handle, double count) {
    equalizer().set(path, handle, count);
    ASSERT_TRUE(waitForJob());
  }
  void meetTargets() {
    emit commands().targetsAsked();
    ASSERT_TRUE(waitForJob());
  }

  /// Saves the scene and has velum-batch count it, in pictures of the view's size.
  void expectSameCounts(const char* after) {
    SCOPED_TRACE(after);
    ASSERT_TRUE(settle());
    ASSERT_TRUE(equalizer().counts().isExact());
    mWindow->session().file().save(path("one.json").toStdString());
    runBatch({"count", path("one.json"), "--size", QString("%1x%2").arg(viewport().width()).arg(viewport().height()),
              "--csv", path("one.csv")});
    std::ifstream file(path("one.csv").toStdString());
    std::string table((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (std::size_t type = 0; type < model().types.size(); ++type) {
      std::string line = fmt::format("{},{},{}\n", pathOf(type), model().types[type].name, countFields(countOf(type)));
      EXPECT_NE(table.find(line), std::string::npos) << line << "\n" << table;
    }
  }
};

TEST_F(OnePicture, AfterEachKindOfNumber) {
  std::vector<std::size_t> types = openCut();
  std::string one = pathOf(types[0]), two = pathOf(types[1]);
  double seen = double(countOf(types[0]).visible());
  ASSERT_GT(seen, 40.0);
  commands().setTarget(one, std::floor(seen / 2.0));
  meetTargets();
  expectSameCounts("a number to be seen");
  EXPECT_TRUE(session::visibleTarget(scene(), one));
  set(one, Equalizer::Handle::Left, 12.0);
  expectSameCounts("then another as drawn");
  EXPECT_EQ(countOf(types[0]).left(), 12u);
  EXPECT_FALSE(session::visibleTarget(scene(), one)) << "what was wanted before is no more";
  set(two, Equalizer::Handle::Seen, 9.0);
  expectSameCounts("the knob of those that are seen");
  std::string root = one.substr(0, one.find('.'));
  set(root, Equalizer::Handle::Left, 400.0);
  expectSameCounts("the number of a group");
  EXPECT_EQ(countOf(types[0]).left(), 12u) << "set by hand";
  meetTargets();
  expectSameCounts("all numbers together");
}

TEST_F(OnePicture, AfterSharesAndViewsOntoAFocus) {
  std::vector<std::size_t> types = openCut();
  std::string one = pathOf(types[0]), rare = pathOf(types.back());
  commands().setTarget(one, 5.0);
  session::edit(mWindow->document(), session::LeaveTypes{{one}, 0.3, "Plane"});
  EXPECT_FALSE(session::isHeld(scene().model, one)) << "its share says how many now";
  expectSameCounts("a share");
  session::edit(mWindow->document(), session::KeepInView{rare, true});
  expectSameCounts("a focus");
  session::editByHand(mWindow->document(), "Lock the view", [](scene::Scene& scene) {
    for (scene::Cut& cut : scene.cuts)
      if (cut.model.focus) cut.model.focus->lock = scene::ViewLock{scene.camera, 1.2};
  });
  session::edit(mWindow->document(), session::LookFrom{scene::StandardView::Left, 1.2});
  expectSameCounts("a view that is locked, from elsewhere");
  set(one, Equalizer::Handle::Left, 20.0);
  expectSameCounts("a number beside it");
}

}  // namespace velum::gui
