// Whenever the driver loses the context, what a session makes is, to the last bit, what it makes otherwise.
#include "gpu/Loss.h"

#include <functional>

#include "FilmFrames.h"
#include "GlFixture.h"
#include "TempFolder.h"
#include "io/phantoms/Sample.h"
#include "makeModel.h"
#include "makeVolume.h"
#include "openedHeart.h"
#include "scene/Navigate.h"
#include "session/Session.h"
#include "session/film/ReadyFilms.h"
#include "session/picture/Picture.h"
#include "session/picture/SmallPictures.h"

namespace velum::session {
namespace {

PictureOptions smallPicture() {
  PictureOptions options;
  options.size = {72, 54};
  options.samples = 2;
  return options;
}

class SessionLossGL : public GlTest {
 protected:
  void TearDown() override {
    gpu::simulateLoss(0);
    GlTest::TearDown();
  }

  /// Does the work without a loss, then with one at the first question, at the second, the third, the fifth and so on,
  /// until there are no more.
  template <class Result>
  void expectTheSame(const scene::Scene& scene, const std::function<Result(Session&)>& work) {
    auto made = [&](int question, int times) {
      Session session(scene);
      session.renderer();
      gpu::simulateLoss(question, times);
      unsigned before = gpu::contextNumber();
      Result result = work(session);
      mLosses = int(gpu::contextNumber() - before);
      gpu::simulateLoss(0);
      return result;
    };
    Result undisturbed = made(0, 0);
    ASSERT_EQ(mLosses, 0);
    int tried = 0;
    for (int question = 1, before = 1;; question += std::exchange(before, question), ++tried) {
      Result result = made(question, question % 2 ? 1 : 2);
      if (mLosses == 0) break;
      EXPECT_EQ(result, undisturbed) << "lost at question " << question;
    }
    EXPECT_GE(tried, 2) << "there was something to lose";
  }

  static std::vector<float> drawn(Session& session) {
    Progress progress;
    return session.picture(smallPicture(), progress).pixels;
  }

  static const Shared<Volume>& heart() {
    static const Shared<Volume> volume([] {
      Progress progress;
      return io::makeSample("heart", 40, progress, 2).volume;
    }());
    return volume;
  }

  int mLosses = 0;
  Progress mProgress;
};

TEST_F(SessionLossGL, AVolumeOpenedByAMembrane) {
  for (auto repositioning : {scene::Repositioning::Passive, scene::Repositioning::Active}) {
    scene::Scene scene = openedHeart(heart(), repositioning);
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 4.0 / 3.0);
    using Made = std::pair<std::vector<float>, scene::SheetShape>;
    expectTheSame<Made>(scene, [&](Session& session) {
      auto pixels = drawn(session);
      return Made(std::move(pixels), session.settled(mProgress).cuts[0].membrane->shape);
    });
  }
}

TEST_F(SessionLossGL, LabelsOfWhichOneIsPulledOutOfACutAndItsLines) {
  io::Sample sample = io::makeSample("two-spheres", 32, mProgress);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(sample.volume));
  scene.labels.data = Shared<LabelVolume>(std::move(sample.labels));
  scene::completeStructures(scene.labels);
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 4.0 / 3.0);
  scene.finish.contours = 1.0;
  scene::Cut cut;
  cut.id = 1;
  cut.axis = {0.2, -1.0, 0.1};
  cut.spares = {{1, 12.0}};
  scene.cuts = {cut};
  expectTheSame<std::vector<float>>(scene, drawn);
}

TEST_F(SessionLossGL, AModelAndItsCounts) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.instances = 120}.make());
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 4.0 / 3.0);
  scene::Cut ball;
  ball.id = 1;
  ball.shape = scene::CutShape::Sphere;
  ball.size = glm::dvec3(250.0);
  scene.cuts = {ball};
  using Made = std::pair<std::vector<float>, std::vector<std::uint32_t>>;
  expectTheSame<Made>(scene, [this](Session& session) {
    PictureCounter counter = session.counter({64, 48}, mProgress);
    auto bits = counter.count(session.scene());
    auto pixels = drawn(session);
    bits.shown.insert(bits.shown.end(), bits.removed.begin(), bits.removed.end());
    return Made(std::move(pixels), bits.shown);
  });
}

