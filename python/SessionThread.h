#pragma once
#include <sys/types.h>
#include <unistd.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "session/Session.h"

namespace velum::python {

/// A session in a thread of its own, where its GL context lives, too. Calls may come from any thread; they are done one
/// after the other, in their order.
class SessionThread {
 public:
  using Work = std::function<void(session::Session&, Progress&)>;
  struct News {
    double fraction = 0.0;  ///< of the work that is done
    std::string what;
  };
  /// Called in the thread of the caller that waits, some twenty times a second, and at the end where there is news.
  /// Must ask the session for nothing but cancel(), close() and drop().
  /// @param news  null: there is none
  using Pulse = std::function<void(const News* news)>;

  explicit SessionThread(gpu::ContextKind context);
  ~SessionThread();

  /// Does the work in the session's thread, and waits for its end. What a pulse throws, the last one too, stops the
  /// work, and is thrown when the work has ended. Work that throws or is stopped has not been done: all that is open
  /// is as it was before.
  /// @throw what the work throws; Cancelled after cancel(); ArgumentError when the session is closed, is another
  /// process's, or is called by a pulse
  void run(const Work& work, const Pulse& pulse);
  /// Has something end in the session's thread, and before the session. Called by work.
  void keep(std::shared_ptr<void> thing);
  /// Ends something that is kept, soon, in the session's thread, before other work. Any thread.
  void drop(std::weak_ptr<void> thing);
  /// Stops the work that is being done. Any thread.
  void cancel();
  /// Stops all work and ends the session. Any thread.
  void close();

 private:
  struct Task;
  struct State {
    std::mutex mutex;                      ///< of all that follows
    std::condition_variable called, done;  ///< the thread waits for the one, callers for the other
    std::deque<Task*> tasks;               ///< The first one is being done.
    std::vector<std::weak_ptr<void>> dropped;
    bool isClosed = false;
    std::thread thread;
    std::vector<std::shared_ptr<void>> kept;  ///< the thread's own
  };
  /// A fork has a copy of the state, and no such thread: what waits there for it would wait for ever.
  bool isForked() const { return ::getpid() != mProcess; }
  static void live(State& state, gpu::ContextKind context);
  static void doTask(State& state, Task& task, session::Session& session);
  static void endDropped(State& state, std::unique_lock<std::mutex>& lock);

  pid_t mProcess;
  std::unique_ptr<State> mState;
};

}  // namespace velum::python
