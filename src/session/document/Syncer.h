#pragma once
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace velum::session {

/// Brings a journal's files to the disk in a thread of its own: a slow disk must not hold up the lines.
class Syncer {
 public:
  using Listener = std::function<void(const std::string&)>;
  /// @param onError  told in words when the disk refuses, from the thread of this
  explicit Syncer(Listener onError);
  /// Does what is due.
  ~Syncer();
  Syncer(const Syncer&) = delete;
  Syncer& operator=(const Syncer&) = delete;

  /// The journal has grown. Its file may be closed meanwhile.
  void want(int file);
  /// A generation has begun: its autosave is written, then what is older than the one before is deleted.
  void wantAutosave(std::filesystem::path folder, int generation, std::string text);
  /// Until nothing is under way and nothing is due.
  void wait();

 private:
  struct Autosave {
    std::filesystem::path folder;
    int generation;
    std::string text;
  };
  void run();
  void write(const Autosave& autosave);

  Listener mOnError;
  std::mutex mMutex;
  std::condition_variable mWake, mIdle;
  std::optional<Autosave> mAutosave;
  int mFile = -1;
  bool mBusy = false, mStop = false, mHurry = false;
  std::thread mThread;  ///< last: it uses the others
};

}  // namespace velum::session
