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
  /// @param synced  told after each sync of a journal, from the thread of this: nothing, or in words that what was
  /// written may be lost
  explicit Syncer(Listener synced);
  /// Does what is due.
  ~Syncer();
  Syncer(const Syncer&) = delete;
  Syncer& operator=(const Syncer&) = delete;

  /// The journal has grown. Its file may be closed meanwhile.
  void want(int file);
  /// A generation has begun: its autosave is written, then what is older than the one before is deleted. An autosave
  /// for which there is no room is tried again whenever the journal grows: the journal begins with the same scene.
  void wantAutosave(std::filesystem::path folder, int generation, std::string text);
  /// Until nothing is under way and everything that is due was tried.
  void wait();
  /// Gives up the autosave that is due: its folder goes.
  void forget();

 private:
  struct Autosave {
    std::filesystem::path folder;
    int generation;
    std::string text;
  };
  void run();
  bool write(const Autosave& autosave);
  void sync(int file);

  Listener mSynced;
  std::mutex mMutex;
  std::condition_variable mWake, mIdle;
  std::optional<Autosave> mAutosave, mOwed;  ///< due; tried in vain
  int mFile = -1;
  bool mBusy = false, mStop = false, mHurry = false;
  std::thread mThread;  ///< last: it uses the others
};

}  // namespace velum::session
