#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/Scene.h"

/// What the handle of a bar turns: a number that decides of each of many things, instances of a model or pixels of a
/// structure, whether it stays ([VE] 3, 7, [ACS] 3). The k-th smallest of the thresholds of all things has k of them up
/// to it.
namespace velum::session {

/// A thing about which the number decides.
struct Candidate {
  float from = 0.0f;        ///< threshold: it stays where the number is beyond
  std::uint32_t thing = 0;  ///< an instance, over all copies, or a pixel
};

/// What one number does.
struct Dial {
  std::uint64_t always = 0;           ///< things that stay whatever it is
  std::uint64_t total = 0;            ///< all there are
  std::vector<Candidate> candidates;  ///< in no order
};

/// How many things can stay, whatever the numbers are.
struct CountRange {
  std::uint64_t least = 0, most = 0;
  std::uint64_t total = 0;  ///< all there are
  CountRange& operator+=(const Dial& dial);
  bool operator==(const CountRange&) const = default;
};

/// Between which thresholds a number is with which so many candidates stay, or the nearest number of them where several
/// begin to stay at once.
struct DialGap {
  std::uint64_t staying = 0;
  float last = 0.0f;  ///< the largest threshold of those that stay; 0: none does
  float next = 0.0f;  ///< the smallest of the others; infinite: all stay
};
DialGap gapFor(const Dial& dial, std::uint64_t staying);

/// What a solver has come to.
struct Solved {
  scene::Scene scene;     ///< with its numbers set
  std::vector<int> cuts;  ///< ids of those in which they were set
  std::uint64_t wanted = 0, reached = 0;
  std::string words;  ///< one short sentence for people
};

/// Why a number could not be met.
struct DialReasons {
  std::string_view noCut, notFewer, notMore;
};
/// The sentence of what a solver has come to. @param left  what is left: where it is as many as wanted, that is all
/// @param wanted  for people
std::string wordsFor(const Solved& solved, const CountRange& range, const std::string& left, const std::string& wanted,
                     const DialReasons& reasons);

}  // namespace velum::session
