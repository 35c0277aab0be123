#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "growth/GrowOverTime.h"
#include "scene/Scene.h"
#include "session/membrane/MembraneMover.h"
#include "session/picture/Picture.h"

namespace velum::session {

/// What moves in an animation. Turn: the eye goes once round the data. Time: the volume goes through its time steps.
/// Pull: the camera stays and structures are pulled out of the cuts one after the other. Cut: the cuts come and take
/// the instances of a model one by one.
enum class Motion { Turn, Time, Pull, Cut };

/// Time where the volume has several time steps, else Turn.
Motion usualMotion(const scene::Scene& scene);
/// Why a scene has no animation with this motion, for people; empty where it has one.
std::string whyStill(const scene::Scene& scene, Motion motion);

/// The scene of one frame. A turn ends before it is back where it began; Pull begins with no structure that stands out,
/// Cut without cuts (cutPathAt()), and both end with the scene itself.
/// @param frame  0 <= frame < frames
scene::Scene frameOf(const scene::Scene& scene, Motion motion, int frame, int frames);

/// The files of the frames of an animation: NAME-0000.png ...
std::vector<std::filesystem::path> framePaths(const std::filesystem::path& path, int frames);

/// Which pictures to make of a scene: one, or those of an animation; of the 3D view or of a section.
struct FilmOptions {
  PictureOptions picture;
  std::optional<Motion> motion = {};               ///< none: one picture, of the scene as it is
  int frames = 1;                                  ///< of an animation
  std::optional<scene::SectionKind> section = {};  ///< none: the 3D picture
};

/// The files of a film: the path itself for one picture, else framePaths(). @throw ArgumentError where several pictures
/// would go to standard output
std::vector<std::filesystem::path> filmPaths(const FilmOptions& options, const std::filesystem::path& path);

/// The scenes of an animation, with growth and sheets at rest in each. Sheets come to rest anew where the data or their
/// cut is another one than in the frame before; active sheets go on from where they were in that frame.
class Film {
 public:
  struct Frame {
    scene::Scene scene;  ///< the scene that is saved in the picture
    scene::Scene drawn;  ///< the scene that is drawn: with the shapes of its sheets
  };
  /// @throw ArgumentError where whyStill() says why there is no animation
  Film(scene::Scene scene, const FilmOptions& options);
  /// The next frame: to be called frame after frame, from 0. Needs a current GL context where there are membranes.
  /// @throw Cancelled
  Frame at(int frame, Progress& progress);

 private:
  scene::Scene mScene;
  std::optional<Motion> mMotion;
  int mFrames;
  growth::GrowOverTime mGrowths;
  MembraneMover mMembranes{MembraneMover::Purpose::Rest};
};

}  // namespace velum::session

template <>
struct velum::EnumNames<velum::session::Motion> {
  static constexpr std::string_view kNames[] = {"turn", "time", "pull", "cut"};
};
