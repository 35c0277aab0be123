#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/Scene.h"

/// What the handle of a bar turns: one number that decides, for each of many things (instances of a model, or pixels of
/// a structure), whether the thing stays ([VE] 3, 7, [ACS] 3). Each thing has a threshold and stays where the number is
/// beyond its threshold; so k things stay while the number lies between the k-th smallest threshold and the next one.
namespace velum::session {

/// A thing that stays or goes as the number says.
struct Candidate {
  float from = 0.0f;        ///< threshold: the thing stays where the number is beyond it
  std::uint32_t thing = 0;  ///< index of an instance, over all copies, or of a pixel
};

/// All things about which one number decides.
struct Dial {
  std::uint64_t always = 0;           ///< how many things stay whatever the number is
  std::uint64_t total = 0;            ///< how many things there are, with those that never stay
  std::vector<Candidate> candidates;  ///< the things that stay or go with the number, in no order
};

/// The least and the most things that can stay, over all values of the numbers.
struct CountRange {
  std::uint64_t least = 0, most = 0;
  std::uint64_t total = 0;  ///< how many things there are, with those that never stay
  CountRange& operator+=(const Dial& dial);
  bool operator==(const CountRange&) const = default;
};

/// The gap between two thresholds within which a number lets so many candidates stay. Where several candidates begin to
/// stay at one threshold that many may be impossible: then the gap is for the nearest number of candidates that is
/// possible.
struct DialGap {
  std::uint64_t staying = 0;
  float last = 0.0f;  ///< the largest threshold of the candidates that stay; 0: none stays
  float next = 0.0f;  ///< the smallest threshold of the candidates that go; infinite: all stay; 0: none stays
};
DialGap gapFor(const Dial& dial, std::uint64_t staying);

/// Parts of a number in proportion to weights, by largest remainders. @param count  at most the sum of the weights
std::vector<std::uint64_t> apportion(const std::vector<std::uint64_t>& weights, std::uint64_t count);

/// What a solver has found.
struct Solved {
  scene::Scene scene;     ///< with the numbers set that were found
  std::vector<int> cuts;  ///< ids of the cuts whose numbers were set
  std::uint64_t wanted = 0, reached = 0;
  std::string words;  ///< one short sentence for people
};

/// Texts that say why the wanted number of things could not be reached: no cut can be set, fewer cannot stay, more
/// cannot.
struct DialReasons {
  std::string_view noCut, notFewer, notMore;
};
/// The sentence about what a solver has found.
/// @param left  says how many things are left; the whole sentence where that is the wanted number
/// @param wanted  the wanted number as text for people
std::string wordsFor(const Solved& solved, const CountRange& range, const std::string& left, const std::string& wanted,
                     const DialReasons& reasons);

}  // namespace velum::session
