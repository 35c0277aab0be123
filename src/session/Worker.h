#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "core/Task.h"
#include "render/Frame.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Something that goes on beside the document on the processor, such as a region that grows. A worker follows the
/// scene, hands out work to be done beside, takes in what the work gave, and writes into the scene what follows from
/// the scene by itself. What a worker knows is passing state: neither saved nor undone. The session's thread, but for
/// the work.
class Worker {
 public:
  virtual ~Worker() = default;

  /// Takes over what a scene asks for. Cheap when nothing of this worker's has changed. Scenes change wherever the user
  /// is, so no context is current: nothing on the GPU is touched, nor given back.
  virtual void follow(const scene::Scene& scene) = 0;

  /// Puts the results of work in their place.
  using Finish = std::function<void()>;
  /// To be run beside, one at a time. @throw Cancelled
  using Work = std::function<Finish(Progress&)>;
  /// What is to be computed; nothing while something is, or when nothing is due. Each is answered by endWork().
  virtual Work nextWork() = 0;
  /// What is being computed is of no use any more.
  virtual bool wantsCancel() const = 0;
  /// @param finish  what the work gave; empty when it was cancelled or failed
  /// @param error   one line; empty when it was cancelled
  virtual void endWork(const Finish& finish, const std::string& error) = 0;

  /// What is there is not yet what the scene asks for, and will be by itself.
  virtual bool isOnItsWay() const = 0;
  /// Nothing is to be done.
  virtual bool isSettled() const = 0;

  /// Something that follows from the scene is to be written into the scene, see Document::complete().
  virtual bool hasRests() const = 0;
  virtual void complete(scene::Scene& scene) = 0;
};

/// A worker whose results move on the GPU before they rest: the sheets of membranes. GL thread for what follows, and
/// for nextWork(), which may ask where things are.
class Mover : public Worker {
 public:
  /// Goes on for about so long. @return false when nothing moved
  virtual bool advance(double budgetMs) = 0;
  /// advance() has something to do.
  virtual bool isMoving() const = 0;
  /// Another number when pictures are others.
  virtual std::uint64_t shownCount() const = 0;
  /// Puts what there is into a frame of the scene that was last followed.
  virtual void show(render::Frame& frame) = 0;
  /// Gives up everything on the GPU, whose context still lives.
  virtual void releaseGpu() = 0;
};

}  // namespace velum::session
