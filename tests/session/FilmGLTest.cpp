// Films with sheets: a frame depends on the film and its number alone.
#include "session/film/Film.h"

#include "GlFixture.h"
#include "io/phantoms/Sample.h"
#include "openedHeart.h"
#include "session/film/ReadyFilms.h"

namespace velum::session {
namespace {

class FilmGL : public GlTest {
 protected:
  /// A sheet that sinks into a beating heart in five frames.
  static scene::Scene filmOf(scene::Repositioning repositioning) {
    static const Shared<Volume> volume(io::makeSample("heart", 40, sProgress, 3).volume);
    scene::Scene scene = openedHeart(volume, repositioning);
    scene.timeline.framesPerSecond = 5.0;
    addTimeSteps(scene, {0.0, 1.0}, 1.0);
    addSinking(scene, {0.0, 1.0}, 0, false);
    return scene;
  }
  static std::vector<scene::SheetShape> shapesOf(Film& film, const std::vector<int>& order) {
    std::vector<scene::SheetShape> shapes(std::size_t(film.count()));
    for (int frame : order) shapes[std::size_t(frame)] = film.at(frame, 0.0, sProgress).drawn.cuts[0].membrane->shape;
    return shapes;
  }
  inline static Progress sProgress;
};

TEST_F(FilmGL, AFrameIsTheSameInWhateverOrderFramesAreDrawn) {
  for (auto repositioning : {scene::Repositioning::Passive, scene::Repositioning::Active}) {
    scene::Scene scene = filmOf(repositioning);
    Film inOrder(scene), mixed(scene), second(scene);
    ASSERT_EQ(inOrder.count(), 5);
    auto shapes = shapesOf(inOrder, {0, 1, 2, 3, 4});
    EXPECT_EQ(shapesOf(mixed, {3, 1, 4, 0, 2}), shapes) << enumName(repositioning);
    // A part of another machine, with blur between: sub-frames leave no trace.
    second.at(3, -0.25, sProgress);
    second.at(3, 0.25, sProgress);
    EXPECT_EQ(second.at(4, 0.0, sProgress).drawn.cuts[0].membrane->shape, shapes[4]) << enumName(repositioning);
    EXPECT_NE(shapes[4], shapes[3]);
  }
}

}  // namespace
}  // namespace velum::session
