#include "io/models/BinaryCif.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <variant>

#include "core/FileName.h"
#include "io/models/CifColumns.h"
#include "io/read/JsonParts.h"

namespace velum::io {

namespace {

/// Says no to what is nested deeper than any BinaryCIF: the library goes down by recursion.
class DepthGuard : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return ++mDepth <= kMost; }
  bool end_object() override { return --mDepth, true; }
  bool start_array(std::size_t) override { return ++mDepth <= kMost; }
  bool end_array() override { return --mDepth, true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  static constexpr int kMost = 32;
  int mDepth = 0;
};

class Parser {
 public:
  Parser(const std::string& bytes, const Path& path) : mBytes(bytes), mPath(path) {}

  std::vector<CifBlock> parse() {
    DepthGuard guard;
    if (!Json::sax_parse(mBytes, &guard, nlohmann::detail::input_format_t::msgpack))
      refuse(mPath, "is no sound BinaryCIF: its MessagePack is damaged or cut short");
    Json root = Json::from_msgpack(mBytes);
    const Json& blocks = memberOf(root, "dataBlocks");
    if (!blocks.is_array()) refuse(mPath, "is no BinaryCIF: it has no data blocks");
    std::vector<CifBlock> result;
    for (const Json& block : blocks) result.push_back(parseBlock(block));
    return result;
  }

 private:
  CifBlock parseBlock(const Json& json) {
    CifBlock block{.header = wordOf(memberOf(json, "header")), .tables = {}};
    const Json& categories = memberOf(json, "categories");
    if (!categories.is_array()) return block;
    for (const Json& category : categories) {
      std::string name = lowerCase(wordOf(memberOf(category, "name")));
      if (name.starts_with('_')) name.erase(0, 1);
      const Json &count = memberOf(category, "rowCount"), &columns = memberOf(category, "columns");
      if (!columns.is_array()) continue;
      CifTable table{.rows = rowsOf(name, count), .columns = {}};
      for (const Json& column : columns) {
        std::string title = lowerCase(wordOf(memberOf(column, "name")));
        if (isWanted(name, title)) table.columns[title] = parseColumn(column, table.rows, "_" + name + "." + title);
      }
      if (!table.columns.empty()) block.tables[name] = std::move(table);
    }
    return block;
  }

  /// A row takes a byte at least: of atoms and operators three, which places cannot do without.
  std::size_t rowsOf(const std::string& name, const Json& count) const {
    double rows = count.is_number() ? count.get<double>() : -1.0;
    double bytesEach = name == "atom_site" || name == "pdbx_struct_oper_list" ? 3.0 : 1.0;
    if (!(rows >= 0.0 && rows * bytesEach <= double(mBytes.size())))
      refuse(mPath, fmt::format("category _{} promises {} rows, more than the file can hold", name, rows));
    return std::size_t(rows);
  }

  CifColumn parseColumn(const Json& json, std::size_t rows, const std::string& name) const {
    CifDecoder decoder{mPath, name, rows};
    CifColumn column = decoder.decodeColumn(memberOf(json, "data"));
    if (const Json& mask = memberOf(json, "mask"); mask.is_object()) {
      std::vector<std::int32_t> values = decoder.decodeIntegers(mask);
      column.mask.assign(values.begin(), values.end());
    }
    if (column.size() != rows || (!column.mask.empty() && column.mask.size() != rows))
      refuse(mPath, fmt::format("column {} has {} values in {} rows", name, column.size(), rows));
    return column;
  }

  const std::string& mBytes;
  const Path& mPath;
};

}  // namespace

std::vector<CifBlock> parseBinaryCif(const std::string& bytes, const Path& path) try {
  return Parser(bytes, path).parse();
} catch (const Json::exception&) {
  refuse(path, "is no sound BinaryCIF: its MessagePack is damaged");
}

}  // namespace velum::io
