// A document is one picture: the window, velum-batch, a script and a session without a window draw the same bytes of
// it.
#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <future>

#include "RunBatch.h"
#include "WindowFixture.h"
#include "session/Session.h"
#include "session/command/CutCommands.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LetteringCommands.h"
#include "session/command/LookCommands.h"
#include "session/command/ModelCommands.h"
#include "session/command/StructureCommands.h"
#include "session/command/ViewCommands.h"
#include "session/extrusion/GrowStructure.h"
#include "session/film/MakeFilm.h"
#include "session/film/ReadyFilms.h"
#include "session/membrane/HangMembrane.h"

namespace velum::gui {
namespace {

class SameBytes : public Window {
 protected:
  static constexpr glm::ivec2 kSize{96, 72};

  session::PictureOptions options() const { return {kSize, 1, false, false, 0}; }
  QString file(const char* name) const { return path(name); }
  std::string text(const char* name) const { return path(name).toStdString(); }

  /// On a thread of its own: the window's context may be current on this one, where no other could be made then.
  static void aside(const std::function<void()>& work) { std::async(std::launch::async, work).get(); }

  void open(session::Session& session, const std::vector<std::string>& paths) {
    session::Loaded loaded = session::readPaths(paths, mProgress, {});
    session.file().open(std::move(loaded), paths[0]);
    session::run(session, session::LookFirst{4.0 / 3.0}, mProgress);
  }

  /// A scene file of what is made of some data.
  /// @param make  runs commands
  void save(const std::vector<std::string>& paths, const std::function<void(session::Session&)>& make) {
    aside([&] {
      session::Session session;
      open(session, paths);
      make(session);
      // Pictures that are complete soon; light is the same for all.
      for (const char* field : {"lighting.shadow", "lighting.occlusion"})
        session::run(session, session::SetField{field, "0"}, mProgress);
      session.settle(mProgress);
      session.file().save(text("scene.json"));
    });
  }

  /// All four ways to a picture of scene.json.
  void expectOnePicture() {
    mWindow->openPaths({file("scene.json")});
    ASSERT_TRUE(waitForJob());
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->session().isSettled(); }, kPatience));
    aside([&] { session::Session(scene()).savePicture(options(), {}, text("picture.png"), mProgress); });
    QByteArray byWindow = bytesOf(file("picture.png"));
    ASSERT_FALSE(byWindow.isEmpty());

    QFile::remove(file("picture.png"));
    runBatch({"render", file("scene.json"), "-o", file("picture.png"), "--size", "96x72", "--samples", "1"});
    EXPECT_TRUE(bytesOf(file("picture.png")) == byWindow) << "velum-batch render";

    QFile::remove(file("picture.png"));
    std::ofstream(text("script.txt")) << "open " << text("scene.json") << "\npicture 96x72 samples=1 "
                                      << text("picture.png") << "\n";
    runBatch({"run", file("script.txt")});
    EXPECT_TRUE(bytesOf(file("picture.png")) == byWindow) << "a script";

    QFile::remove(file("picture.png"));
    aside([&] {
      session::Session bare;
      bare.file().open(session::readPaths({text("scene.json")}, mProgress, {}), text("scene.json"));
      bare.savePicture(options(), {}, text("picture.png"), mProgress);
    });
    EXPECT_TRUE(bytesOf(file("picture.png")) == byWindow) << "a session";
  }

  void run(session::Session& session, const session::Call& call) { session::run(session, call, mProgress); }

  Progress mProgress;
};

TEST_F(SameBytes, OfAVolumeWithAFinish) {
  save({text("phantom.nrrd")}, [this](auto& session) {
    run(session, session::ChooseFinish{"plate"});
    run(session, session::AddCut{scene::CutShape::Plane, "Plane"});
  });
  expectOnePicture();
}

TEST_F(SameBytes, OfStructuresThatACutSpares) {
  save({text("phantom.nrrd"), text("phantom_labels.seg.nrrd")}, [this](auto& session) {
    run(session, session::AddCut{scene::CutShape::Box, "Box"});
    run(session, session::SetField{"cuts.0.spares", "1"});
  });
  expectOnePicture();
}

