#include "model/Levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "core/Parallel.h"
#include "model/BallGrid.h"
#include "model/Silhouette.h"

namespace velum::model {

namespace {

// With any of these, and with what is done with them, kLevelsVersion changes.
constexpr float kFirstCell = 4.0f;    // angstrom: clusters of a residue's side chain, some three heavy atoms
constexpr float kCoarser = 1.5f;      // from level to level: a third of the balls
constexpr float kFewer = 0.75f;       // a level with more of the balls of the last is not worth its memory
constexpr int kMeans = 2;             // turns of k-means: it hardly moves after that
constexpr std::size_t kGrain = 4096;  // balls that a core takes at a time
// What of the sphere around a cluster is tried for a radius: the middle of it fits best, as neighbours overlap.
constexpr float kShares[] = {0.72f, 0.80f, 0.88f, 1.0f};
constexpr int kDirections = 42;
// What computeLevels() finds for most clusters of proteins and lipids: the share, and the error in cells. Cells that
// no mean has moved are somewhat worse.
constexpr float kQuickShare = 0.80f, kQuickError = 0.8f;
constexpr float kUnmeasured = 1e-3f;  // angstrom: what the finest of quick levels claims, which nobody sees

/// Directions all around, evenly [FIBONACCI].
std::array<glm::vec3, kDirections> directions() {
  std::array<glm::vec3, kDirections> all;
  for (int i = 0; i < kDirections; ++i) {
    float z = 1.0f - (2.0f * float(i) + 1.0f) / kDirections, r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    float turn = 2.39996323f * float(i);
    all[std::size_t(i)] = {r * std::cos(turn), r * std::sin(turn), z};
  }
  return all;
}

std::vector<Ball> finestOf(const Molecule& molecule) {
  std::vector<Ball> balls;
  for (const Atom& atom : molecule.atoms)
    balls.push_back({atom.position, radiusOf(atom.element), atom.element, std::uint8_t(atom.chain & 0xff)});
  if (balls.empty() && !molecule.beads.empty())
    for (const glm::vec4& bead : molecule.beads.front()) balls.push_back({glm::vec3(bead), bead.w, kResidue, 0});
  return balls;
}

/// What balls come together: clusters of those of the level before, and, by these, of the finest.
struct Clusters {
  std::vector<glm::vec3> centres;  ///< Means of the finest.
  std::vector<float> weights;      ///< How many of the finest each holds.
  std::vector<std::uint32_t> of;   ///< By the finest.
};

Clusters eachByItself(std::span<const Ball> balls) {
  Clusters clusters;
  for (const Ball& ball : balls) clusters.centres.push_back(ball.centre);
  clusters.weights.assign(balls.size(), 1.0f);
  clusters.of.resize(balls.size());
  std::iota(clusters.of.begin(), clusters.of.end(), 0u);
  return clusters;
}

/// Means of what each cluster holds; those that hold nothing go. @param of  by `from`: its cluster
Clusters meansOf(const Clusters& from, std::vector<std::uint32_t>& of, std::size_t count) {
  std::vector<glm::dvec3> sums(count, glm::dvec3(0.0));
  std::vector<float> weights(count, 0.0f);
  for (std::size_t i = 0; i < of.size(); ++i) {
    sums[of[i]] += glm::dvec3(from.centres[i]) * double(from.weights[i]);
    weights[of[i]] += from.weights[i];
  }
  Clusters out;
  std::vector<std::uint32_t> now(count);
  for (std::size_t c = 0; c < count; ++c) {
    now[c] = std::uint32_t(out.centres.size());
    if (weights[c] == 0.0f) continue;
    out.centres.emplace_back(sums[c] / double(weights[c]));
    out.weights.push_back(weights[c]);
  }
  for (auto& c : of) c = now[c];
  return out;
}

/// Cells of a grid, then so many turns of k-means.
Clusters coarser(const Clusters& from, float cell, int turns) {
  // By sorting: cells in their order whatever comes first.
  glm::vec3 low = from.centres.front();
  for (const glm::vec3& centre : from.centres) low = glm::min(low, centre);
  std::vector<std::pair<std::array<int, 3>, std::uint32_t>> byCell;
  byCell.reserve(from.centres.size());
  for (std::size_t i = 0; i < from.centres.size(); ++i) {
    glm::ivec3 at(glm::floor((from.centres[i] - low) / cell));
    byCell.push_back({{at.z, at.y, at.x}, std::uint32_t(i)});
  }
  std::sort(byCell.begin(), byCell.end());
  std::vector<std::uint32_t> of(from.centres.size());
  std::uint32_t count = 0;
  for (std::size_t k = 0; k < byCell.size(); ++k) {
    if (k == 0 || byCell[k].first != byCell[k - 1].first) ++count;
    of[byCell[k].second] = count - 1;
  }
  Clusters out = meansOf(from, of, count);
  for (int turn = 0; turn < turns && out.centres.size() > 1; ++turn) {
    std::vector<Ball> middles;
    for (const glm::vec3& centre : out.centres) middles.push_back({centre, 0.0f});
    BallGrid grid(middles, cell);
    parallelForRanges(std::size_t(0), of.size(), kGrain, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        float best = std::numeric_limits<float>::max();
        grid.forNear(from.centres[i], cell, [&](std::uint32_t c) {
          glm::vec3 d = middles[c].centre - from.centres[i];
          float squared = glm::dot(d, d);
          if (squared < best || (squared == best && c < of[i])) best = squared, of[i] = c;
        });
      }
    });
    out = meansOf(from, of, out.centres.size());
  }
  out.of = from.of;
  for (auto& c : out.of) c = of[c];
  return out;
}

