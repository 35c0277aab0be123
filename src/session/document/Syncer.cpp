#include "Syncer.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <utility>

#include "JournalFiles.h"
#include "velum/core/Error.h"
#include "velum/core/ReplaceFile.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {
constexpr auto kSyncPause = std::chrono::seconds(1);
}

Syncer::Syncer(Listener onError) : mOnError(std::move(onError)), mThread([this] { run(); }) {}

Syncer::~Syncer() {
  {
    std::lock_guard guard(mMutex);
    mStop = true;
  }
  mWake.notify_all();
  mThread.join();
}

void Syncer::want(int file) {
  std::lock_guard guard(mMutex);
  // Of an older file that is still due nothing is lost: the next one begins with the whole scene.
  if (mFile >= 0) ::close(mFile);
  mFile = ::fcntl(file, F_DUPFD_CLOEXEC, 0);
  mWake.notify_all();
}

void Syncer::wantAutosave(fs::path folder, int generation, std::string text) {
  std::lock_guard guard(mMutex);
  mAutosave = Autosave{std::move(folder), generation, std::move(text)};
  mWake.notify_all();
}

void Syncer::wait() {
  std::unique_lock guard(mMutex);
  mHurry = true;
  mWake.notify_all();
  mIdle.wait(guard, [this] { return !mBusy && mFile < 0 && !mAutosave; });
  mHurry = false;
}

void Syncer::run() {
  std::unique_lock guard(mMutex);
  while (true) {
    mWake.wait(guard, [this] { return mStop || mFile >= 0 || mAutosave; });
    if (mFile < 0 && !mAutosave) return;  // stopping, with nothing due
    auto autosave = std::exchange(mAutosave, std::nullopt);
    int file = std::exchange(mFile, -1);
    mBusy = true;
    guard.unlock();
    if (autosave) write(*autosave);
    if (file >= 0) {
      ::fdatasync(file);
      ::close(file);
    }
    guard.lock();
    mBusy = false;
    mIdle.notify_all();
    mWake.wait_for(guard, kSyncPause, [this] { return mStop || mHurry; });
  }
}

void Syncer::write(const Autosave& autosave) {
  try {
    replaceFile(autosavePath(autosave.folder, autosave.generation), autosave.text, ReplaceFile::Access::Owner);
    for (int generation : generationsIn(autosave.folder)) {
      if (generation >= autosave.generation - 1) continue;
      std::error_code ignored;
      fs::remove(journalPath(autosave.folder, generation), ignored);
      fs::remove(autosavePath(autosave.folder, generation), ignored);
    }
  } catch (const Error& error) {
    mOnError(error.what());
  }
}

}  // namespace velum::session
