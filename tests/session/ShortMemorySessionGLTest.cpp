// A card without memory while sheets move, pictures are made and things are counted: words, and all goes on afterwards.
#include "GlFixture.h"
#include "io/phantoms/Sample.h"
#include "makeModel.h"
#include "session/Session.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/DefaultField.h"
#include "session/membrane/Membranes.h"
#include "session/picture/Picture.h"
#include "session/picture/PresetPictures.h"
#include "shortMemory.h"
#include "vector/Drawing.h"

namespace velum::session {
namespace {

using Which = gpu::AllocationFault::Which;

class ShortMemorySession : public GlTest {
 protected:
  scene::Scene phantom() {
    scene::Scene scene;
    io::Sample sample = io::makeSample("two-spheres", 32, mProgress);
    scene.volume.data = Shared<Volume>(std::move(sample.volume));
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.25);
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.rayCast.samplesPerPixel = 1;
    return scene;
  }
  static void addMembrane(Session& session, scene::Repositioning repositioning) {
    scene::Cut cut = makeCut(session.scene(), scene::CutShape::Membrane);
    cut.membrane->field = defaultField(session.scene());
    cut.membrane->repositioning = repositioning;
    session.document().edit("Add membrane", [&](scene::Scene& scene) { scene::addCut(scene, cut); });
  }
  static std::vector<glm::vec3> placesOf(const Session& session) {
    return session.membranes().withShapes(session.scene()).cuts[0].membrane->shape.places;
  }

  Progress mProgress;
};

TEST_F(ShortMemorySession, ASheetThatCannotMoveMovesLater) {
  for (auto repositioning : {scene::Repositioning::Passive, scene::Repositioning::Active}) {
    Session session(phantom());
    session.borrowContext();
    addMembrane(session, repositioning);
    session.settle(mProgress);
    int id = session.scene().cuts[0].id;
    auto hangAgain = [&] {
      session.releaseGpu();
      session.membranes().reset(id);
    };
    auto move = [&] {
      session.settle(mProgress);
      session.frame({40, 32});
    };
    hangAgain();
    std::vector<std::string> asked;
    {
      gpu::AllocationFault count;
      move();
      asked = count.asked();
    }
    std::vector<glm::vec3> wanted = placesOf(session);
    EXPECT_GE(firstOfEach(asked).size(), 10u);
    for (std::size_t n : firstOfEach(asked))
      for (Which which : {Which::NthLate, Which::NthOn}) {
        std::string what = "allocation " + std::to_string(n) + " (" + asked[n - 1] + ")";
        hangAgain();
        EXPECT_NE(refusalOf(which, n, move), "") << what;
        move();
        EXPECT_TRUE(placesOf(session) == wanted) << "after " << what;
      }
    session.releaseGpu();
  }
}

TEST_F(ShortMemorySession, PicturesAndPlatesSayItAndAreRightAfterwards) {
  Session session(phantom());
  addMembrane(session, scene::Repositioning::Passive);
  PictureOptions options;
  options.size = {40, 32};
  options.layers = true;
  Image whole = session.picture(options, mProgress);
  for (std::size_t n : {1, 3, 6}) {
    PictureOptions larger = options;
    larger.size += int(n);
    EXPECT_NE(refusalOf(Which::NthOn, n, [&] { session.picture(larger, mProgress); }), "") << n;
    Image image = session.picture(options, mProgress);
    EXPECT_EQ(image.channels, whole.channels);
    EXPECT_TRUE(image.pixels == whole.pixels) << n;
    EXPECT_NE(refusalOf(Which::NthOn, n, [&] { session.plate(larger, std::nullopt, mProgress); }), "") << n;
  }
}

TEST_F(ShortMemorySession, SmallPicturesSayIt) {
  int drawn = 0;
  auto draw = [&] {
    drawPresetPictures(
        phantom(), {"ct-bone", "ct-skin"}, {24, 16}, [&](const std::string&, const Image&) { ++drawn; }, mProgress);
  };
  EXPECT_NE(refusalOf(Which::NthOn, 1, draw), "");
  EXPECT_EQ(drawn, 0);
  draw();
  EXPECT_EQ(drawn, 2);
}

TEST_F(ShortMemorySession, CountsAreNeverThoseOfHalfAPicture) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker().make());
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.25);
  Session session(scene);
  PictureCounter counter = session.counter({48, 40}, mProgress);
  render::InstanceBits wanted = counter.count(scene);
  scene::Scene closer = scene;
  closer.camera.eye = 0.5 * (scene.camera.eye + scene.camera.target);
  auto count = [&](const scene::Scene& of) { return counter.count(of).shown; };
  std::vector<std::uint32_t> wantedCloser = count(closer);
  for (std::size_t n = 1; n <= 24; ++n) {
    refusalOf(Which::NthOn, 1, [&] { count(n % 2 ? scene : closer); });
    std::vector<std::uint32_t> shown;
    std::string words = refusalOf(Which::Nth, n, [&] { shown = count(scene); });
    EXPECT_TRUE(!words.empty() || shown == wanted.shown) << n;
    EXPECT_TRUE(count(closer) == wantedCloser) << "after allocation " << n;
  }
}

}  // namespace
}  // namespace velum::session
