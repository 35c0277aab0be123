#include "io/stores/AxisUnits.h"

#include <string>

namespace velum::io {

namespace {

struct Prefix {
  std::string_view name, symbol;
  double factor;
};
constexpr Prefix kPrefixes[] = {{"", "", 1.0},
                                {"yocto", "y", 1e-24},
                                {"zepto", "z", 1e-21},
                                {"atto", "a", 1e-18},
                                {"femto", "f", 1e-15},
                                {"pico", "p", 1e-12},
                                {"nano", "n", 1e-9},
                                {"micro", "u", 1e-6},
                                {"micro", "\xc2\xb5", 1e-6},
                                {"micro", "\xce\xbc", 1e-6},
                                {"milli", "m", 1e-3},
                                {"centi", "c", 1e-2},
                                {"deci", "d", 1e-1},
                                {"deca", "da", 1e1},
                                {"hecto", "h", 1e2},
                                {"kilo", "k", 1e3},
                                {"mega", "M", 1e6},
                                {"giga", "G", 1e9},
                                {"tera", "T", 1e12},
                                {"peta", "P", 1e15},
                                {"exa", "E", 1e18},
                                {"zetta", "Z", 1e21},
                                {"yotta", "Y", 1e24}};

struct Unit {
  std::string_view name;
  double factor;
};
constexpr Unit kLengths[] = {{"foot", 304.8}, {"inch", 25.4},        {"mile", 1609344.0},
                             {"yard", 914.4}, {"parsec", 3.0857e19}, {"micron", 1e-3}};
constexpr Unit kTimes[] = {{"minute", 60.0}, {"hour", 3600.0}, {"day", 86400.0}};

/// "micrometer" and "micrometre", "um"; singular, as the standard wants, or plural.
std::optional<double> factorOf(std::string_view text, std::string_view name, std::string_view otherName,
                               std::string_view symbol) {
  for (const Prefix& prefix : kPrefixes) {
    if (text == std::string(prefix.symbol) + std::string(symbol)) return prefix.factor;
    if (!text.starts_with(prefix.name)) continue;
    std::string_view rest = text.substr(prefix.name.size());
    if (rest.ends_with('s')) rest.remove_suffix(1);
    if (rest == name || rest == otherName) return prefix.factor;
  }
  return std::nullopt;
}

template <std::size_t count>
std::optional<double> listed(const Unit (&units)[count], std::string_view text) {
  for (const Unit& unit : units)
    if (text == unit.name || (text.ends_with('s') && text.substr(0, text.size() - 1) == unit.name)) return unit.factor;
  return std::nullopt;
}

}  // namespace

bool isAngstrom(std::string_view unit) { return unit == "angstrom" || unit == "\xc3\x85"; }

std::optional<double> millimetresOf(std::string_view unit) {
  if (isAngstrom(unit)) return 1e-7;
  if (auto metres = factorOf(unit, "meter", "metre", "m")) return *metres * 1e3;
  return listed(kLengths, unit);
}

std::optional<double> secondsPer(std::string_view unit) {
  if (auto seconds = factorOf(unit, "second", "sec", "s")) return seconds;
  return listed(kTimes, unit);
}

}  // namespace velum::io
