#include "io/models/CifColumns.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

namespace velum::io {

namespace {

using Integers = std::vector<std::int32_t>;
using Numbers = std::vector<double>;

template <class T, class To>
std::vector<To> numbersIn(std::span<const std::uint8_t> bytes) {
  static_assert(std::endian::native == std::endian::little, "BinaryCIF is little-endian");
  std::vector<To> values(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < values.size(); ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
    values[i] = To(value);
  }
  return values;
}

bool fits(std::int64_t value) {
  return value >= std::numeric_limits<std::int32_t>::min() && value <= std::numeric_limits<std::int32_t>::max();
}

}  // namespace

void CifDecoder::fail(const std::string& reason) const { refuse(path, fmt::format("column {} {}", column, reason)); }

CifColumn CifDecoder::decodeColumn(const Json& data) const {
  const Json& encodings = memberOf(data, "encoding");
  if (!encodings.is_array() || encodings.empty()) fail("has no encoding");
  if (wordOf(memberOf(encodings[0], "kind")) == "StringArray") return decodeTexts(memberOf(data, "data"), encodings[0]);
  Values values = decodeValues(memberOf(data, "data"), encodings.get_ref<const Json::array_t&>(), rows);
  CifColumn result;
  if (std::holds_alternative<Integers>(values))
    result.integers = std::get<Integers>(std::move(values));
  else
    result.numbers = std::get<Numbers>(std::move(values));
  return result;
}

std::vector<std::int32_t> CifDecoder::decodeIntegers(const Json& data) const {
  return decodeIntegers(memberOf(data, "data"), memberOf(data, "encoding"), rows);
}

std::vector<std::int32_t> CifDecoder::decodeIntegers(const Json& binary, const Json& encodings,
                                                     std::size_t most) const {
  if (!encodings.is_array()) fail("has no encoding");
  Values values = decodeValues(binary, encodings.get_ref<const Json::array_t&>(), most);
  if (!std::holds_alternative<Integers>(values)) fail("has broken numbers where whole ones belong");
  return std::get<Integers>(std::move(values));
}

CifDecoder::Values CifDecoder::decodeValues(const Json& binary, std::span<const Json> encodings,
                                            std::size_t most) const {
  if (!binary.is_binary()) fail("has no bytes");
  if (encodings.empty() || encodings.size() > 8) fail(fmt::format("has {} encodings", encodings.size()));
  if (wordOf(memberOf(encodings.back(), "kind")) != "ByteArray") fail("is encoded, but not from bytes");
  Values values = bytesAs(encodings.back(), binary.get_binary());
  for (std::size_t i = encodings.size() - 1; i-- > 0;) values = undo(encodings[i], std::move(values), most);
  return values;
}

CifDecoder::Values CifDecoder::bytesAs(const Json& encoding, std::span<const std::uint8_t> bytes) const {
  switch (int(numberOf(memberOf(encoding, "type"), path, column))) {
    case 1:
      return numbersIn<std::int8_t, std::int32_t>(bytes);
    case 2:
      return numbersIn<std::int16_t, std::int32_t>(bytes);
    case 3:
      return numbersIn<std::int32_t, std::int32_t>(bytes);
    case 4:
      return numbersIn<std::uint8_t, std::int32_t>(bytes);
    case 5:
      return numbersIn<std::uint16_t, std::int32_t>(bytes);
    case 6: {
      for (std::uint32_t value : numbersIn<std::uint32_t, std::uint32_t>(bytes))
        if (!fits(value)) fail(fmt::format("has the number {}, which is too large", value));
      return numbersIn<std::uint32_t, std::int32_t>(bytes);
    }
    case 32:
      return numbersIn<float, double>(bytes);
    case 33:
      return numbersIn<double, double>(bytes);
    default:
      fail("has bytes of no known type");
  }
}

CifDecoder::Values CifDecoder::undo(const Json& encoding, Values values, std::size_t most) const {
  std::string kind = wordOf(memberOf(encoding, "kind"));
  if (!std::holds_alternative<Integers>(values)) fail("is " + kind + " of broken numbers");
  Integers integers = std::get<Integers>(std::move(values));
  if (kind == "IntegerPacking") return unpack(encoding, integers);
  if (kind == "Delta") return sumUp(encoding, std::move(integers));
  if (kind == "RunLength") return repeat(integers, most);
  if (kind == "FixedPoint") {
    double factor = numberOf(memberOf(encoding, "factor"), path, column);
    if (factor == 0.0) fail("has the factor 0");
    Numbers numbers(integers.begin(), integers.end());
    for (double& n : numbers) n /= factor;
    return numbers;
  }
  if (kind == "IntervalQuantization") {
    double low = numberOf(memberOf(encoding, "min"), path, column);
    double high = numberOf(memberOf(encoding, "max"), path, column);
    double steps = numberOf(memberOf(encoding, "numSteps"), path, column);
    if (!(steps >= 2.0)) fail("has an interval of fewer than two steps");
    Numbers numbers(integers.begin(), integers.end());
    for (double& n : numbers) n = low + n * (high - low) / (steps - 1.0);
    return numbers;
  }
  fail("has an encoding that is not known");
}

std::vector<std::int32_t> CifDecoder::unpack(const Json& encoding, const Integers& packed) const {
  bool isOneByte = numberOf(memberOf(encoding, "byteCount"), path, column) == 1.0;
  bool isUnsigned = isTrue(memberOf(encoding, "isUnsigned"));
  std::int32_t upper = isOneByte ? (isUnsigned ? 0xff : 0x7f) : (isUnsigned ? 0xffff : 0x7fff);
  std::int32_t lower = isUnsigned ? -1 : -upper - 1;  // the unsigned ones reach it never
  Integers values;
  values.reserve(packed.size());
  std::int64_t sum = 0;
  bool isOpen = false;
  for (std::int32_t part : packed) {
    sum += part;
    isOpen = part == upper || part == lower;
    if (isOpen) continue;
    if (!fits(sum)) fail("has a packed number that is too large");
    values.push_back(std::int32_t(sum));
    sum = 0;
  }
  if (isOpen) fail("ends within a number");
  return values;
}

std::vector<std::int32_t> CifDecoder::repeat(const Integers& pairs, std::size_t most) const {
  Integers values;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    if (pairs[i + 1] < 0 || std::size_t(pairs[i + 1]) > most - values.size())
      fail("repeats values more often than there are rows");
    values.insert(values.end(), std::size_t(pairs[i + 1]), pairs[i]);
  }
  return values;
}

