// Opens a file, cuts it open, draws a picture of it and saves it, and draws a film: example INPUT OUTPUT.png [FILM]
#include <velum/film.h>
#include <velum/labels.h>
#include <velum/log.h>
#include <velum/mesh.h>
#include <velum/model.h>
#include <velum/session.h>
#include <velum/volume.h>

#include <cstdio>
#include <string>

int main(int count, char** arguments) try {
  if (count != 3 && count != 4) throw velum::ArgumentError("usage: example INPUT OUTPUT.png [FILM]");
  std::string input = arguments[1], output = arguments[2];

  // Long work tells how far it is; progress.cancel(), from another thread, makes it throw velum::Cancelled.
  velum::Progress progress([](double fraction, const std::string& what) {
    std::fprintf(stderr, "\r%3.0f %% %-40s", 100.0 * fraction, what.c_str());
  });

  // What is open. All that can be done to it is a command, by its name in docs/COMMANDS.md; here one at a time ...
  velum::Session session;
  velum::run(session, velum::parseCall("open " + input), progress);

  // ... and here as the text of a script, which is told what there is to tell.
  velum::runScript(session, "cut.add plane\nview.from left\n", "example", progress,
                   [](const velum::Call& call, const std::string& told) {
                     std::fprintf(stderr, "\n%s: %s\n", call.line().c_str(), told.c_str());
                   });

  // The session makes a graphics context of its own when it first needs one; no display is needed. The scene rides in
  // the picture, so that the file opens again as what it shows.
  velum::PictureOptions options;
  options.size = {640, 480};
  velum::Image picture = session.picture(options, progress);
  velum::savePicture(picture, session.scene(), options, output);
  std::printf("\n%s: %d x %d pixels, %zu cut\n", output.c_str(), picture.width, picture.height,
              session.scene().cuts.size());
  if (count < 4) return 0;

  // A film is a part of the scene. A ready-made one writes its keys; others are set by hand, of any field.
  velum::Scene scene = session.scene();
  velum::addReadyFilm(scene, velum::ReadyFilm::Turn, {.start = 0.0, .seconds = 0.2});
  scene.timeline.duration = 0.2;
  velum::setKey(scene.timeline, "background.top", 0.0, velum::valueAt(scene, "background.top"));
  velum::setKey(scene.timeline, "background.top", 0.2, {"[0.1, 0.2, 0.6]"});
  std::printf("half of the way: top %.2f\n", velum::sceneAt(scene, 0.1).background.top.z);

  // FILM is a video (film.mp4) or a folder of frames; progress.cancel() keeps what has been drawn.
  velum::FilmOutput film;
  film.path = arguments[3];
  film.picture.size = {160, 120};
  velum::FilmReport made = velum::Session(scene).film(film, progress);
  std::printf("\n%s: %d of %d frames\n", arguments[3], made.drawn, made.frames);
  return made.failed.empty() ? 0 : 1;
} catch (const velum::Error& error) {
  std::fprintf(stderr, "\nexample: %s\n", error.what());
  return static_cast<int>(error.exitCode());
}
