#include "session/document/Journal.h"

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

#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "scene/json/ChangeLog.h"
#include "session/document/JournalFiles.h"
#include "session/document/Syncer.h"

namespace velum::session {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::size_t kMostHead = 64 << 10;  // bytes of a line beside its patch: names and paths

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
  std::optional<Change> refused;  ///< the newest, when the disk does not take it
  std::optional<Change> newest;   ///< that the writer took
  std::string title, path;
  bool discards = false, stop = false, busy = false, hurry = false;
  bool wantsTry = false;    ///< what was refused is to be tried now
  bool isHopeless = false;  ///< the newest change is refused whatever the disk does
  bool mayBeLost = false;   ///< the disk has taken lines, and then said that it has not
  std::function<void(const std::string&)> onError;

  // The writer's own.
  fs::path folder;
  int lock = -1, file = -1, generation = 0;
  std::int64_t number = 0;
  std::size_t bytes = 0, beginBytes = 0, lines = 0;
  scene::SceneMirror mirror;
  Clock::time_point start;
  bool mustBegin = true;  ///< the next line begins a generation: there is none, or the last one ends in half a line
  std::atomic<bool> hasToldError{false};
  std::atomic<bool> isTaken{true};  ///< by the system: what was written last
  Syncer syncer{[this](const std::string& error) { synced(error); }};
  std::thread thread;  // last: it uses the others

  void run();
  std::optional<Change> waitForWork(std::unique_lock<std::mutex>& guard);
  void tell(const std::string& error);
  void say(const std::string& text);
  void synced(const std::string& error);
  bool write(const Change& change, const std::string& nowTitle, const std::string& nowPath);
  void writeLine(scene::ChangeLine line);
  bool isFull(std::size_t patchBytes) const;
  bool isGone() const;
  void openFolder(const Change& change);
  void beginGeneration(scene::ChangeLine line);
  void close(bool removes);
};

void Journal::Impl::tell(const std::string& error) {
  if (!hasToldError.exchange(true)) say(error + "; unsaved work is not protected");
}

void Journal::Impl::say(const std::string& text) {
  std::function<void(const std::string&)> listener;
  {
    std::lock_guard guard(mutex);
    listener = onError;
  }
  if (listener) listener(text);
}

/// Heard from the syncer's thread. @param error  empty: what was written is on the disk
void Journal::Impl::synced(const std::string& error) {
  if (error.empty()) {
    if (isTaken && hasToldError.exchange(false)) say({});
    return;
  }
  isTaken = false;
  {
    std::lock_guard guard(mutex);
    mayBeLost = true;
    if (!refused) refused = newest;
    wake.notify_all();
  }
  tell(error);
}

/// @return the change that is to be written; nothing when something else is to be done
std::optional<Journal::Impl::Change> Journal::Impl::waitForWork(std::unique_lock<std::mutex>& guard) {
  auto isDue = [this] { return stop || discards || pending; };
  wake.wait(guard, [&] { return isDue() || refused; });
  if (refused) wake.wait_for(guard, options.retry, [&] { return isDue() || wantsTry; });
  wantsTry = false;
  auto again = std::exchange(refused, std::nullopt);
  auto change = std::exchange(pending, std::nullopt);
  return change || discards ? change : again;
}

void Journal::Impl::run() {
  std::unique_lock guard(mutex);
  while (true) {
    auto change = waitForWork(guard);
    if (!discards && !change) break;
    bool removes = std::exchange(discards, false), isLast = stop;
    std::string nowTitle = title, nowPath = path;
    newest = change;
    isHopeless = false;
    busy = true;
    guard.unlock();
    if (removes) close(true);
    bool done = !change || write(*change, nowTitle, nowPath);
    guard.lock();
    if (!done && !isLast) refused = std::move(change);
    busy = false;
    idle.notify_all();
    if (newest) wake.wait_for(guard, options.pause, [this] { return stop || discards || hurry; });
  }
  guard.unlock();
  close(false);
}

/// @return false when it is to be tried again
bool Journal::Impl::write(const Change& change, const std::string& nowTitle, const std::string& nowPath) {
  try {
    if (isGone()) close(false);
    if (folder.empty()) openFolder(change);
    {
      std::lock_guard guard(mutex);
      mustBegin = std::exchange(mayBeLost, false) || mustBegin;
    }
    std::string patch = mirror.follow(change.scene);
    if (patch.empty() && !mustBegin) return true;
    std::chrono::duration<double> since = change.when - start;
    scene::ChangeLine line{++number, since.count(), change.label, nowTitle, nowPath, std::move(patch)};
    mustBegin || isFull(line.patch.size()) ? beginGeneration(std::move(line)) : writeLine(std::move(line));
    return true;
  } catch (const std::exception& error) {
    mustBegin = true;
    isTaken = false;
    tell(error.what());
    std::lock_guard guard(mutex);
    return isHopeless;
  }
}

/// True where the whole scene is shorter than the line, or with the line the journal would be longer than may be read.
bool Journal::Impl::isFull(std::size_t patchBytes) const {
  return patchBytes > std::max(options.compactBytes, beginBytes) ||
         bytes > std::max(options.compactBytes, 4 * beginBytes) || bytes + patchBytes + kMostHead > options.mostBytes ||
         lines >= options.mostLines;
}

void Journal::Impl::writeLine(scene::ChangeLine line) {
  std::string text = scene::encodeLine(line);
  if (!writeAll(file, std::as_bytes(std::span(text))))
    throw InputError(fmt::format("{}: cannot be written ({})", folder.string(), std::strerror(errno)));
  bytes += text.size();
  ++lines;
  isTaken = true;
  syncer.want(file);
}

/// True where somebody has deleted the folder: nobody would find what is written there.
bool Journal::Impl::isGone() const {
  struct stat state {};
  if (file >= 0 && ::fstat(file, &state) == 0 && state.st_nlink == 0) return true;
  std::error_code error;
  return !folder.empty() && fs::status(folder, error).type() == fs::file_type::not_found;
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

/// Begins a journal with the whole scene, under another name first: every journal that is there has its first line.
void Journal::Impl::beginGeneration(scene::ChangeLine line) {
  mustBegin = true;
  line.patch = mirror.wholePatch();
  std::string text = scene::encodeLine(line);
  if (text.size() > options.mostBytes) {
    std::lock_guard guard(mutex);
    isHopeless = true;
    throw InputError(fmt::format("a scene of {} MiB is too large for a journal", text.size() >> 20));
  }
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
  lines = 1;
  mustBegin = false;
  isTaken = true;
  syncer.want(file);
  syncer.wantAutosave(folder, generation, mirror.text());
}

void Journal::Impl::close(bool removes) {
  syncer.forget();
  bool isEmpty = file < 0;  // nothing could be written yet
  if (file >= 0) ::close(std::exchange(file, -1));
  if (!folder.empty() && (removes || isEmpty)) removeFolder(folder);
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

bool Journal::flush() {
  Impl& impl = *mImpl;
  std::unique_lock guard(impl.mutex);
  impl.hurry = true;
  impl.wantsTry = impl.refused.has_value();
  impl.wake.notify_all();
  impl.idle.wait(guard, [&] { return !impl.busy && !impl.pending && !impl.discards && !impl.wantsTry; });
  impl.hurry = false;
  guard.unlock();
  impl.syncer.wait();
  guard.lock();
  return !impl.refused && !impl.isHopeless && !impl.mayBeLost;
}

void Journal::setErrorListener(std::function<void(const std::string&)> listener) {
  std::lock_guard guard(mImpl->mutex);
  mImpl->onError = std::move(listener);
}

}  // namespace velum::session
