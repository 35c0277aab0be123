#include "session/model/LevelCache.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <optional>
#include <span>
#include <vector>

#include "core/ReplaceFile.h"
#include "model/Levels.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr std::array<char, 8> kMagic{'V', 'E', 'L', 'U', 'M', 'L', 'O', 'D'};
constexpr std::uint32_t kFileVersion = 1;
constexpr const char* kEnding = ".levels";

/// Two sums over words of 32 bits. They are no defence against somebody who makes files with equal sums on purpose:
/// such a person could as well write to the user's files.
class Sum {
 public:
  void add(std::uint32_t word) {
    mLow = (mLow ^ word) * 0x100000001b3u;
    mLow ^= mLow >> 29;
    mHigh = (mHigh + word) * 0x9e3779b97f4a7c15u;
    mHigh ^= mHigh >> 32;
  }
  void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
  void add(const glm::vec3& v) { add(v.x), add(v.y), add(v.z); }
  std::array<std::uint64_t, 2> value() const { return {mLow, mHigh}; }

 private:
  std::uint64_t mLow = 0xcbf29ce484222325u, mHigh = 0x27d4eb2f165667c5u;
};

/// The sums over all of a model that computeLevels() looks at.
std::array<std::uint64_t, 2> keyOf(const Model& model) {
  Sum sum;
  sum.add(kFileVersion);
  sum.add(model::kLevelsVersion);
  for (const Molecule& molecule : model.molecules) {
    sum.add(std::uint32_t(molecule.atoms.size()));
    for (const Atom& atom : molecule.atoms) {
      sum.add(atom.position);
      sum.add(std::uint32_t(atom.element) | std::uint32_t(atom.chain) << 8);
    }
    const bool usesBeads = molecule.atoms.empty() && !molecule.beads.empty();
    sum.add(usesBeads ? std::uint32_t(molecule.beads.front().size()) : 0u);
    if (!usesBeads) continue;
    for (const glm::vec4& bead : molecule.beads.front()) sum.add(glm::vec3(bead)), sum.add(bead.w);
  }
  return sum.value();
}

/// What a file begins with. Behind it: balls, levels, first levels, all in words of 32 bits.
struct Head {
  std::array<char, 8> magic = kMagic;
  std::array<std::uint64_t, 2> key{}, check{};
  std::uint32_t version = kFileVersion, balls = 0, levels = 0, molecules = 0;
};
constexpr std::size_t kBallWords = 5, kLevelWords = 4;
static_assert(sizeof(Head) == 56 && std::endian::native == std::endian::little);

std::uint64_t wordsOf(const Head& head) {
  return kBallWords * std::uint64_t(head.balls) + kLevelWords * std::uint64_t(head.levels) +
         std::uint64_t(head.molecules) + 1;
}

std::array<std::uint64_t, 2> checkOf(const std::vector<std::uint32_t>& words) {
  Sum sum;
  for (std::uint32_t word : words) sum.add(word);
  return sum.value();
}

/// The levels as words, member by member: padding between members in memory has no defined value.
std::vector<std::uint32_t> pack(const LevelSet& set) {
  std::vector<std::uint32_t> words;
  words.reserve(kBallWords * set.balls.size() + kLevelWords * set.levels.size() + set.firstLevel.size());
  auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  for (const Ball& ball : set.balls)
    for (std::uint32_t word : {bits(ball.centre.x), bits(ball.centre.y), bits(ball.centre.z), bits(ball.radius),
                               std::uint32_t(ball.element) | std::uint32_t(ball.chain) << 8})
      words.push_back(word);
  for (const Level& level : set.levels)
    for (std::uint32_t word : {level.first, level.count, bits(level.error), bits(level.largest)}) words.push_back(word);
  words.insert(words.end(), set.firstLevel.begin(), set.firstLevel.end());
  return words;
}

LevelSet unpack(const Head& head, const std::vector<std::uint32_t>& words) {
  LevelSet set;
  const std::uint32_t* at = words.data();
  auto number = [&] { return std::bit_cast<float>(*at++); };
  set.balls.resize(head.balls);
  for (Ball& ball : set.balls) {
    for (int axis = 0; axis < 3; ++axis) ball.centre[axis] = number();
    ball.radius = number();
    ball.element = std::uint8_t(*at & 0xff);
    ball.chain = std::uint8_t(*at++ >> 8 & 0xff);
  }
  set.levels.resize(head.levels);
  for (Level& level : set.levels) {
    level.first = *at++;
    level.count = *at++;
    level.error = number();
    level.largest = number();
  }
  set.firstLevel.assign(at, at + head.molecules + 1);
  return set;
}

std::size_t finestCount(const Molecule& molecule) {
  if (!molecule.atoms.empty() || molecule.beads.empty()) return molecule.atoms.size();
  return molecule.beads.front().size();
}

