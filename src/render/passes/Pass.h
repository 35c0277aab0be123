#pragma once

namespace velum::render {

struct FrameData;
class WorkQueue;

/// One kind of work of a frame, with the programs, targets and caches that it needs. Renderer.cpp has the list of all,
/// in the order of a frame. GL thread.
///
/// What a pass keeps from frame to frame it keeps with a key: a struct of the values that its shaders read, made from a
/// frame by `keyOf(data)`, compared with ==. Nobody tells a pass that something has changed.
class Pass {
 public:
  /// @param name  of a literal, for people: debuggers and Stats::passesMs
  explicit Pass(const char* name) : mName(name) {}
  virtual ~Pass() = default;
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  const char* name() const { return mName; }
  /// Before anything of a frame is drawn: programs, targets, and what of FrameData::params is the pass's to say.
  virtual void prepare(FrameData& data) = 0;
  /// Once the passes that light are prepared: asks for the programs of the frame that take long to compile.
  virtual void compile(const FrameData& data) { static_cast<void>(data); }
  /// They are there. @throw GpuError where one of them is none
  virtual bool isReady() { return true; }
  /// Adds the pass's work in pieces that take well under 50 ms; none where its key still holds. `data` stays where it
  /// is, and as it is, until the frame is done or given up.
  /// @param sample  which sample of the picture; passes whose work serves all of them are asked for 0 only
  virtual void addSteps(const FrameData& data, int sample, WorkQueue& queue) = 0;
  /// Binds what all steps of a frame may read of it, as shaders/shared/bindings.h says. Before the frame's first step,
  /// and whenever other GL work may have come between.
  virtual void bind(const FrameData& data) const { static_cast<void>(data); }
  /// How long a piece took, until the driver said that it was done.
  virtual void took(double ms) { static_cast<void>(ms); }

 private:
  const char* mName;
};

}  // namespace velum::render