/// A ball a cluster, as large as holds all of it.
std::vector<Ball> ballsAround(std::span<const Ball> balls, const Clusters& clusters) {
  std::vector<Ball> out(clusters.centres.size());
  // The chain of most of it, by a vote in one turn (Boyer and Moore); where none has most of it, one of the frequent
  // ones.
  std::vector<int> votes(out.size(), 0);
  for (std::size_t c = 0; c < out.size(); ++c) out[c].centre = clusters.centres[c];
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Ball& ball = out[clusters.of[i]];
    ball.radius = std::max(ball.radius, glm::length(balls[i].centre - ball.centre) + balls[i].radius);
    int& vote = votes[clusters.of[i]];
    if (vote == 0) ball.chain = balls[i].chain;
    vote += ball.chain == balls[i].chain ? 1 : -1;
  }
  return out;
}

float largestOf(std::span<const Ball> balls) {
  float largest = 0.0f;
  for (const Ball& ball : balls) largest = std::max(largest, ball.radius);
  return largest;
}

/// Balls with what it takes to ask about places near them.
struct Shape {
  explicit Shape(std::span<const Ball> of) : balls(of), largest(largestOf(of)), grid(of, std::max(largest, 1.0f)) {}
  bool covers(glm::vec3 p, std::size_t but) const {
    bool isCovered = false;
    grid.forNear(p, largest, [&](std::uint32_t j) {
      glm::vec3 d = balls[j].centre - p;
      isCovered = isCovered || (j != but && glm::dot(d, d) < balls[j].radius * balls[j].radius);
    });
    return isCovered;
  }
  std::span<const Ball> balls;
  float largest;
  BallGrid grid;
};

/// Without those that others cover all over: nobody ever sees them.
std::vector<Ball> withoutCovered(const std::vector<Ball>& balls) {
  static const auto kAround = directions();
  Shape shape(balls);
  std::vector<std::uint8_t> isSeen(balls.size());
  parallelForRanges(std::size_t(0), balls.size(), kGrain, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      isSeen[i] = !std::all_of(kAround.begin(), kAround.end(), [&](const glm::vec3& direction) {
        return shape.covers(balls[i].centre + balls[i].radius * direction, i);
      });
  });
  std::vector<Ball> seen;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (isSeen[i]) seen.push_back(balls[i]);
  return seen;
}

constexpr float kPixelsPerCell = 8.0f;  // of silhouettes: finer changes no level by much

constexpr glm::vec3 kSides[] = {
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.57735f, 0.57735f, 0.57735f}, {0.57735f, -0.57735f, 0.57735f}};

