#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Arrays.h"
#include "SessionThread.h"

namespace velum::python {

/// A session as Python has it: all calls give up Python's lock while the session works, tell the listener how far the
/// work is, and stop where the listener or a handler of a signal throws (KeyboardInterrupt). What the session gives
/// are values. All functions want Python's lock; any thread of Python. @throw as SessionThread::run()
class BoundSession {
 public:
  explicit BoundSession(const std::string& context);
  ~BoundSession();

  struct Told {
    bool isAnswer = false;  ///< the lines are what was asked for, rather than notes
    std::vector<std::string> lines;
  };
  /// Does lines of a script, all of them or none, and lets all come to rest after each.
  Told run(const std::vector<std::string>& lines);
  /// The value of a field, as JSON.
  std::string field(const std::string& path);
  /// All that was done since something was opened, as a program.
  std::string program();

  void openVolume(const Shared<Volume>& volume);
  void putLabels(const Shared<LabelVolume>& labels);
  std::optional<Shared<Volume>> volume();
  std::optional<Shared<LabelVolume>> labels();

  struct Wanted {
    int width = 0, height = 0, samples = 0;
    bool transparent = false, layers = false, isFine = false;
    std::string section;  ///< empty: the 3D picture
  };
  Image picture(const Wanted& wanted);

  /// The frames of a film that are drawn one by one. What draws them is the session's, and ends with it.
  struct Frames {
    struct Drawer;
    std::weak_ptr<Drawer> drawer;
    int count = 0;
  };
  /// @param line  of a script, film.save: how the frames are drawn  @throw ArgumentError
  Frames frames(const std::string& line);
  /// @param frame  never below that of the call before
  Image frame(const Frames& frames, int frame);
  /// Nothing stops this, nor waits for it.
  void endFrames(const Frames& frames);

  /// Tables as JSON.
  std::string measure(bool marks, bool structures, bool faces);
  std::string count(int width, int height);

  void cancel() { mThread.cancel(); }
  void close();

  pybind11::object listener = pybind11::none();  ///< called with how far work is, 0..1, and what is done

 private:
  void in(const SessionThread::Work& work);

  SessionThread mThread;
};

}  // namespace velum::python
