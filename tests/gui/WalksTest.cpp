// From a file to a picture that could be printed, by the hand's own events, which are counted: nobody should need more.
// With VELUM_SHOTS each step's window is kept.
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>
#include <cstdio>

#include "PullFixture.h"
#include "gui/kit/Preferences.h"
#include "gui/window/SavePictureDialog.h"
#include "scene/Finishes.h"

namespace velum::gui {

class Walks : public PullFixture {
 protected:
  void SetUp() override {
    PullFixture::SetUp();
    bool isShown = qEnvironmentVariableIsSet("VELUM_SHOTS");
    if (isShown) mWindow->resize(1280, 800);
    Preferences().setValue("picture/size", isShown ? QVariant() : QSize(640, 360));
    mClock.start();
  }
  void TearDown() override {
    Preferences().setValue("picture/size", {});
    PullFixture::TearDown();
  }
  static QString dataFile(const char* name) { return qEnvironmentVariable("VELUM_TEST_DATA") + "/volumes/" + name; }
  /// What the hand has done: one click, key, drag or typed word more.
  void did(const char* what) {
    ++mActions;
    bool isSettled = settle();
    std::printf("%5.1f s  %2d  %s\n", 0.001 * double(mClock.elapsed()), mActions, what);
    takeShot(*mWindow, QString("walk-%1-%2").arg(mName).arg(mActions, 2, 10, QChar('0')));
    ASSERT_TRUE(isSettled) << what;
  }
  void click(const char* list, const char* name) {
    auto* of = child<QListWidget>(list);
    ASSERT_TRUE(of);
    for (int i = 0; i < of->count(); ++i) {
      QListWidgetItem* item = of->item(i);
      if (item->data(Qt::UserRole).toString() != name) continue;
      ASSERT_FALSE(item->isHidden()) << name << " is not seen";
      of->scrollToItem(item);
      return QTest::mouseClick(of->viewport(), Qt::LeftButton, {}, of->visualItemRect(item).center());
    }
    FAIL() << name;
  }
  void showPage(const char* page) { ASSERT_TRUE(mWindow->tabs().showPage(page)) << page; }
  /// The key, the dialog as it comes up, and a name.
  void savePicture() {
    auto path = (*sFolder / (mName.toStdString() + ".png")).string();
    QTimer timer;
    int dialogs = 0;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      QWidget* modal = QApplication::activeModalWidget();
      if (auto* dialog = qobject_cast<QFileDialog*>(modal); dialog && dialogs == 1) {
        ++dialogs;
        // A whole path, typed: where a file is selected the dialog looks for its folder beside, and Return may be
        // first.
        auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
        ASSERT_TRUE(name);
        name->setText(QString::fromStdString(path));
        static_cast<QDialog*>(dialog)->accept();
      } else if (auto* picture = qobject_cast<SavePictureDialog*>(modal); picture && dialogs == 0) {
        takeShot(*picture, "walk-" + mName + "-dialog");
        ++dialogs;
        picture->accept();
      }
    });
    timer.start(50);
    mActions += 2;  // the dialog's Return, the file's name
    mWindow->actions().find("file.savePicture")->trigger();
    ASSERT_EQ(dialogs, 2);
    ASSERT_TRUE(waitForJob());
    did("saves the picture");
    QImage picture(QString::fromStdString(path));
    ASSERT_FALSE(picture.isNull());
    EXPECT_GE(picture.width(), 640);
    if (QString shots = qEnvironmentVariable("VELUM_SHOTS"); !shots.isEmpty())
      picture.save(shots + "/walk-" + mName + ".png");
  }
  /// Well inside of what is wanted on the face of the first cut, as the eye chooses it.
  std::optional<Seen> placeOn(const std::function<bool(const Seen&)>& isWanted) {
    std::vector<Seen> wanted;
    for (const Seen& seen : look(4))
      if (isOnFace(seen, cut()) && isWanted(seen)) wanted.push_back(seen);
    std::optional<Seen> best;
    int most = -1;
    for (const Seen& one : wanted) {
      auto isNear = [&](const Seen& other) { return (other.pixel - one.pixel).manhattanLength() <= 16; };
      if (int near = int(std::count_if(wanted.begin(), wanted.end(), isNear)); near > most) most = near, best = one;
    }
    return best;
  }
  /// How much of the picture is not its ground.
  double covered() {
    std::size_t hits = look(8).size();
    return double(hits) * 64.0 / (double(viewport().width()) * viewport().height());
  }
  void end(int most) {
    std::printf("%s: %d actions, %.1f s\n", mName.toUtf8().constData(), mActions, 0.001 * double(mClock.elapsed()));
    EXPECT_LE(mActions, most);
  }
  QString mName;
  int mActions = 0;
  QElapsedTimer mClock;
};

TEST_F(Walks, FromAHeadToAPlateWithAMembrane) {
  QString head = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!QFile::exists(head)) GTEST_SKIP() << head.toStdString() << ": install invesalius-examples";
  mName = "head";
  open({head});
  did("opens a scan, whose look is bone");
  press("M");
  ASSERT_TRUE(waitForJob());
  did("hangs a membrane");
  ASSERT_EQ(scene().cuts.size(), 1u);
  auto status = viewport().membranes().status(cut().id);
  ASSERT_TRUE(status && status->isMeasured);
  EXPECT_GE(status->fate.kept, 0.9) << "of the bone";
  EXPECT_GT(status->planePairs, 0) << "a plane in its place would cut it";
  showPage("Look");
  did("turns to the page Look");
  click("preset", "ct-skin-white-bone");
  did("chooses skin with white bone beneath");
  mWindow->actions().find("look.hideTable")->trigger();
  did("hides the head rest");
  showPage("Finish");
  did("turns to the page Finish");
  click("finish", "plate");
  did("chooses the plate");
  EXPECT_EQ(scene::finishName(scene()), "plate");
  EXPECT_GT(covered(), 0.1);
  savePicture();
  end(10);
}

TEST_F(Walks, FromAHeartToAPlateOfWhatIsPulledOut) {
  if (!qEnvironmentVariableIsSet("VELUM_TEST_DATA")) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of volumes";
  mName = "heart";
  open({dataFile("ct_heart_aorta_cta.nii.gz")});
  did("opens a scan");
  press("U");
  did("takes up the tool, which brings a plane");
  ASSERT_EQ(scene().cuts.size(), 1u);
  press("0");
  did("looks obliquely");
  auto aorta = placeOn([](const Seen& seen) { return seen.pick.value > 330.0 && seen.pick.value < 520.0; });
  ASSERT_TRUE(aorta);
  pull(aorta->pixel, aorta->pick.world, cut(), 25.0);
  did("pulls the vessel out");
  auto out = session::extrusionsOf(scene());
  ASSERT_EQ(out.size(), 1u);
  EXPECT_GT(out[0].distance, 15.0);
  showPage("Finish");
  did("turns to the page Finish");
  click("finish", "plate");
  did("chooses the plate");
  press("U");
  did("lays the tool down");
  EXPECT_GT(covered(), 0.1);
  savePicture();
  end(12);
}

TEST_F(Walks, FromAStackWithLabelsToItsPicture) {
  if (!qEnvironmentVariableIsSet("VELUM_TEST_DATA")) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of volumes";
  mName = "cells";
  open({dataFile("micro_axons_120.tif"), dataFile("micro_axons_120_labels.tif")});
  did("opens a stack and its labels");
  ASSERT_TRUE(scene().labels.data);
  EXPECT_GT(covered(), 0.05) << "something is seen at once";
  savePicture();
  end(5);
}

}  // namespace velum::gui
