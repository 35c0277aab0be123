#pragma once
#include <map>
#include <memory>
#include <optional>

#include "render/Renderer.h"
#include "session/film/Film.h"
#include "session/film/FilmNames.h"
#include "session/film/MakeFilm.h"

namespace velum::session {

class Session;

/// Draws the frames of a scene's film, each at rest, with its lettering. GL thread, but for sections of scenes without
/// membranes.
class FilmDrawer {
 public:
  /// @param renderer, limits  of the context that draws; null: there is none  @param output  outlives this object
  FilmDrawer(const scene::Scene& scene, const FilmOutput& output, render::Renderer* renderer,
             const gpu::Limits* limits);
  int count() const { return mFilm.count(); }
  /// See FrameSource. @throw Cancelled, gpu::GpuError, InputError where forces cannot be made
  FilmFrame draw(int frame, double share, Progress& progress);

 private:
  const std::map<int, Measured>& measured(const scene::Scene& scene, Progress& progress);
  FilmNames::Look lookAt(int frame, Progress& progress);

  const FilmOutput& mOutput;
  render::Renderer* mRenderer;
  const gpu::Limits* mLimits;
  Film mFilm;
  std::unique_ptr<Film> mAhead;  ///< where names are looked at before the film is there
  std::optional<FilmNames> mNames;
  scene::Scene mMeasuredOf;  ///< what `mMeasured` depends on
  std::map<int, Measured> mMeasured;
};

/// The frames of a scene's film, drawn by a session that owns its context. The session and `output` outlive the source;
/// it is made, called and destroyed in the session's thread. @throw gpu::GpuError, ArgumentError
FrameSource framesOf(Session& session, const scene::Scene& scene, const FilmOutput& output);
/// Draws and writes the film of a scene, see Session::film().
FilmReport drawFilm(Session& session, const scene::Scene& scene, FilmOutput output, Progress& progress);

}  // namespace velum::session
