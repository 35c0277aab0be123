#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "core/LabelVolume.h"

namespace velum::io {

/// Ids of ours by the numbers that a file has for them.
using KnownIds = std::map<std::uint64_t, std::uint16_t>;

/// A file has more numbers than there are ids.
struct TooManyIds {};

/// Which id of ours stands for each number of a file, which may have 64 bits. While a file is read numbers get ids as
/// they appear, on any thread; when all have been seen, ids that depend on nothing but which numbers there are: a
/// number of at most 16 bits is its own id, others have the id that a scene knows them by, or else, in their order, the
/// smallest that are left.
class LabelNumbers {
 public:
  /// Takes numbers as they come.
  explicit LabelNumbers(KnownIds known) : mKnown(std::move(known)) {}
  /// Takes these numbers, kLargestLabel at most, and no others, which are left unlabelled.
  LabelNumbers(KnownIds known, const std::vector<std::uint64_t>& chosen);

  /// The id of a number other than 0, for the time being. Any thread. @throw TooManyIds
  std::uint16_t take(std::uint64_t number);

  /// The final ids, by those that take() gave.
  std::vector<std::uint16_t> settle() const;
  /// Rows for numbers whose id is another, ascending by id.
  std::vector<LabelInfo> table() const;

 private:
  KnownIds mKnown;
  std::mutex mGuard;
  std::unordered_map<std::uint64_t, std::uint16_t> mIds;
  std::vector<std::uint64_t> mNumbers;  ///< by id - 1
  bool mIsClosed = false;
};

/// How many voxels have each number.
using NumberCounts = std::unordered_map<std::uint64_t, std::uint64_t>;

/// The numbers that most voxels have, as many as there are ids, and before them those that a scene knows.
std::vector<std::uint64_t> mostFrequent(const NumberCounts& counts, const KnownIds& known);

}  // namespace velum::io
