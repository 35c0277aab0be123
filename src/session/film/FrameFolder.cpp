#include "session/film/FrameFolder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <span>

#include "core/Error.h"
#include "core/ReplaceFile.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

/// What two films differ by, for people; empty where they are one.
std::string differenceOf(const FilmManifest& there, const FilmManifest& wanted) {
  if (there.frames != wanted.frames) return fmt::format("of {} frames, not {}", there.frames, wanted.frames);
  for (std::size_t i = 0; i < std::max(there.film.size(), wanted.film.size()); ++i) {
    if (i >= there.film.size()) return wanted.film[i].first;
    if (i >= wanted.film.size()) return there.film[i].first;
    const auto& [name, value] = there.film[i];
    if (there.film[i] != wanted.film[i]) return fmt::format("{} {}, not {}", name, value, wanted.film[i].second);
  }
  return {};
}

FilmManifest manifestAt(const fs::path& path) {
  if (auto manifest = readManifest(path)) return std::move(*manifest);
  throw InputError(
      fmt::format("{}: is no list of frames that Velum has written; choose another folder, or name", path.string()));
}

bool isWhole(const FrameRecord& record, const fs::path& folder) {
  auto holds = [&](const FrameFile& file) {
    std::error_code error;
    return fs::file_size(folder / file.name, error) == file.bytes && frameFileAt(folder / file.name) == file;
  };
  return !record.files.empty() && std::ranges::all_of(record.files, holds);
}

/// The manifest that another film has left in a folder goes, or is refused.
void clearOtherFilm(const fs::path& path, const FilmManifest& film, bool overwrite) {
  if (overwrite && !readManifest(path)) return manifestAt(path), void();
  FilmManifest there = manifestAt(path);
  std::string difference = differenceOf(there, film);
  if (difference.empty()) return;
  if (!overwrite)
    throw InputError(fmt::format("{}: tells of another film ({}); choose another folder, or --overwrite", path.string(),
                                 difference));
  fs::remove(path);
}

}  // namespace

std::optional<FramesThere> findFrames(const FrameNames& names, Part part, Progress& progress) {
  FramesThere there;
  std::vector<std::vector<FrameRecord>> told;  // by frame: several processes may have drawn it
  for (const fs::path& path : names.manifests()) {
    FilmManifest manifest = manifestAt(path);
    if (told.empty()) {
      there.film = {manifest.film, manifest.frames, manifest.framesPerSecond, {}};
      told.resize(std::size_t(manifest.frames));
    }
    if (std::string difference = differenceOf(manifest, there.film); !difference.empty())
      throw InputError(
          fmt::format("{}: tells of another film than the lists beside it ({})", path.string(), difference));
    for (FrameRecord& record : manifest.records) told[std::size_t(record.frame)].push_back(std::move(record));
  }
  if (told.empty()) return std::nullopt;
  there.pictures.resize(told.size());
  there.records.resize(told.size());
  int first = part.firstOf(there.film.frames), end = part.endOf(there.film.frames);
  for (int frame = first; frame < end; ++frame) {
    progress.report(double(frame - first) / (end - first), fmt::format("Looking for frame {}", frame + 1));
    auto& records = told[std::size_t(frame)];
    auto whole = std::find_if(records.rbegin(), records.rend(),
                              [&](const FrameRecord& record) { return isWhole(record, names.folder()); });
    if (whole == records.rend()) continue;
    there.pictures[std::size_t(frame)] = whole->files.front().name;
    there.records[std::size_t(frame)] = *whole;
  }
  return there;
}

std::string rangesOf(const std::vector<int>& numbers) {
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    ranges.push_back(i == last ? fmt::format("{}", numbers[i]) : fmt::format("{}-{}", numbers[i], numbers[last]));
    i = last + 1;
  }
  if (ranges.size() > kMostNamed) {
    ranges.resize(kMostNamed);
    ranges.push_back("others");
  }
  if (ranges.size() < 2) return ranges.empty() ? "" : ranges.front();
  std::string last = ranges.back();
  ranges.pop_back();
  return fmt::format("{} and {}", fmt::join(ranges, ", "), last);
}

FrameFolder::FrameFolder(const FrameNames& names, Part part, const FilmManifest& film, Old old, Progress& progress)
    : mNames(names), mManifest(names.manifest(part)), mKept(std::size_t(film.frames)) {
  std::error_code error;
  if (names.isFolder() && !fs::exists(names.folder()) && !fs::create_directory(names.folder(), error))
    throw InputError(fmt::format("{}: the folder cannot be made ({})", names.folder().string(), error.message()));
  for (const fs::path& path : names.manifests()) clearOtherFilm(path, film, old.overwrite);
  FilmManifest begun{film.film, film.frames, film.framesPerSecond, {}};
  auto there = old.resume ? findFrames(names, part, progress) : std::nullopt;
  for (int i = part.firstOf(film.frames); there && i < part.endOf(film.frames); ++i) {
    if (there->pictures[std::size_t(i)].empty()) continue;
    mKept[std::size_t(i)] = true;
    begun.records.push_back(there->records[std::size_t(i)]);
  }
  ReplaceFile file(mManifest);
  file.write(manifestText(begun));
  file.commit(ReplaceFile::Sync::ByCaller);
  mFile = file.releaseDescriptor();
}

FrameFolder::~FrameFolder() {
  if (mFile >= 0) ::close(mFile);
}

void FrameFolder::add(int frame, double ms, const std::vector<fs::path>& files) {
  FrameRecord record{frame, ms, {}, {}};
  for (const fs::path& path : files) {
    auto file = frameFileAt(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read again", path.string()));
    record.files.push_back(std::move(*file));
  }
  append(record);
}

void FrameFolder::addFailure(int frame, double ms, const std::string& error) { append({frame, ms, {}, error}); }

void FrameFolder::append(const FrameRecord& record) {
  std::string line = recordLine(record);
  if (!writeAll(mFile, std::as_bytes(std::span(line))))
    throw InputError(fmt::format("{}: cannot be written; check the free space", mManifest.string()));
}

}  // namespace velum::session
