#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "scene/SceneFwd.h"
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

/// Draws and saves the frames on a headless context of its own. Any thread that has no current context of ours.
/// @throw Cancelled, ArgumentError where whyStill() says why
void renderAnimationFiles(const scene::Scene& scene, Motion motion, int frames, const PictureOptions& options,
                          const std::filesystem::path& path, Progress& progress);

}  // namespace velum::session

template <>
struct velum::EnumNames<velum::session::Motion> {
  static constexpr std::string_view kNames[] = {"turn", "time", "pull", "cut"};
};
