// What both programs drive, without a window: open, edit, let sheets settle, save, open again.
#include "session/Session.h"

#include "GlFixture.h"
#include "TempFolder.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "membrane/sheet/SheetIndex.h"
#include "render/Renderer.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/Membranes.h"

namespace velum::session {
namespace {

class SessionGL : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    io::Sample sample = io::makeSample("two-spheres", 32, mProgress);
    io::writeVolume(sample.volume, mFolder / "phantom.nrrd", mProgress);
    mSession = std::make_unique<Session>();
    mSession->borrowContext();
    mSession->file().open(readPaths({(mFolder / "phantom.nrrd").string()}, mProgress, {}), "phantom.nrrd");
  }
  void TearDown() override {
    if (mSession) mSession->releaseGpu();
    mSession.reset();
    GlTest::TearDown();
  }
  void addMembrane(scene::Repositioning repositioning) {
    scene::Cut cut = makeCut(mSession->scene(), scene::CutShape::Membrane);
    cut.membrane->field = defaultField(mSession->scene());
    cut.membrane->repositioning = repositioning;
    mSession->document().edit("Add membrane", [&](scene::Scene& scene) { scene::addCut(scene, cut); });
  }
  scene::SheetShape sheet() { return mSession->membranes().withShapes(mSession->scene()).cuts[0].membrane->shape; }

  TempFolder mFolder;
  Progress mProgress;
  std::unique_ptr<Session> mSession;
};

TEST_F(SessionGL, OpenEditSettleSaveAndOpenAgain) {
  ASSERT_TRUE(mSession->file().isOpen());
  EXPECT_FALSE(mSession->file().isModified());
  addMembrane(scene::Repositioning::Active);
  EXPECT_TRUE(mSession->file().isModified());
  EXPECT_FALSE(mSession->isSettled());
  EXPECT_TRUE(mSession->isOnItsWay());
  mSession->settle(mProgress);
  EXPECT_TRUE(mSession->isSettled());
  // Where an active sheet rests is part of the step that led to it.
  EXPECT_FALSE(mSession->scene().cuts[0].membrane->shape.places.empty());
  EXPECT_EQ(mSession->document().undoLabels(), std::vector<std::string>{"Add membrane"});
  scene::Scene made = mSession->scene();
  render::Frame frame = mSession->frame({40, 30});
  EXPECT_EQ(frame.pictureSize, glm::ivec2(40, 30));
  ASSERT_EQ(frame.sheets.size(), 1u);

  auto path = (mFolder / "work.json").string();
  mSession->file().save(path);
  EXPECT_FALSE(mSession->file().isModified());
  EXPECT_EQ(mSession->file().scenePath(), path);
  mSession->file().close();
  EXPECT_FALSE(mSession->file().isOpen());
  EXPECT_TRUE(mSession->isSettled());
  mSession->file().open(readPaths({path}, mProgress, {}), path);
  mSession->settle(mProgress);
  EXPECT_EQ(mSession->scene().cuts, made.cuts);
  EXPECT_FALSE(mSession->document().canUndo());
}

TEST_F(SessionGL, SettledItsSheetsAreThoseOfAPicture) {
  addMembrane(scene::Repositioning::Passive);
  mSession->settle(mProgress);
  scene::Scene scene = mSession->scene();
  settleMembranes(scene, {}, mProgress);
  // Put into the particles that a picture draws, as the session's are.
  const scene::Cut& cut = scene.cuts[0];
  auto fitted = membrane::fitShape(cut.membrane->shape, cut.membrane->cloth.particles, cut.size);
  EXPECT_TRUE(sheet().places == fitted.places);
}

TEST_F(SessionGL, SettlingCanBeCancelled) {
  addMembrane(scene::Repositioning::Passive);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(mSession->settle(cancelled), Cancelled);
  mSession->settle(mProgress);
  EXPECT_TRUE(mSession->isSettled());
}

}  // namespace
}  // namespace velum::session
