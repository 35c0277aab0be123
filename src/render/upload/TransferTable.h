#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::render {

/// The transfer function as the shaders read it, over the range of data values in which the function, or the grey
/// window, changes.
struct TransferTable {
  glm::dvec2 domain{0.0, 1.0};  ///< Data values of table positions 0 and 1.
  double gradientMax = 1.0;     ///< Gradient magnitude of position 1 of the third row, value per length.
  double extinctionUnit = 1.0;  ///< Extinction, 1/length, of one unit of the sums.
  double mixedWhite = 1.0;      ///< Alpha of a mixture that is white in a maximum: that of one channel at its densest.
  int shownFrom = 0, shownTo = 0;  ///< First entry with any extinction, and one past the last.
  /// [kTransferSize + 1] running sums of (colour*sigma, sigma), modulo 2^32: the mean over entries i..j is (sums[j] -
  /// sums[i]) / (j - i) * extinctionUnit, exact and never negative
  std::vector<glm::uvec4> sums;
  std::vector<std::uint32_t> extinctionSums;  ///< [kTransferSize + 1] the last components of `sums` alone
  std::vector<float> gradientFactors;         ///< [kTransferSize] over 0..gradientMax
};

/// @param scene  the table is made from its volume layer's transfer function, window and iso value; where channels are
/// mixed, the table gives what the alpha of a mixed texel stands for
TransferTable makeTransferTable(const scene::Scene& scene);

/// How the channels of a volume are mixed into texels: the mixture's extinction is the sum of the channels', its colour
/// their mean by extinction. A texel's alpha is the square root of the mixture's extinction divided by the largest one;
/// its colour is multiplied by alpha.
struct MixTable {
  static constexpr int kSize = 4096;
  glm::dvec2 domain{0.0, 1.0};   ///< Values of the first and the last entry.
  double largestExtinction = 0;  ///< 1/length, of all channels together
  double largestOfOne = 0;       ///< 1/length, of the channel with the largest
  /// [channel][kSize] (colour*sigma, sigma) divided by largestExtinction
  std::vector<std::vector<glm::vec4>> channels;
};
MixTable makeMixTable(const scene::VolumeLayer& layer);

}  // namespace velum::render
