#include "session/document/Syncer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

#include "core/ReplaceFile.h"
#include "session/document/JournalFiles.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {
constexpr auto kSyncPause = std::chrono::seconds(1);
}

Syncer::Syncer(Listener synced) : mSynced(std::move(synced)), mThread([this] { run(); }) {}

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
  mOwed.reset();
  mWake.notify_all();
}

void Syncer::wait() {
  std::unique_lock guard(mMutex);
  mHurry = true;
  mWake.notify_all();
  mIdle.wait(guard, [this] { return !mBusy && mFile < 0 && !mAutosave; });
  mHurry = false;
}

void Syncer::forget() {
  wait();
  std::lock_guard guard(mMutex);
  mOwed.reset();
}

void Syncer::run() {
  std::unique_lock guard(mMutex);
  while (true) {
    mWake.wait(guard, [this] { return mStop || mFile >= 0 || mAutosave; });
    if (mFile < 0 && !mAutosave) return;  // stopping, with nothing due
    auto autosave = std::exchange(mAutosave ? mAutosave : mOwed, std::nullopt);
    int file = std::exchange(mFile, -1);
    mBusy = true;
    guard.unlock();
    if (file >= 0) sync(file);
    bool isOwed = autosave && !write(*autosave);
    guard.lock();
    if (isOwed && !mAutosave) mOwed = std::move(autosave);
    mBusy = false;
    mIdle.notify_all();
    mWake.wait_for(guard, kSyncPause, [this] { return mStop || mHurry; });
  }
}

/// Network file systems say only here that there was no room.
void Syncer::sync(int file) {
  int reason = ::fdatasync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
  if (::close(file) != 0 && reason == 0 && errno != EINTR) reason = errno;
  mSynced(reason == 0 ? "" : fmt::format("the journal cannot be written ({})", std::strerror(reason)));
}

/// @return false when there was no room for it
bool Syncer::write(const Autosave& autosave) {
  bool done = true;
  try {
    replaceFile(autosavePath(autosave.folder, autosave.generation), autosave.text, ReplaceFile::Access::Owner);
  } catch (const std::exception&) {
    done = false;
  }
  // Also without it, for that makes room: this journal and the one before are whole.
  std::error_code ignored;
  for (int generation : generationsIn(autosave.folder, ignored)) {
    if (generation >= autosave.generation - 1) continue;
    fs::remove(journalPath(autosave.folder, generation), ignored);
    fs::remove(autosavePath(autosave.folder, generation), ignored);
  }
  return done;
}

}  // namespace velum::session
