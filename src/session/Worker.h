#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "core/Task.h"
#include "render/Frame.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Something that the processor works on beside the document, such as a region that grows. A worker follows the scene,
/// hands out work for other threads, takes in the results of the work, and writes into the scene what follows from the
/// scene by itself. What a worker knows is passing state: neither saved nor undone. All functions are called from the
/// session's thread; only the work itself runs elsewhere.
class Worker {
 public:
  virtual ~Worker() = default;

  /// Takes over what a scene asks for. Cheap when nothing that this worker depends on has changed. Scenes change
  /// wherever the user is, so no GL context is current: an implementation neither touches nor frees anything on the
  /// GPU.
  virtual void follow(const scene::Scene& scene) = 0;

  /// Puts the results of a piece of work in their place. Called by endWork().
  using Finish = std::function<void()>;
  /// A piece of work to be run in another thread, one at a time. @throw Cancelled
  using Work = std::function<Finish(Progress&)>;
  /// The next piece of work; empty while a piece is being done, or when none is due. The caller answers each piece with
  /// endWork().
  virtual Work nextWork() = 0;
  /// True when the result of the work that is being done is of no use any more.
  virtual bool wantsCancel() const = 0;
  /// @param finish  what the work gave; empty when it was cancelled or failed
  /// @param error   one line; empty when it was cancelled
  virtual void endWork(const Finish& finish, const std::string& error) = 0;

  /// True while the worker does not have yet what the scene asks for, and will have it by itself.
  virtual bool isOnItsWay() const = 0;
  /// The worker has nothing left to do.
  virtual bool isSettled() const = 0;

  /// The worker has something for complete() to write into the scene, see Document::complete().
  virtual bool hasRests() const = 0;
  virtual void complete(scene::Scene& scene) = 0;
};

/// A worker whose results move on the GPU before they rest: the sheets of membranes. The functions below, and
/// nextWork(), which may ask where things are, need the GL thread.
class Mover : public Worker {
 public:
  /// Goes on for about so many milliseconds. @return false when nothing moved
  virtual bool advance(double budgetMs) = 0;
  /// advance() has something to do.
  virtual bool isMoving() const = 0;
  /// A number that changes whenever pictures would show something else.
  virtual std::uint64_t shownCount() const = 0;
  /// Puts what the mover shows into a frame of the scene that was last followed.
  virtual void show(render::Frame& frame) = 0;
  /// Gives up everything that the mover has on the GPU, whether the GL context still lives or was lost. Wherever it is
  /// asked for something in another context it first makes everything anew there, as it was.
  virtual void releaseGpu() = 0;
};

}  // namespace velum::session
