#pragma once
#include <string_view>

#include "core/Fields.h"

namespace velum {

/// What lengths of the world are in.
enum class LengthUnit { Millimetre, Angstrom };

template <>
struct EnumNames<LengthUnit> {
  static constexpr std::string_view kNames[] = {"mm", "angstrom"};
};

/// How long a unit is.
constexpr double millimetresPer(LengthUnit unit) { return unit == LengthUnit::Angstrom ? 1e-7 : 1.0; }
/// What a length in `from` has to be multiplied with to be in `to`; exactly 1 where they are the same.
constexpr double unitsPer(LengthUnit from, LengthUnit to) {
  return from == to ? 1.0 : from == LengthUnit::Angstrom ? 1e-7 : 1e7;
}
/// As people write it, UTF-8.
constexpr std::string_view symbolOf(LengthUnit unit) { return unit == LengthUnit::Angstrom ? "\xc3\x85" : "mm"; }

}  // namespace velum
