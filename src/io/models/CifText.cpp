#include "io/models/CifText.h"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "core/FileName.h"
#include "core/Text.h"
#include "io/models/GemmiCif.h"

namespace velum::io {

namespace {

/// "_atom_site.Cartn_x" in two, lower case.
struct Tag {
  std::string category, column;
};
Tag tagOf(const std::string& name) {
  std::string lower = lowerCase(name);
  std::size_t dot = lower.find('.');
  if (dot == std::string::npos || !lower.starts_with('_')) return {};
  return {lower.substr(1, dot - 1), lower.substr(dot + 1)};
}

/// Takes the values of a column, one after the other.
class ColumnFill {
 public:
  ColumnFill(CifColumn& column, bool areNumbers) : mColumn(column), mAreNumbers(areNumbers) {}

  void add(const std::string& value) {
    if (mAreNumbers) {
      // Some write the uncertainty behind it: 1.234(5).
      std::string_view number(value);
      mColumn.numbers.push_back(numberIn(number.substr(0, number.find('('))).value_or(NAN));
      return;
    }
    if (isNullInCif(value)) {
      mColumn.textOf.push_back(-1);
      return;
    }
    auto [at, isNew] = mPlaces.try_emplace(textInCif(value), std::int32_t(mColumn.texts.size()));
    if (isNew) mColumn.texts.push_back(at->first);
    mColumn.textOf.push_back(at->second);
  }

 private:
  CifColumn& mColumn;
  bool mAreNumbers;
  std::unordered_map<std::string, std::int32_t> mPlaces;
};

class Collector : public CifListener {
 public:
  std::vector<CifBlock> blocks;

  void beginBlock(const std::string& name) override { blocks.emplace_back().header = name; }

  void takePair(const std::string& name, const std::string& value) override {
    Tag tag = tagOf(name);
    if (!isWanted(tag.category, tag.column)) return;
    CifTable& table = blocks.back().tables[tag.category];
    if (table.rows > 1) return;
    table.rows = 1;
    CifColumn column;
    ColumnFill(column, isNumeric(tag.column)).add(value);
    table.columns[tag.column] = std::move(column);
  }

  void takeLoop(const std::vector<std::string>& tags, std::vector<std::string>& values) override {
    std::size_t rows = values.size() / tags.size();
    for (std::size_t c = 0; c < tags.size(); ++c) {
      Tag tag = tagOf(tags[c]);
      if (!isWanted(tag.category, tag.column)) continue;
      CifTable& table = blocks.back().tables[tag.category];
      if (!table.columns.empty() && table.rows != rows) return;  // the category stands there twice
      table.rows = rows;
      CifColumn column;
      ColumnFill fill(column, isNumeric(tag.column));
      for (std::size_t r = 0; r < rows; ++r) fill.add(values[r * tags.size() + c]);
      table.columns[tag.column] = std::move(column);
    }
    std::vector<std::string>().swap(values);
  }
};

}  // namespace

std::vector<CifBlock> parseCifText(const std::string& text, const Path& path) try {
  Collector collector;
  parseCif(text.data(), text.size(), collector);
  return std::move(collector.blocks);
} catch (const std::runtime_error& error) {
  refuse(path, fmt::format("is no sound CIF: {}", inQuotes(error.what())));
}

}  // namespace velum::io
