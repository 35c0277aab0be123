#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "gpu/Context.h"
#include "render/Counts.h"
#include "render/Frame.h"
#include "render/Streaming.h"

namespace velum::render {

/// What happened while drawing.
struct Stats {
  std::string renderer;        ///< GL_RENDERER
  double frameMs = 0;          ///< Time of the last complete frame, all samples, without uploads.
  double uploadMs = 0;         ///< Time of the last upload of data.
  double longestStepMs = 0;    ///< Longest single piece of GL work of this frame.
  int samples = 0;             ///< Samples per pixel that are complete.
  std::size_t pixelsCast = 0;  ///< Pixels through which rays were cast, over all samples, and again where bricks came.
  std::map<std::string, double> passesMs;  ///< By pass, of the last complete frame.
  std::size_t labelBytes = 0;              ///< Bytes of labels that were sent to the GPU for this frame.
  std::string reduction;  ///< In words for people, when the data is shown at reduced resolution; else empty.
  Streaming streaming;    ///< Of a volume that is streamed.
};

/// What is under a pixel.
struct Pick {
  bool hit = false;
  glm::dvec3 world{0.0};
  glm::vec3 normal{0.0f};  ///< World frame, unit.
  int structure = 0;       ///< Label id, 0 when there is none.
  /// What is hit, as a number. 0: the volume, its labels and the faces of cuts through them; then the scene's surfaces,
  /// in their order; then the model's instances, copy by copy, or, in a crowd (scene::isCrowd()), its copies.
  std::uint32_t instance = 0;
  int type = -1;                    ///< For an instance of the model: its type in Model::types; else -1.
  std::uint32_t modelInstance = 0;  ///< Number of the model's instance, over all copies; in a crowd of the copy.
  double value = 0;                 ///< Data value there (nearest voxel).
};

/// What pixels show, row by row from the top.
struct PixelIds {
  std::vector<std::int32_t> structures;  ///< ids; 0: something without a structure; -1: nothing
  std::vector<std::int32_t> types;       ///< of the scene's model; -1: none; empty without a model
  std::vector<std::int32_t> instances;   ///< of the scene's model, see Pick::modelInstance; -1: none; empty likewise
  std::vector<float> distances;  ///< from the eye, along the ray, scene units; infinity: nothing; empty: not asked for
};
/// The number of the model's first instance among all that is hit, see Pick::instance.
std::uint32_t firstModelInstance(const scene::Scene& scene);

/// Which layers to read back, and how finely.
struct Layers {
  bool position = false;
  bool normal = false;
  bool depth = false;
  bool structure = false;
  bool instance = false;
  bool type = false;
  bool ghosts = false;
  bool isFine = false;  ///< R, G, B, A as the mean of the samples is; else in 256 levels
  bool face = false;
  bool lines = false;
};

/// Draws scenes. A frame is a queue of small pieces of work (uploads, tables, light, tiles, sample by sample), so that
/// the caller decides how long to work at a time. Keeps nothing that cannot be made again from the frame: where the
/// driver loses a context that is no window's, render() draws the frame once more in a new one, and what is asked about
/// the frame is asked once more, with the same answer. A window's context is lost with gpu::ContextLost. So is one with
/// sheets in the frame (Frame::sheets), which are on the GPU, too. GL thread of its context.
class Renderer {
 public:
  explicit Renderer(gpu::Context& context);
  ~Renderer();

  /// Works on a frame for about `budgetMs`, at least one piece. A frame that differs from the last one starts anew.
  /// @return true when the frame is complete
  /// @throw gpu::ContextLost, whosever context it is; gpu::GpuError when the driver has no memory, not even for less of
  /// the data, see Shortage
  bool work(const Frame& frame, double budgetMs);

  /// Works until the frame is complete. @throw Cancelled
  void render(const Frame& frame, Progress& progress);

  /// Shows the last frame, as far as it is drawn, in a window's framebuffer (GL name), upright, scaled to the window's
  /// size.
  void present(unsigned framebuffer, glm::ivec2 size);

  /// The last frame's window: R, G, B, A display-referred with straight alpha, then the layers asked for:
  /// "position.X/Y/Z" (world), "normal.X/Y/Z" (world), "Z" (distance from the eye, along the ray; infinity where
  /// nothing is), "id" (structure), "instance" (as Pick; -1 where nothing is), "type" (of the model; -1 where no
  /// instance of it is seen), "ghosts.R/G/B/A" (the instances that cuts have removed, as they are blended over the
  /// picture; straight alpha), "face" (place in Scene::cuts of the cut whose face is seen, plus 1; 0: none. Exactly,
  /// of membranes, too: where the ray has come into material through the cut's surface, and that of inlays' images. 0
  /// of a frame without Frame::saysFaces), and what the finish sees of the last sample, where it looks: "lines.type"
  /// (of the model; below 0: something else), "lines.part" (a number of what a line goes around, alike within it, other
  /// in its neighbours), "lines.size" (across it, pixels of a picture of 1000 rows or of a smaller one; 0: nothing is
  /// seen), "lines.depth" (from the picture plane).
  Image read(const Layers& layers = {});

  /// What the last frame shows at a pixel of its window. From the drawn layers, so it agrees with the picture.
  Pick pick(glm::ivec2 pixel);

  /// What each pixel of the last frame's window shows. Reads the whole window back.
  PixelIds idsOfPixels(bool withDistances = false);

  /// What became of the instances in the newest frame, among those with Frame::countsInstances, for which the answer
  /// has arrived from the GPU. Each frame's answer is given once, at most two frames after the frame was complete,
  /// without waiting. @param waits  for the frame drawn last
  std::optional<InstanceBits> bits(bool waits = false);

  const Stats& stats() const;
  /// How much of the present frame is done, 0..1.
  double fractionDone() const;
  /// Forgets everything on the GPU. The next work() makes it again.
  void clear();

 private:
  struct Impl;
  void keepUp();
  void renderOnce(const Frame& frame, Progress& progress);
  template <class Question>
  auto ask(Question question);
  std::unique_ptr<Impl> mImpl;
  gpu::Context& mContext;
};

}  // namespace velum::render
