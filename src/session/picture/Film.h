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

/// What goes on in an animation: the eye goes once round the data, the volume through its time steps, or the camera
/// stays and structures are pulled out of the cuts one after the other, or the cuts come and take the instances of a
/// model one by one.
enum class Motion { Turn, Time, Pull, Cut };

/// Time where the volume has some, else a turn.
Motion usualMotion(const scene::Scene& scene);
/// Why a scene has no such animation, for people; empty: it has.
std::string whyStill(const scene::Scene& scene, Motion motion);

/// The scene of one frame. A turn ends before it is back where it began; what is pulled out begins with nothing that
/// stands out, what is cut without cuts (cutPathAt), and both end with the scene itself.
/// @param frame  from 0 to before `frames`
scene::Scene frameOf(const scene::Scene& scene, Motion motion, int frame, int frames);

/// NAME-0000.png ...
std::vector<std::filesystem::path> framePaths(const std::filesystem::path& path, int frames);

/// Which pictures to make of a scene: one, or those of an animation; of the 3D view or of a section.
struct FilmOptions {
  PictureOptions picture;
  std::optional<Motion> motion = {};               ///< none: one picture, of the scene as it is
  int frames = 1;                                  ///< of an animation
  std::optional<scene::SectionKind> section = {};  ///< none: the 3D picture
};

/// The files of a film: the path itself of one picture, else framePaths(). @throw ArgumentError where several would go
/// to standard output
std::vector<std::filesystem::path> filmPaths(const FilmOptions& options, const std::filesystem::path& path);

/// The scenes of an animation, with growth and sheets at rest in each. Sheets lie anew where the data or their cut is
/// another one than in the frame before; active ones go on from where they were in it.
class Film {
 public:
  struct Frame {
    scene::Scene scene;  ///< as it is saved in the picture
    scene::Scene drawn;  ///< with the shapes of its sheets
  };
  /// @throw ArgumentError where whyStill() says why there is no animation
  Film(scene::Scene scene, const FilmOptions& options);
  /// Frame after frame, from 0. Current GL context where there are membranes. @throw Cancelled
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
