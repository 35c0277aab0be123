#pragma once

namespace velum::render {

struct FrameData;
class WorkQueue;

/// One kind of work of a frame, with the programs, targets and caches that it needs. FrameWork.cpp has the list of all,
/// in the order of a frame. GL thread.
///
/// Everything that a pass keeps from frame to frame it keeps together with a key: a struct of the values that its
/// shaders read, made from a frame by `keyOf(data)` and compared with ==. So a pass finds out by itself what has
/// changed; nobody tells it.
class Pass {
 public:
  /// @param name  a string literal, for people: shown in debuggers and in Stats::passesMs
  explicit Pass(const char* name) : mName(name) {}
  virtual ~Pass() = default;
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  const char* name() const { return mName; }
  /// Called before anything of a frame is drawn: prepares programs and targets, and fills in the members of
  /// FrameData::params that belong to the pass.
  virtual void prepare(FrameData& data) = 0;
  /// Called once the passes that make light are prepared: starts compiling the frame's programs that take long to
  /// compile.
  virtual void compile(const FrameData& data) { static_cast<void>(data); }
  /// True when these programs are compiled. @throw GpuError where one of them does not compile
  virtual bool isReady() { return true; }
  /// Adds the pass's work in pieces that take well under 50 ms; none where its key still holds. The caller keeps `data`
  /// in place and unchanged until the frame is done or given up.
  /// @param sample  which sample of the picture; passes whose work serves all samples do something for sample 0 only
  virtual void addSteps(const FrameData& data, int sample, WorkQueue& queue) = 0;
  /// Binds those results of the pass that all steps of a frame may read, as listed in shaders/shared/bindings.h. Called
  /// before the frame's first step, and whenever other GL work may have come between.
  virtual void bind(const FrameData& data) const { static_cast<void>(data); }
  /// Called for each finished piece, with the time until the driver said that the piece was done.
  virtual void took(double ms) { static_cast<void>(ms); }

 private:
  const char* mName;
};

}  // namespace velum::render
