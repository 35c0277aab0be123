#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "core/Task.h"
#include "render/Frame.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Something that goes on between frames: sheets that settle, a region that grows, counts that come in. It follows the
/// scene, asks for work to be done beside, and is advanced a little at a time. What it knows is passing state: neither
/// saved nor undone, but for what it writes down by complete(). GL thread, but for what nextWork() hands out.
class Player {
 public:
  virtual ~Player() = default;

  /// Takes over what a scene asks for. Cheap when nothing of this player's has changed. Scenes change wherever the user
  /// is, so the context is not current: nothing on the GPU is touched, nor given back, before advance().
  virtual void follow(const scene::Scene& scene) = 0;

  /// Puts the results of work in their place.
  using Finish = std::function<void()>;
  /// To be run beside, one at a time. @throw Cancelled
  using Work = std::function<Finish(Progress&)>;
  /// What is to be computed; nothing while something is, or when nothing is due. Each is answered by endWork().
  virtual Work nextWork() { return {}; }
  /// What is being computed is of no use any more.
  virtual bool wantsCancel() const { return false; }
  /// @param finish  what the work gave; empty when it was cancelled or failed
  /// @param error   one line; empty when it was cancelled
  virtual void endWork(const Finish& finish, const std::string& error) { (void)finish, (void)error; }

  /// Goes on for about so long. @return false when nothing moved
  virtual bool advance(double budgetMs) = 0;
  /// advance() has something to do.
  virtual bool isMoving() const = 0;
  /// What it shows is not yet what the scene asks for, and will be by itself.
  virtual bool isOnItsWay() const = 0;
  /// Nothing is to be done.
  virtual bool isSettled() const = 0;

  /// Another number when pictures of it are others.
  virtual std::uint64_t shownCount() const = 0;
  /// Puts what it has into a frame of the scene that was last followed.
  virtual void show(render::Frame& frame) = 0;

  /// Something that follows from the scene is to be written into it, see Document::complete().
  virtual bool hasRests() const { return false; }
  virtual void complete(scene::Scene& scene) { (void)scene; }

  /// Gives up everything on the GPU, whose context still lives.
  virtual void releaseGpu() {}
};

}  // namespace velum::session
