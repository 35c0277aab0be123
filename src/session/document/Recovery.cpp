#include "session/document/Recovery.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <thread>
#include <tuple>

#include "core/Error.h"
#include "scene/json/ChangeLog.h"
#include "session/document/JournalFiles.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr auto kOrphanAge = std::chrono::hours(1);

/// What a folder comes to.
struct Reading {
  std::optional<scene::Replayed> found;  ///< of the newest generation of which a scene can be made
  int generation = 0;                    ///< that one
  bool hasFiles = false;
  bool isWhole = true;
  std::string whyNot;  ///< the first that is wrong
  void blame(const std::string& what, const std::string& why) {
    if (whyNot.empty()) whyNot = what + ": " + why;
  }
};

std::string readInto(Reading& reading, const fs::path& path) {
  FileText file = readFile(path, scene::kMostJournalBytes);
  if (!file.whyNot.empty()) reading.blame(path.filename().string(), file.whyNot);
  return std::move(file.text);
}

Reading readNewest(const fs::path& folder) {
  Reading reading;
  std::error_code error;
  auto generations = generationsIn(folder, error);
  if (error) reading.blame(folder.filename().string(), error.message());
  reading.hasFiles = !generations.empty();
  for (int generation : generations) {
    std::string journal = readInto(reading, journalPath(folder, generation));
    reading.found = scene::replay(readInto(reading, autosavePath(folder, generation)), journal);
    if (!reading.found || !reading.found->isWhole)
      reading.blame(journalPath(folder, generation).filename().string(), "it is damaged");
    reading.generation = generation;
    if (reading.found) break;
  }
  // An autosave that is unreadable beside a journal that is whole costs nothing.
  reading.isWhole = reading.found && reading.found->isWhole && reading.generation == generations.front();
  if (reading.isWhole) reading.whyNot.clear();
  return reading;
}

std::chrono::system_clock::time_point timeOf(const fs::path& path) {
  std::error_code error;
  auto time = fs::last_write_time(path, error);
  if (error) return {};
  return std::chrono::file_clock::to_sys(time);
}

std::chrono::system_clock::time_point lastWrite(const fs::path& folder) {
  std::chrono::system_clock::time_point last{};
  std::error_code ignored;
  for (int generation : generationsIn(folder, ignored))
    last = std::max({last, timeOf(journalPath(folder, generation)), timeOf(autosavePath(folder, generation))});
  return last == std::chrono::system_clock::time_point{} ? timeOf(folder) : last;
}

/// Removes an old folder with nothing but a lock in it: its session died while making it, or a process while deleting
/// it.
void removeEmpty(const fs::path& folder) {
  if (std::chrono::system_clock::now() - timeOf(folder) > kOrphanAge) removeFolder(folder);
}

bool holdsNothing(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().filename() != "lock") return false;
  return !error;
}

std::optional<LostWork> inspect(const fs::path& folder) {
  LockTry lock = tryLock(folder, LockKind::Shared);
  std::error_code ignored;
  if (lock.isHeld() || !fs::exists(fs::symlink_status(folder, ignored))) return std::nullopt;  // it lives, or is gone
  if (holdsNothing(folder)) {
    removeEmpty(folder);
    if (lock.isTaken()) ::close(lock.descriptor);
    return std::nullopt;
  }
  LostWork work;
  work.folder = folder;
  work.when = lastWrite(folder);
  Reading reading = readNewest(folder);
  if (lock.isTaken())
    ::close(lock.descriptor);
  else
    reading.blame("lock", lock.whyNot);
  if (!reading.found && !reading.hasFiles) reading.blame(folder.filename().string(), "no journal is in it");
  work.isReadable = reading.found && lock.isTaken();  // else it may belong to somebody
  work.isWhole = reading.isWhole;
  work.whyNot = reading.whyNot;
  if (!reading.found) return work;
  work.title = reading.found->last.title;
  work.scenePath = reading.found->last.path;
  work.label = reading.found->last.label;
  return work;
}

}  // namespace

std::vector<LostWork> findLostWork(const fs::path& root) {
  std::vector<LostWork> found;
  std::error_code error, ignored;
  for (fs::directory_iterator entry(root, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path& path = entry->path();
    bool isHidden = path.filename().string().starts_with('.');
    if (isHidden && !entry->is_directory(ignored)) continue;
    if (isBeingRemoved(path))
      removeFolder(path);
    else if (auto work = inspect(path))
      found.push_back(std::move(*work));
  }
  if (error && error != std::errc::no_such_file_or_directory)
    throw InputError(fmt::format("{}: unsaved work there cannot be looked for ({})", root.string(), error.message()));
  // Names begin with the time when the session began.
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::tie(a.when, a.folder) > std::tie(b.when, b.folder); });
  return found;
}

WorkClaim::WorkClaim(fs::path folder) : mFolder(std::move(folder)) {
  // Another process may be looking at it just now, for milliseconds.
  LockTry lock = tryLock(mFolder, LockKind::Exclusive);
  for (int tries = 1; lock.isHeld() && tries < 20; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    lock = tryLock(mFolder, LockKind::Exclusive);
  }
  if (lock.isHeld()) throw InputError(fmt::format("{}: this work is open in another window", mFolder.string()));
  if (!lock.isTaken())
    throw InputError(fmt::format("{}: this work cannot be taken ({})", mFolder.string(), lock.whyNot));
  mLock = lock.descriptor;
}

WorkClaim::~WorkClaim() { ::close(mLock); }

scene::Scene WorkClaim::readScene() const {
  Reading reading = readNewest(mFolder);
  if (!reading.found)
    throw InputError(fmt::format("{}: the work there cannot be read ({})", mFolder.string(),
                                 reading.whyNot.empty() ? "no journal is in it" : reading.whyNot));
  return std::move(reading.found->scene);
}

void WorkClaim::remove() {
  if (std::error_code error = removeFolder(mFolder))
    throw InputError(fmt::format("{}: cannot be deleted ({})", mFolder.string(), error.message()));
}

}  // namespace velum::session