TEST_F(SessionLossGL, AFilmGoesOnWithTheFrameThatWasLost) {
  scene::Scene scene = openedHeart(heart(), scene::Repositioning::Active);
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 4.0 / 3.0);
  scene.timeline.framesPerSecond = 3.0;
  addTimeSteps(scene, {0.0, 1.0}, 1.0);
  addSinking(scene, {0.0, 1.0}, 0, false);
  expectTheSame<std::vector<std::string>>(scene, [this](Session& session) {
    TempFolder folder;
    FilmOutput output = outputTo(folder / "frames" / "");
    output.picture = smallPicture();
    FilmReport report = session.film(output, mProgress);
    EXPECT_TRUE(report.failed.empty()) << failedFrames(report);
    return framesOf(output.path, report.frames);
  });
}

TEST_F(SessionLossGL, ASheetOnItsWayGoesOnFromWhereItHung) {
  scene::Scene scene = openedHeart(heart(), scene::Repositioning::Active);
  auto shapeOf = [&](const MembraneMover& mover) { return mover.withShapes(scene).cuts[0].membrane->shape; };
  MembraneMover mover, undisturbed;
  for (MembraneMover* one : {&mover, &undisturbed}) {
    one->follow(scene);
    one->endWork(one->nextWork()(mProgress));
    for (int i = 0; i < 3; ++i) one->stepOnce();
    one->setPlaying(false);
  }
  int steps = mover.status(1)->steps;
  ASSERT_EQ(shapeOf(mover), shapeOf(undisturbed));
  ASSERT_EQ(undisturbed.status(1)->steps, steps);
  mover.releaseGpu();
  EXPECT_EQ(mover.status(1)->phase, MembraneStatus::Phase::Paused);
  mover.advance(1.0);
  EXPECT_EQ(mover.status(1)->steps, steps);
  EXPECT_EQ(shapeOf(mover), shapeOf(undisturbed));
  EXPECT_FALSE(shapeOf(mover).places.empty());
  mover.releaseGpu(), undisturbed.releaseGpu();
}

TEST_F(SessionLossGL, PicturesToChooseFromAreDrawnAllTheSame) {
  scene::Scene scene;
  scene.volume.data = heart();
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  auto made = [&] {
    std::vector<std::vector<float>> pictures;
    drawSmallPictures(
        {"a", "b", "c"}, {32, 32}, [&](const std::string&) { return scene; },
        [&](const std::string&, const Image& image) { pictures.push_back(image.pixels); }, mProgress);
    return pictures;
  };
  auto undisturbed = made();
  for (int question : {1, 2, 4, 6}) {
    gpu::simulateLoss(question);
    EXPECT_EQ(made(), undisturbed) << question;
  }
}

TEST_F(SessionLossGL, ADriverThatIsResetAgainAndAgainIsAnErrorAndTheDocumentStays) {
  scene::Scene scene = openedHeart(heart(), scene::Repositioning::Passive);
  Session session(scene);
  session.document().edit("Turn", [](scene::Scene& of) { of.camera = scene::orbit(of.camera, {0.2, 0.1}); });
  scene::Scene before = session.scene();
  gpu::simulateLoss(1, 100);
  EXPECT_THROW(drawn(session), gpu::ContextLost);
  gpu::simulateLoss(0);
  EXPECT_EQ(session.scene(), before);
  EXPECT_EQ(session.document().undoLabels(), std::vector<std::string>{"Turn"});
  // And afterwards it draws what it would have drawn.
  auto pixels = drawn(session);
  Session other(before);
  EXPECT_EQ(drawn(other), pixels);
}

}  // namespace
}  // namespace velum::session
