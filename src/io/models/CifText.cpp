#include "CifText.h"

#include <fmt/format.h>

#include <gemmi/cif.hpp>
#include <unordered_map>

#include "velum/core/FileName.h"
#include "velum/core/Text.h"

namespace velum::io {

namespace {

namespace cif = gemmi::cif;

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
    if (cif::is_null(value)) {
      mColumn.textOf.push_back(-1);
      return;
    }
    std::string text = cif::as_string(value);
    auto [at, isNew] = mPlaces.try_emplace(std::move(text), std::int32_t(mColumn.texts.size()));
    if (isNew) mColumn.texts.push_back(at->first);
    mColumn.textOf.push_back(at->second);
  }

 private:
  CifColumn& mColumn;
  bool mAreNumbers;
  std::unordered_map<std::string, std::int32_t> mPlaces;
};

void takePair(const cif::Pair& pair, CifBlock& block) {
  Tag tag = tagOf(pair[0]);
  if (!isWanted(tag.category, tag.column)) return;
  CifTable& table = block.tables[tag.category];
  if (table.rows > 1) return;
  table.rows = 1;
  CifColumn column;
  ColumnFill(column, isNumeric(tag.column)).add(pair[1]);
  table.columns[tag.column] = std::move(column);
}

void takeLoop(cif::Loop& loop, CifBlock& block) {
  if (loop.width() == 0 || loop.values.size() % loop.width() != 0) return;
  for (std::size_t c = 0; c < loop.width(); ++c) {
    Tag tag = tagOf(loop.tags[c]);
    if (!isWanted(tag.category, tag.column)) continue;
    CifTable& table = block.tables[tag.category];
    if (!table.columns.empty() && table.rows != loop.length()) return;  // the category stands there twice
    table.rows = loop.length();
    CifColumn column;
    ColumnFill fill(column, isNumeric(tag.column));
    for (std::size_t r = 0; r < loop.length(); ++r) fill.add(loop.val(r, c));
    table.columns[tag.column] = std::move(column);
  }
  std::vector<std::string>().swap(loop.values);
}

}  // namespace

std::vector<CifBlock> parseCifText(const std::string& text, const Path& path) try {
  cif::Document document = cif::read_memory(text.data(), text.size(), "line");
  std::vector<CifBlock> blocks;
  for (cif::Block& from : document.blocks) {
    CifBlock& block = blocks.emplace_back();
    block.header = from.name;
    for (cif::Item& item : from.items) {
      if (item.type == cif::ItemType::Pair) takePair(item.pair, block);
      if (item.type == cif::ItemType::Loop) takeLoop(item.loop, block);
    }
  }
  return blocks;
} catch (const std::runtime_error& error) {
  refuse(path, fmt::format("is no sound CIF: {}", inQuotes(error.what())));
}

}  // namespace velum::io
