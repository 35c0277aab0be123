#pragma once
#include "core/Task.h"
#include "growth/GrowOverTime.h"
#include "scene/Scene.h"
#include "scene/timeline/SceneAt.h"
#include "session/membrane/MembraneMover.h"

namespace velum::session {

/// The scenes of a film, with growth and sheets at rest in each. A frame depends on the film and its number alone:
/// passive sheets come to rest from flat; active sheets that the film moves go from frame to frame, from the first, so
/// that a frame asked for out of order costs the sheets of those before it.
class Film {
 public:
  struct Frame {
    scene::Scene scene;  ///< the scene that is saved in the picture
    scene::Scene drawn;  ///< the scene that is drawn: with the shapes of its sheets
  };
  /// @param scene  its timeline is the film
  explicit Film(scene::Scene scene);
  int count() const { return mFrames.count; }
  const scene::FilmFrames& frames() const { return mFrames; }
  /// A moment of the film. Needs a current GL context where there are membranes.
  /// @param share  beside the moment of the frame, as a share of the time between frames: motion blur
  /// @throw Cancelled, InputError where forces cannot be made
  Frame at(int frame, double share, Progress& progress);

 private:
  scene::Scene sceneOf(int frame, double share, Progress& progress);
  Frame fromRest(scene::Scene scene, Progress& progress);
  Frame alongFilm(scene::Scene scene, Progress& progress);
  void goTo(int frame, Progress& progress);

  scene::Scene mScene;
  scene::FilmFrames mFrames;
  growth::GrowOverTime mGrowths;
  MembraneMover mMembranes{MembraneMover::Purpose::Rest};
  bool mFollows;        ///< some sheet's rest follows from how the film moves it
  int mRestsAt = -1;    ///< the frame for which `mRests` has shapes; -1: none, the sheets are flat
  scene::Scene mRests;  ///< at that frame
};

}  // namespace velum::session
