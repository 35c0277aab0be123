#include "velum/session/document/Recovery.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "JournalFiles.h"
#include "velum/core/Error.h"
#include "velum/scene/json/ChangeLog.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr auto kOrphanAge = std::chrono::hours(1);

/// The newest generation of which a scene can be made.
std::optional<scene::Replayed> readNewest(const fs::path& folder) {
  for (int generation : generationsIn(folder)) {
    auto found = scene::replay(readWhole(autosavePath(folder, generation)), readWhole(journalPath(folder, generation)));
    if (found) return found;
  }
  return std::nullopt;
}

std::chrono::system_clock::time_point timeOf(const fs::path& path) {
  std::error_code error;
  auto time = fs::last_write_time(path, error);
  if (error) return {};
  return std::chrono::file_clock::to_sys(time);
}

std::chrono::system_clock::time_point lastWrite(const fs::path& folder) {
  std::chrono::system_clock::time_point last{};
  for (int generation : generationsIn(folder))
    last = std::max({last, timeOf(journalPath(folder, generation)), timeOf(autosavePath(folder, generation))});
  return last;
}

/// A folder that was never published: its session died while it made it.
void removeOrphan(const fs::path& folder) {
  auto age = std::chrono::system_clock::now() - timeOf(folder);
  if (age < kOrphanAge) return;
  int lock = tryLock(folder, LockKind::Exclusive);
  std::error_code ignored;
  if (lock >= 0 || !fs::exists(folder / "lock", ignored)) fs::remove_all(folder, ignored);
  if (lock >= 0) ::close(lock);
}

std::optional<LostWork> inspect(const fs::path& folder) {
  int lock = tryLock(folder, LockKind::Shared);
  if (lock < 0) return std::nullopt;  // its session lives
  LostWork work;
  work.folder = folder;
  work.when = lastWrite(folder);
  if (auto found = readNewest(folder)) {
    work.title = found->last.title;
    work.scenePath = found->last.path;
    work.label = found->last.label;
  } else {
    work.isReadable = false;
  }
  ::close(lock);
  return work;
}

}  // namespace

std::vector<LostWork> findLostWork(const fs::path& root) {
  std::vector<LostWork> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(root, error)) {
    std::error_code ignored;
    if (!entry.is_directory(ignored)) continue;
    if (entry.path().filename().string().starts_with('.')) {
      removeOrphan(entry.path());
      continue;
    }
    if (auto work = inspect(entry.path())) found.push_back(std::move(*work));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.when > b.when; });
  return found;
}

WorkClaim::WorkClaim(fs::path folder) : mFolder(std::move(folder)) {
  // Another process may be looking at it just now, for milliseconds.
  for (int tries = 0; mLock < 0 && tries < 20; ++tries) {
    if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    mLock = tryLock(mFolder, LockKind::Exclusive);
    if (mLock < 0 && !fs::exists(mFolder / "lock")) break;
  }
  if (mLock < 0)
    throw InputError(fmt::format("{}: this work is open in another window, or was taken or removed", mFolder.string()));
}

WorkClaim::~WorkClaim() { ::close(mLock); }

scene::Scene WorkClaim::readScene() const {
  auto found = readNewest(mFolder);
  if (!found) throw InputError(fmt::format("{}: the journal there is damaged and cannot be read", mFolder.string()));
  return std::move(found->scene);
}

void WorkClaim::remove() {
  std::error_code ignored;
  fs::remove_all(mFolder, ignored);
}

}  // namespace velum::session
