#pragma once
#include <string_view>

#include "core/Fields.h"

namespace velum {

/// The unit of lengths in the world.
enum class LengthUnit { Millimetre, Angstrom };

template <>
struct EnumNames<LengthUnit> {
  static constexpr std::string_view kNames[] = {"mm", "angstrom"};
};

/// The length of a unit in millimetres.
constexpr double millimetresPer(LengthUnit unit) { return unit == LengthUnit::Angstrom ? 1e-7 : 1.0; }
/// The factor that turns a length in `from` into a length in `to`; exactly 1 where the two units are the same.
constexpr double unitsPer(LengthUnit from, LengthUnit to) {
  return from == to ? 1.0 : from == LengthUnit::Angstrom ? 1e-7 : 1e7;
}
/// The unit's symbol as people write it, UTF-8.
constexpr std::string_view symbolOf(LengthUnit unit) { return unit == LengthUnit::Angstrom ? "\xc3\x85" : "mm"; }

}  // namespace velum
