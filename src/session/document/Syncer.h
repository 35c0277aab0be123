#pragma once
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace velum::session {

/// Syncs a journal's files to the disk in a thread of its own: a slow disk must not hold up the lines of the journal.
class Syncer {
 public:
  using Listener = std::function<void(const std::string&)>;
  /// @param synced  called after each sync of a journal, from the syncer's thread: with "", or with words that say that
  /// what was written may be lost
  explicit Syncer(Listener synced);
  /// Does what is due, then ends the thread.
  ~Syncer();
  Syncer(const Syncer&) = delete;
  Syncer& operator=(const Syncer&) = delete;

  /// Asks for a sync: the journal has grown. @param file  its descriptor, which the caller may close meanwhile
  void want(int file);
  /// Asks for an autosave: a generation has begun. The autosave is written, then all generations older than the one
  /// before it are deleted. An autosave for which there is no room is tried again whenever the journal grows; nothing
  /// is lost meanwhile, as the journal begins with the same scene.
  void wantAutosave(std::filesystem::path folder, int generation, std::string text);
  /// Waits until nothing is under way and everything that is due was tried.
  void wait();
  /// Waits as wait(), then drops an autosave that was tried in vain: its folder is about to go.
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
  std::optional<Autosave> mAutosave, mOwed;  ///< the autosave that is due; the one that was tried in vain
  int mFile = -1;
  bool mBusy = false, mStop = false, mHurry = false;
  std::thread mThread;  ///< last: it uses the members above
};

}  // namespace velum::session