/// Radii as shares of those of balls that hold their clusters, by which the outline is least off at the side where it
/// is most, and how far it is.
std::pair<std::size_t, float> bestShare(std::span<const Ball> finest, std::span<const Ball> around, float cell) {
  std::array<std::array<float, std::size(kShares)>, std::size(kSides)> errors{};
  parallelFor(std::size_t(0), std::size(kSides), [&](std::size_t side) {
    Silhouette wanted(kSides[side], around, cell / kPixelsPerCell);
    wanted.add(finest);
    std::vector<Ball> tried(around.begin(), around.end());
    for (std::size_t share = 0; share < std::size(kShares); ++share) {
      for (std::size_t i = 0; i < tried.size(); ++i) tried[i].radius = around[i].radius * kShares[share];
      Silhouette own = wanted.blank();
      own.add(tried);
      errors[side][share] = distanceBetween(wanted, own);
    }
  });
  std::pair<std::size_t, float> best{0, std::numeric_limits<float>::max()};
  for (std::size_t share = 0; share < std::size(kShares); ++share) {
    float worst = 0.0f;
    for (const auto& side : errors) worst = std::max(worst, side[share]);
    if (worst < best.second) best = {share, worst};
  }
  return best;
}

/// How levels are made: measured and moved until they fit, or in haste.
enum class Care { Measured, Quick };

/// The levels of one molecule.
struct Made {
  std::vector<std::vector<Ball>> levels;
  std::vector<float> errors;
};

Made makeLevels(const Molecule& molecule, Care care) {
  Made made{{finestOf(molecule)}, {care == Care::Quick ? kUnmeasured : 0.0f}};
  auto& levels = made.levels;
  const std::vector<Ball> finest = levels.front();
  if (finest.size() < 2) return made;
  Clusters clusters = eachByItself(finest);
  // Beads are as coarse as they are: what is finer than they are stands for one each.
  for (float cell = std::max(kFirstCell, 2.0f * largestOf(finest)); levels.back().size() > 1; cell *= kCoarser) {
    clusters = coarser(clusters, cell, care == Care::Quick ? 0 : kMeans);
    std::vector<Ball> around = ballsAround(finest, clusters);
    if (float(around.size()) > kFewer * float(levels.back().size())) continue;
    if (care == Care::Quick) {
      for (Ball& ball : around) ball.radius *= kQuickShare;
      levels.push_back(std::move(around));
      made.errors.push_back(kQuickError * cell);
      continue;
    }
    auto [share, error] = bestShare(finest, around, cell);
    for (Ball& ball : around) ball.radius *= kShares[share];
    levels.push_back(withoutCovered(around));
    made.errors.push_back(std::max(error, made.errors.back()));
  }
  return made;
}

/// The levels of all molecules. Tells by their atoms how far it has come.
std::vector<Made> makeAll(const Model& model, Care care, Progress& progress) {
  const std::string what = "levels of detail";
  progress.report(0.0, what);
  std::size_t all = 1, done = 0;
  for (const Molecule& molecule : model.molecules) all += molecule.atoms.size();
  std::mutex telling;
  std::vector<Made> made(model.molecules.size());
  parallelFor(std::size_t(0), made.size(), [&](std::size_t m) {
    progress.throwIfCancelled();
    made[m] = makeLevels(model.molecules[m], care);
    std::lock_guard lock(telling);
    done += model.molecules[m].atoms.size();
    progress.report(double(done) / double(all), what);
  });
  return made;
}

/// One behind the other.
LevelSet setOf(const std::vector<Made>& made) {
  LevelSet set;
  for (const Made& molecule : made) {
    set.firstLevel.push_back(std::uint32_t(set.levels.size()));
    for (std::size_t l = 0; l < molecule.levels.size(); ++l) {
      const auto& balls = molecule.levels[l];
      set.levels.push_back(
          {std::uint32_t(set.balls.size()), std::uint32_t(balls.size()), molecule.errors[l], largestOf(balls)});
      set.balls.insert(set.balls.end(), balls.begin(), balls.end());
    }
  }
  set.firstLevel.push_back(std::uint32_t(set.levels.size()));
  return set;
}

}  // namespace

std::vector<std::vector<Ball>> computeLevels(const Molecule& molecule, std::vector<float>* errors) {
  Made made = makeLevels(molecule, Care::Measured);
  if (errors) *errors = std::move(made.errors);
  return std::move(made.levels);
}

LevelSet computeLevels(const Model& model, Progress& progress) {
  return setOf(makeAll(model, Care::Measured, progress));
}

LevelSet makeQuickLevels(const Model& model, Progress& progress) {
  return setOf(makeAll(model, Care::Quick, progress));
}

bool areQuick(const LevelSet& set) { return !set.levels.empty() && set.levels.front().error == kUnmeasured; }

}  // namespace velum::model
