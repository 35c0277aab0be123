// Numbers of a model are read whole, whatever they are and however large letters are; Enter enters them and does
// nothing else.
#include <QLineEdit>
#include <QLocale>
#include <algorithm>

#include "ModelFixture.h"
#include "patience.h"

namespace velum::gui {
namespace {

constexpr std::uint64_t kMost = 10'000'000;

/// All ends of decades with what is beside them, what was once shown as "7...6", and some between.
std::vector<std::uint64_t> countsTo(std::uint64_t most) {
  std::vector<std::uint64_t> counts{0, 5, 88, 72766, most};
  for (std::uint64_t power = 1; power <= most; power *= 10)
    for (std::uint64_t count : {power - 1, power, power + 1, 4 * power, 8 * power}) counts.push_back(count);
  for (std::uint64_t count = 3; count < most; count = count * 7 / 5 + 1) counts.push_back(count);
  std::erase_if(counts, [&](std::uint64_t count) { return count > most; });
  return counts;
}

class ModelNumbers : public ModelWindow {
 protected:
  void SetUp() override {
    mFont = qApp->font();
    mLocale = QLocale();
    Window::SetUp();
  }
  void TearDown() override {
    QLocale::setDefault(mLocale);
    qApp->setFont(mFont);
    Window::TearDown();
  }
  /// A model of one type of so many instances, which no picture has counted: the list shows it, nobody draws it.
  static scene::ModelLayer layerOf(std::uint64_t instances) {
    Model model = ModelMaker{.types = 1, .instances = 1}.make();
    model.types[0].instanceCount = std::uint32_t(instances);
    scene::ModelLayer layer;
    layer.data = Shared<Model>(std::move(model));
    return layer;
  }
  /// Each number has room in its column, and the cell says all of it.
  static void expectWhole(ModelList& list, const QString& text, const std::string& where) {
    int room = list.columnWidth(ModelTree::Count) - 2 * ModelDelegate::kTextMargin;
    EXPECT_LE(QFontMetrics(list.font()).horizontalAdvance(text), room) << where << ": " << text.toStdString();
  }
  QFont mFont;
  QLocale mLocale;
};

TEST_F(ModelNumbers, AreReadWholeFromNoneToTenMillions) {
  QStringList locales{"C", "en_US", "de_DE", "fr_FR", "de_CH", "en_IN", "ar_EG", "hi_IN"};
  for (double size : {1.0, 1.6}) {
    QFont font = mFont;
    font.setPointSizeF(size * mFont.pointSizeF());
    qApp->setFont(font);
    QApplication::processEvents();
    for (const QString& locale : locales) {
      QLocale::setDefault(QLocale(locale));
      ModelList list(mWindow->models().commands(), mWindow->models().equalizer(), mWindow.get());
      for (std::uint64_t total :
           {1ull, 9ull, 10ull, 999ull, 1000ull, 72766ull, 99999ull, 1000000ull, 9999999ull, 10000000ull}) {
        list.showLayer(layerOf(total));
        std::string where = locale.toStdString() + ", of " + std::to_string(total);
        QModelIndex cell = list.order().mapFromSource(list.tree().indexOfType(0, ModelTree::Count));
        ASSERT_EQ(cell.data().toString(), QLocale().toString(qulonglong(total))) << where;
        int room = list.columnWidth(ModelTree::Count) - 2 * ModelDelegate::kTextMargin;
        EXPECT_EQ(ModelDelegate::textOf(cell, QFontMetrics(list.font()), room), cell.data().toString()) << where;
        for (std::uint64_t count : countsTo(total))
          for (bool isPercent : {false, true}) expectWhole(list, ModelTree::drawnText(count, total, isPercent), where);
      }
    }
  }
}

TEST_F(ModelNumbers, AColumnFollowsTheSizeOfLetters) {
  openModel();
  int before = list().columnWidth(ModelTree::Count);
  list().showLayer(layerOf(kMost));
  int many = list().columnWidth(ModelTree::Count);
  EXPECT_GT(many, before);
  QFont font = list().font();
  font.setPointSizeF(2.0 * font.pointSizeF());
  list().setFont(font);
  QApplication::processEvents();
  EXPECT_GT(list().columnWidth(ModelTree::Count), many + 20);
}

TEST_F(ModelNumbers, AFewAreNotNoneAndNearlyAllAreNotAll) {
  auto percent = [](std::uint64_t count, std::uint64_t total) { return ModelTree::drawnText(count, total, true); };
  for (std::uint64_t total : {1000ull, 1001ull, 5000ull, 72766ull, 10000000ull})
    for (std::uint64_t count : countsTo(total)) {
      EXPECT_EQ(percent(count, total) == "0 %", count == 0) << count << " of " << total;
      EXPECT_EQ(percent(count, total) == "100 %", count == total) << count << " of " << total;
      EXPECT_NE(percent(count, total), "0.0 %") << count << " of " << total;
      EXPECT_NE(percent(count, total), "100.0 %") << count << " of " << total;
    }
  EXPECT_EQ(percent(1, 10000000), "< 0.1 %");
  EXPECT_EQ(percent(9999999, 10000000), "> 99.9 %");
  EXPECT_EQ(percent(999, 1000), "99.9 %");
  EXPECT_EQ(percent(500, 1000), "50 %");
  EXPECT_EQ(percent(0, 0), "0 %");
}

/// What a hand does: a double click on the number, keys to whatever has the keyboard.
TEST_F(ModelNumbers, EnterInAFieldEntersTheNumberAndLeavesTheCamera) {
  openModel();
  ASSERT_TRUE(settle());
  for (Qt::Key enter : {Qt::Key_Return, Qt::Key_Enter}) {
    scene::Camera before = scene().camera;
    std::size_t cuts = scene().cuts.size();
    QPoint place = list().cellOfType(3, ModelTree::Count).center();
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, place);
    auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(field && field->objectName() == "modelNumber");
    field->selectAll();
    QTest::keyClicks(QApplication::focusWidget(), enter == Qt::Key_Return ? "71" : "60");
    QTest::keyClick(QApplication::focusWidget(), enter);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !list().findChild<QLineEdit*>("modelNumber"); }, 2000));
    QTest::qWait(600);  // longer than a flight
    EXPECT_EQ(scene().camera, before);
    EXPECT_EQ(mWindow->document().undoLabel(), "Set number of type3");
    EXPECT_EQ(scene().cuts.size(), std::max<std::size_t>(cuts, 1));
  }
  // On the row itself it still goes there.
  scene::Camera before = scene().camera;
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().cellOfType(3, ModelTree::Name).center());
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !(scene().camera == before); }, 2000));
}

TEST_F(ModelNumbers, LinksInNamesAndDescriptionsAreReadAsTheirWords) {
  Model model = ModelMaker{.types = 2, .instances = 20}.make();
  model.types[0].name = "[Spike_protein](https://x)";
  model.types[0].description = "The <a href=\"https://x.org\">envelope</a>'s [trimer](https://www.rcsb.org/4nco).";
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(std::move(model));
  mWindow->resize(1100, 860);
  mWindow->showScene(scene, "made");
  drawSoon();
  mWindow->actions().find("model.legend")->trigger();
  ASSERT_TRUE(settle());
  QModelIndex name = list().tree().indexOfType(0, ModelTree::Name);
  EXPECT_EQ(name.data().toString(), "Spike protein");
  QString tip = name.data(Qt::ToolTipRole).toString();
  EXPECT_TRUE(tip.contains("The envelope's trimer.")) << tip.toStdString();
  EXPECT_FALSE(tip.contains("http")) << tip.toStdString();
  EXPECT_TRUE(mWindow->models().lettering().names()[0] == "Spike protein" ||
              mWindow->models().lettering().names()[1] == "Spike protein");
}

}  // namespace
}  // namespace velum::gui