std::vector<std::int32_t> CifDecoder::sumUp(const Json& encoding, Integers deltas) const {
  auto sum = std::int64_t(numberOf(memberOf(encoding, "origin"), path, column));
  for (std::int32_t& value : deltas) {
    sum += value;
    if (!fits(sum)) fail("has a difference that is too large");
    value = std::int32_t(sum);
  }
  return deltas;
}

CifColumn CifDecoder::decodeTexts(const Json& binary, const Json& encoding) const {
  std::string all = wordOf(memberOf(encoding, "stringData"));
  // Runs of offsets may stand for many empty texts: no more than rows can name.
  Integers offsets = decodeIntegers(memberOf(encoding, "offsets"), memberOf(encoding, "offsetEncoding"), rows + 1);
  CifColumn result;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    std::int32_t from = offsets[i], to = offsets[i + 1];
    if (from < 0 || to < from || std::size_t(to) > all.size()) fail("has texts that reach beyond their end");
    result.texts.push_back(all.substr(std::size_t(from), std::size_t(to - from)));
  }
  result.textOf = decodeIntegers(binary, memberOf(encoding, "dataEncoding"), rows);
  for (std::int32_t text : result.textOf)
    if (text < -1 || text >= std::int32_t(result.texts.size()))
      fail(fmt::format("names text {} of {}", text, result.texts.size()));
  return result;
}

}  // namespace velum::io
