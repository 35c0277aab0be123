#pragma once
#include <optional>

#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/Renderer.h"
#include "render/WorkQueue.h"
#include "render/passes/BrickPass.h"
#include "render/passes/CountPass.h"
#include "render/passes/FinishPass.h"
#include "render/passes/GhostPass.h"
#include "render/passes/InstancePass.h"
#include "render/passes/LightPass.h"
#include "render/passes/ModelPass.h"
#include "render/passes/RayCastPass.h"
#include "render/passes/ResolvePass.h"
#include "render/passes/SkipPass.h"
#include "render/passes/StatePass.h"
#include "render/passes/SurfacePass.h"
#include "render/passes/UploadPass.h"

namespace velum::render {

/// The passes, what they hand on to each other, and the work that is left of the frame in hand.
struct Renderer::Impl {
  Impl(gpu::Context& c, const Stats& known)
      : limits(c.limits()),
        upload(limits),
        model(limits),
        states(model),
        instances(model, states, surfaces),
        rayCast(gbuffer, limits.isSoftware),
        counts(gbuffer, model, states),
        ghosts(gbuffer, model, instances.draw()),
        finish(gbuffer),
        stats(known) {}

  gpu::Limits limits;
  std::optional<Frame> wanted;  ///< As the caller gave it.
  FrameData coming;             ///< Of a frame whose data is on its way;
  FrameData data;               ///< of the one that is drawn, or was last.
  bool isDrawn = false;         ///< All passes are prepared for `data`.
  FrameInputs inputs;
  Gbuffer gbuffer;
  UploadPass upload;
  SkipPass skip;
  LightPass light;
  SurfacePass surfaces;
  ModelPass model;
  StatePass states;
  InstancePass instances;
  RayCastPass rayCast;
  CountPass counts;
  GhostPass ghosts;
  FinishPass finish;
  ResolvePass resolve;
  /// Whom the data's upload goes before,
  Pass* const lighting[6] = {&skip, &light, &surfaces, &model, &states, &instances};
  /// and those that need to know of their targets.
  Pass* const casting[4] = {&rayCast, &counts, &ghosts, &finish};
  WorkQueue queue;
  BrickPass bricks{skip, rayCast, inputs, queue};
  Stats stats;

  void begin(const Frame& frame);
  void setUp();
  void askForPrograms();
  bool hasPrograms();
  void addSamples();
  void addCasting();
  void addSamplesFrom(int first);
  void finishSample(int sample);
  void redraw(int sample);
  bool waitsForBricks() const { return data.residency && !data.frame.isPreview; }
  void bind() const;
  void noteStats();
  bool look(bool fine);
};

}  // namespace velum::render