/// True when the levels are those of this model: the molecules' levels one behind the other, each level within the
/// balls, the finest with as many as the molecule has.
bool fits(const LevelSet& set, const Model& model) {
  if (set.firstLevel.front() != 0 || set.firstLevel.back() != set.levels.size()) return false;
  for (std::size_t m = 0; m < model.molecules.size(); ++m) {
    if (set.firstLevel[m] >= set.firstLevel[m + 1] || set.firstLevel[m + 1] > set.levels.size()) return false;
    if (set.levels[set.firstLevel[m]].count != finestCount(model.molecules[m])) return false;
  }
  auto isWithin = [&](const Level& level) {
    return level.first <= set.balls.size() && level.count <= set.balls.size() - level.first &&
           std::isfinite(level.error) && std::isfinite(level.largest);
  };
  return std::all_of(set.levels.begin(), set.levels.end(), isWithin);
}

std::optional<LevelSet> read(const fs::path& path, const Model& model, std::uint64_t mostBytes) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size < sizeof(Head) || size > mostBytes) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  Head head;
  if (!in.read(reinterpret_cast<char*>(&head), sizeof head)) return std::nullopt;
  const bool isOurs = head.magic == kMagic && head.version == kFileVersion && head.key == keyOf(model) &&
                      head.molecules == model.molecules.size() && size == sizeof head + 4 * wordsOf(head);
  if (!isOurs) return std::nullopt;
  std::vector<std::uint32_t> words(wordsOf(head));
  if (!in.read(reinterpret_cast<char*>(words.data()), std::streamsize(4 * words.size()))) return std::nullopt;
  if (checkOf(words) != head.check) return std::nullopt;
  LevelSet set = unpack(head, words);
  if (!fits(set, model)) return std::nullopt;
  fs::last_write_time(path, fs::file_time_type::clock::now(), error);  // used just now
  return set;
}

/// Deletes what was used longest ago, until the rest fits.
void makeRoom(const fs::path& folder, std::uint64_t bytes, std::uint64_t mostBytes) {
  struct File {
    fs::file_time_type when;
    fs::path path;
    std::uint64_t size;
  };
  std::vector<File> files;
  std::uint64_t sum = bytes;
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::error_code error;
    if (entry.path().extension() != kEnding || !entry.is_regular_file(error)) continue;
    auto size = entry.file_size(error);
    if (error) continue;  // another process was faster
    auto when = entry.last_write_time(error);
    if (error) continue;
    files.push_back({when, entry.path(), size});
    sum += size;
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.when < b.when; });
  for (const File& file : files) {
    if (sum <= mostBytes) return;
    std::error_code error;
    fs::remove(file.path, error);
    sum -= file.size;
  }
}

void write(const LevelSet& set, const Model& model, const fs::path& path, std::uint64_t mostBytes) {
  std::vector<std::uint32_t> words = pack(set);
  Head head;
  head.key = keyOf(model);
  head.check = checkOf(words);
  head.balls = std::uint32_t(set.balls.size());
  head.levels = std::uint32_t(set.levels.size());
  head.molecules = std::uint32_t(model.molecules.size());
  const std::uint64_t bytes = sizeof head + 4 * words.size();
  if (bytes > mostBytes) return;
  fs::create_directories(path.parent_path());
  std::error_code error;
  fs::remove(path, error);  // damaged, if it is there
  makeRoom(path.parent_path(), bytes, mostBytes);
  ReplaceFile file(path, ReplaceFile::Access::Owner);
  file.write(std::as_bytes(std::span(&head, 1)));
  file.write(std::as_bytes(std::span(words)));
  file.commit(ReplaceFile::Sync::ByCaller);  // nobody waits for the disk: half of it does not fit its check
}

/// The levels of a model from a file of the folder, where one fits.
std::optional<LevelSet> keptLevels(const Model& model, const fs::path& folder, std::uint64_t mostBytes) {
  if (folder.empty() || model.molecules.empty()) return std::nullopt;
  try {
    return read(levelFile(model, folder), model, mostBytes);
  } catch (const std::exception&) {  // as if there were none
    return std::nullopt;
  }
}

}  // namespace

fs::path levelFile(const Model& model, const fs::path& folder) {
  auto key = keyOf(model);
  return folder / fmt::format("{:016x}{:016x}{}", key[1], key[0], kEnding);
}

LevelSet cachedLevels(const Model& model, const fs::path& folder, Progress& progress, std::uint64_t mostBytes) {
  if (auto kept = keptLevels(model, folder, mostBytes)) return std::move(*kept);
  LevelSet set = model::computeLevels(model, progress);
  if (folder.empty() || model.molecules.empty()) return set;
  try {
    write(set, model, levelFile(model, folder), mostBytes);
  } catch (const std::exception&) {  // the next time it takes as long again
  }
  return set;
}

LevelSet keptOrQuickLevels(const Model& model, const fs::path& folder, Progress& progress) {
  auto kept = keptLevels(model, folder, kMostLevelCacheBytes);
  return kept ? std::move(*kept) : model::makeQuickLevels(model, progress);
}

}  // namespace velum::session
