#include "velum/session/document/Journal.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

#include "JournalFiles.h"
#include "Syncer.h"
#include "velum/core/Error.h"
#include "velum/core/ReplaceFile.h"
#include "velum/scene/json/ChangeLog.h"

namespace velum::session {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

/// A name that sorts by time and that no other process, or document of this one, has.
std::string newFolderName() {
  static std::atomic<int> turn{0};
  auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{}-{}-{}", std::chrono::duration_cast<std::chrono::milliseconds>(now).count(), ::getpid(),
                     turn++);
}

}  // namespace

struct Journal::Impl {
  explicit Impl(Options given) : options(std::move(given)), thread([this] { run(); }) {}
  ~Impl() {
    {
      std::lock_guard guard(mutex);
      stop = true;
    }
    wake.notify_all();
    thread.join();
  }

  // What the writer is to do. Guarded by the mutex.
  struct Change {
    scene::Scene scene;
    std::string label;
    Clock::time_point when;
  };
  const Options options;
  std::mutex mutex;
  std::condition_variable wake, idle;
  std::optional<Change> pending;
  std::string title, path;
  bool discards = false, stop = false, busy = false, hurry = false;
  std::function<void(const std::string&)> onError;

  // The writer's own.
  fs::path folder;
  int lock = -1, file = -1, generation = 0;
  std::int64_t number = 0;
  std::size_t bytes = 0, beginBytes = 0;
  scene::SceneMirror mirror;
  Clock::time_point start;
  bool mustBegin = true;  ///< the next line begins a generation: there is none, or the last one ends in half a line
  std::atomic<bool> hasToldError{false};
  Syncer syncer{[this](const std::string& text) { tell(text); }};
  std::thread thread;  // last: it uses the others

  void run();
  void tell(const std::string& error);
  void write(const Change& change, const std::string& nowTitle, const std::string& nowPath);
  bool isGone() const;
  void openFolder(const Change& change);
  void beginGeneration(scene::ChangeLine line);
  void close(bool removes);
};

void Journal::Impl::tell(const std::string& error) {
  if (hasToldError.exchange(true)) return;
  std::function<void(const std::string&)> listener;
  {
    std::lock_guard guard(mutex);
    listener = onError;
  }
  if (listener) listener(error + "; unsaved work is not protected");
}

void Journal::Impl::run() {
  std::unique_lock guard(mutex);
  while (true) {
    wake.wait(guard, [this] { return stop || discards || pending; });
    if (!discards && !pending) break;
    auto change = std::exchange(pending, std::nullopt);
    bool removes = std::exchange(discards, false);
    std::string nowTitle = title, nowPath = path;
    busy = true;
    guard.unlock();
    if (removes) close(true);
    if (change) write(*change, nowTitle, nowPath);
    guard.lock();
    busy = false;
    idle.notify_all();
    if (change) wake.wait_for(guard, options.pause, [this] { return stop || discards || hurry; });
  }
  guard.unlock();
  close(false);
}

void Journal::Impl::write(const Change& change, const std::string& nowTitle, const std::string& nowPath) {
  try {
    if (isGone()) close(false);
    if (folder.empty()) openFolder(change);
    std::string patch = mirror.follow(change.scene);
    if (patch.empty() && !mustBegin) return;
    std::chrono::duration<double> since = change.when - start;
    scene::ChangeLine line{++number, since.count(), change.label, nowTitle, nowPath, std::move(patch)};
    if (mustBegin || bytes > std::max(options.compactBytes, 4 * beginBytes)) return beginGeneration(std::move(line));
    std::string text = scene::encodeLine(line);
    if (!writeAll(file, std::as_bytes(std::span(text))))
      throw InputError(fmt::format("{}: cannot be written ({})", folder.string(), std::strerror(errno)));
    bytes += text.size();
    syncer.want(file);
  } catch (const std::exception& error) {
    mustBegin = true;
    tell(error.what());
  }
}

/// Somebody has tidied up: what is written would be found by nobody.
bool Journal::Impl::isGone() const {
  struct stat state {};
  return file >= 0 && ::fstat(file, &state) == 0 && state.st_nlink == 0;
}

void Journal::Impl::openFolder(const Change& change) {
  std::string name = newFolderName();
  fs::path hidden = options.root / ("." + name);
  lock = makeLockedFolder(hidden);
  folder = hidden;
  start = change.when;
  generation = 0;
  number = 0;
  mirror = scene::SceneMirror();
  mustBegin = true;
}

/// A new journal that holds the whole scene, made under another name first: a journal that is there has its first line.
void Journal::Impl::beginGeneration(scene::ChangeLine line) {
  mustBegin = true;
  line.patch = mirror.wholePatch();
  std::string text = scene::encodeLine(line);
  ReplaceFile next(journalPath(folder, generation + 1), ReplaceFile::Access::Owner);
  next.write(text);
  next.commit(ReplaceFile::Sync::ByCaller);  // The syncer's: a slow disk must not hold up the lines.
  if (file >= 0) ::close(file);
  file = next.releaseDescriptor();
  if (folder.filename().string().starts_with('.')) {
    fs::path visible = folder.parent_path() / folder.filename().string().substr(1);
    publishFolder(folder, visible);
    folder = visible;
  }
  ++generation;
  bytes = beginBytes = text.size();
  mustBegin = false;
  hasToldError = false;
  syncer.wantAutosave(folder, generation, mirror.text());
  syncer.want(file);
}

void Journal::Impl::close(bool removes) {
  syncer.wait();
  if (file >= 0) ::close(std::exchange(file, -1));
  std::error_code ignored;
  if (removes && !folder.empty()) fs::remove_all(folder, ignored);
  if (lock >= 0) ::close(std::exchange(lock, -1));
  folder.clear();
}

Journal::Journal(Options options) : mImpl(std::make_unique<Impl>(std::move(options))) {}
Journal::~Journal() = default;

void Journal::describe(const std::string& title, const std::string& path) {
  std::lock_guard guard(mImpl->mutex);
  mImpl->title = title;
  mImpl->path = path;
}

void Journal::record(const scene::Scene& scene, const std::string& label) {
  Impl::Change change{scene, label, Clock::now()};
  std::lock_guard guard(mImpl->mutex);
  mImpl->pending = std::move(change);
  mImpl->wake.notify_all();
}

void Journal::discard() {
  std::lock_guard guard(mImpl->mutex);
  mImpl->pending.reset();
  mImpl->discards = true;
  mImpl->wake.notify_all();
}

void Journal::flush() {
  std::unique_lock guard(mImpl->mutex);
  mImpl->hurry = true;
  mImpl->wake.notify_all();
  mImpl->idle.wait(guard, [this] { return !mImpl->busy && !mImpl->pending && !mImpl->discards; });
  mImpl->hurry = false;
  guard.unlock();
  mImpl->syncer.wait();
}

void Journal::setErrorListener(std::function<void(const std::string&)> listener) {
  std::lock_guard guard(mImpl->mutex);
  mImpl->onError = std::move(listener);
}

}  // namespace velum::session