TEST_F(SameBytes, OfAPassiveMembrane) {
  save({text("phantom.nrrd")}, [this](auto& session) { run(session, session::HangMembrane{}); });
  expectOnePicture();
}

/// Its shape at rest is in the scene; where it is moved it goes on from there.
TEST_F(SameBytes, OfAnActiveMembraneThatHasMoved) {
  save({text("phantom.nrrd")}, [this](auto& session) {
    run(session, session::HangMembrane{});
    run(session, session::SetField{"cuts.0.membrane.repositioning", "active"});
    session.settle(mProgress);
    ASSERT_FALSE(session.scene().cuts[0].membrane->shape.places.empty());
    glm::dvec3 moved = session.scene().cuts[0].centre + glm::dvec3(1.0, 2.0, 0.0);
    run(session, session::SetField{"cuts.0.centre", fmt::format("{},{},{}", moved.x, moved.y, moved.z)});
  });
  expectOnePicture();
}

TEST_F(SameBytes, OfAStructureThatWasGrown) {
  save({text("phantom.nrrd")}, [this](auto& session) {
    const Volume& volume = *session.scene().volume.data;
    session::GrowStructure grow;
    grow.seeds = {glm::dvec3(volume.worldFromVoxel * glm::dvec4(glm::dvec3(volume.dims) * 0.5, 1.0))};
    grow.range = {volume.range.x, volume.range.y};
    grow.name = "all";
    run(session, grow);
    session.grow(mProgress);
    ASSERT_TRUE(session.scene().labels.data);
    run(session, session::AddCut{scene::CutShape::Plane, "Plane"});
  });
  expectOnePicture();
}

TEST_F(SameBytes, OfAModelThinnedByACut) {
  runBatch({"sample", "virion", "-o", file("virion.cif")});
  save({text("virion.cif")}, [this](auto& session) {
    run(session, session::AddCut{scene::CutShape::Plane, "Plane"});
    run(session, session::LeaveTypes{{"root"}, 0.25, "Plane"});
  });
  expectOnePicture();
}

TEST_F(SameBytes, OfAModelWithALegendAndAScaleBar) {
  runBatch({"sample", "virion", "-o", file("virion.cif")});
  save({text("virion.cif")}, [this](auto& session) {
    run(session, session::RenameType{session::typeNames(session.scene(), {0})[0], "What the author calls it"});
    run(session, session::SetField{"lettering.legend", "true"});
    run(session, session::SetField{"lettering.scaleBar", "true"});
  });
  expectOnePicture();
}

/// What comes out of a cut frame by frame, as the window and the command line write it.
TEST_F(SameBytes, OfTheFramesOfAnAnimation) {
  save({text("phantom.nrrd"), text("phantom_labels.seg.nrrd")}, [this](auto& session) {
    run(session, session::AddCut{scene::CutShape::Plane, "Plane"});
    run(session, session::SetField{"cuts.0.spares", R"([{"structure": 1, "distance": 12}])"});
    run(session, session::HangMembrane{});
  });
  mWindow->openPaths({file("scene.json")});
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->session().isSettled(); }, kPatience));
  session::FilmOutput output{text("film.png"), options()};
  aside(
      [&] { session::Session(session::withReadyFilm(scene(), session::ReadyFilm::Pull, 2)).film(output, mProgress); });
  std::vector<std::filesystem::path> files;
  for (int i : {0, 1}) files.push_back(session::FrameNames(output.path).frame(i));
  std::vector<QByteArray> byWindow;
  for (const auto& path : files) byWindow.push_back(bytesOf(QString::fromStdString(path.string())));
  EXPECT_NE(byWindow[0], byWindow[1]);
  runBatch({"film", file("scene.json"), "-o", file("film.png"), "--size", "96x72", "--samples", "1", "--frames", "2",
            "--animate", "pull overlap=0 hold=0"});
  for (std::size_t i = 0; i < files.size(); ++i)
    EXPECT_TRUE(bytesOf(QString::fromStdString(files[i].string())) == byWindow[i]) << i;
}

}  // namespace
}  // namespace velum::gui
