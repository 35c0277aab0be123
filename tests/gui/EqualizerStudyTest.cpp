// A biologist's first minute with a virus: to cut it open, to bring spikes back, to fade what swims about it. Each
// action is counted; the pictures on the way are looked at.
#include <cstdlib>

#include "ModelFixture.h"
#include "Shots.h"
#include "io/phantoms/Virion.h"
#include "patience.h"
#include "render/kept/KeptInstances.h"
#include "scene/Scene.h"
#include "session/model/ClipState.h"
#include "session/model/TypesAt.h"

namespace velum::gui {

class EqualizerStudy : public ModelWindow {
 protected:
  static constexpr int kMostActions = 8;

  void act(const char* what) { ++mActions, mLog << what; }
  std::uint64_t drawn(const std::string& path) {
    std::vector<std::uint8_t> kept = render::keptInstances(scene());
    const Model& model = *scene().model.data;
    std::uint64_t sum = 0;
    for (std::uint32_t type : session::typesAt(model, path).types)
      for (std::size_t i = 0; i < model.types[type].instanceCount; ++i)
        sum += kept[model.types[type].firstInstance + i];
    return sum;
  }
  int rowOf(const std::string& path) {
    const auto& rows = list().tree().rows();
    std::string whole = session::typesAt(*scene().model.data, path).path;
    return int(std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.path == whole; }) -
               rows.begin());
  }
  void see(const QString& name) {
    ASSERT_TRUE(settle());
    QTest::qWait(50);
    takeShot(*mWindow, name);
  }

  /// @param spike  type of which so many are to be there  @param plasma  compartment about the virus
  void study(const QString& name, const std::string& spike, int spikes, const std::string& plasma) {
    see(name + "-0-opened");
    EXPECT_EQ(session::clipState(scene()), session::ClipState::Whole);

    act("C: a plane before the middle");
    viewport().setFocus();
    QTest::keyClick(mWindow.get(), Qt::Key_C);
    ASSERT_EQ(scene().cuts.size(), 1u);
    see(name + "-1-cut");
    std::uint64_t left = drawn(spike), plasmaLeft = drawn(plasma);
    EXPECT_LT(left, std::uint64_t(spikes)) << "the cut takes some";

    act("the page of the model");
    auto& tabs = mWindow->tabs();
    for (int i = 0; i < tabs.count(); ++i)
      if (tabs.tabText(i) == "Model")
        QTest::mouseClick(tabs.tabBar(), Qt::LeftButton, {}, tabs.tabBar()->tabRect(i).center());
    ASSERT_TRUE(QTest::qWaitFor([&] { return list().isVisible(); }, kPatience));

    act("search the spikes");
    auto* search = child<QLineEdit>("modelSearch");
    QTest::mouseClick(search, Qt::LeftButton);
    QTest::keyClicks(search, QString::fromStdString(std::string(session::shortName(spike))).replace('_', ' '));
    QRect number =
        list().visualRect(list().order().mapFromSource(list().tree().indexOfRow(rowOf(spike), ModelTree::Count)));
    ASSERT_TRUE(number.isValid());

    act("type their number");
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, number.center());
    QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, number.center());
    auto* field = list().findChild<QLineEdit*>("modelNumber");
    ASSERT_TRUE(field);
    field->selectAll();
    QTest::keyClicks(field, QString::number(spikes));
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return drawn(spike) == std::uint64_t(spikes); }, kPatience)) << drawn(spike);
    see(name + "-2-spikes");

    act("all types again");
    search->clear();
    QApplication::processEvents();

    act("drag the plasma's bar");
    int row = rowOf(plasma);
    list().scrollTo(list().order().mapFromSource(list().tree().indexOfRow(row, ModelTree::Name)));
    QApplication::processEvents();
    CountBar bar = list().barOf(row);
    auto at = [&](double x) { return QPointF(bar.box.left() + x, bar.box.center().y()).toPoint(); };
    drag(*list().viewport(), at(bar.left), at(bar.left * 0.2));
    EXPECT_LT(double(drawn(plasma)), 0.75 * double(plasmaLeft));
    see(name + "-3-faded");
    EXPECT_EQ(session::clipState(scene()), session::ClipState::Thinned);
    EXPECT_EQ(drawn(spike), std::uint64_t(spikes)) << "stay as they were set";
    EXPECT_LE(mActions, kMostActions) << mLog.join("; ").toStdString();
    std::vector<std::string> steps = mWindow->document().undoLabels();
    std::erase(steps, "Move view");
    EXPECT_EQ(steps.size(), 3u) << "one for the cut, the spikes and the plasma each";
  }

  int mActions = 0;
  QStringList mLog;
};

TEST_F(EqualizerStudy, AMadeVirusIsCutOpenItsSpikesBroughtBackItsPlasmaFaded) {
  Progress progress;
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(io::makeVirion(progress));
  mWindow->resize(1180, 820);
  mWindow->showScene(scene, "virion");
  drawSoon();
  act("open");
  study("study-virion", "spike", 60, "plasma");
}

TEST_F(EqualizerStudy, TheVirusInBloodIsCutOpenItsSpikesBroughtBackItsPlasmaFaded) {
  const char* folder = std::getenv("VELUM_TEST_DATA");
  if (!folder) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes";
  mWindow->resize(1400, 940);
  mWindow->openPaths({QString("%1/mesoscale/hiv-blood/BloodHIV1.0_mixed_fixed_nc1.cpr").arg(folder)});
  ASSERT_TRUE(waitForJob());
  drawSoon();
  act("open");
  study("study-hiv", "HIV1_ENV_4nco_0_1_1", 10, "cytoplasme");
}

}  // namespace velum::gui
