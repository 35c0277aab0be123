#include "io/models/CifTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/Text.h"

namespace velum::io {

namespace {

struct WantedRow {
  std::string_view category;
  std::string_view columns;  ///< Blanks before and behind each; those of matrices are understood.
};
constexpr WantedRow kWanted[] = {
    {"entity", " id details formula_weight pdbx_description pdbx_fragment pdbx_parent_entity_id type "},
    {"atom_site",
     " group_pdb type_symbol label_atom_id label_comp_id label_asym_id auth_asym_id label_entity_id auth_seq_id "
     "cartn_x "
     "cartn_y cartn_z pdbx_pdb_model_num "},
    {"pdbx_struct_assembly", " id details method_details "},
    {"pdbx_struct_assembly_gen", " assembly_id oper_expression asym_id_list pdb_model_num "},
    {"pdbx_struct_oper_list", " id "},
    {"pdbx_model", " name instances description "},
    {"struct", " title "},
};

bool isOfMatrix(std::string_view column) { return column.starts_with("matrix[") || column.starts_with("vector["); }

}  // namespace

std::size_t CifColumn::size() const { return std::max({integers.size(), numbers.size(), textOf.size()}); }

bool CifColumn::isKnown(std::size_t row) const {
  return (mask.empty() || mask[row] == 0) && (textOf.empty() || textOf[row] >= 0);
}

double CifColumn::number(std::size_t row) const {
  if (!isKnown(row)) return NAN;
  if (!integers.empty()) return integers[row];
  if (!numbers.empty()) return numbers[row];
  return numberIn(texts[std::size_t(textOf[row])]).value_or(NAN);
}

std::string CifColumn::text(std::size_t row) const {
  if (!isKnown(row)) return {};
  if (!integers.empty()) return std::to_string(integers[row]);
  if (!numbers.empty()) return std::to_string(numbers[row]);
  return texts[std::size_t(textOf[row])];
}

CifColumn::Codes CifColumn::codes() const {
  Codes codes;
  codes.ofRow.reserve(size());
  std::unordered_map<std::int64_t, std::uint32_t> seen;
  constexpr std::int64_t kUnknown = std::int64_t(1) << 40;
  for (std::size_t row = 0; row < size(); ++row) {
    std::int64_t key = kUnknown;
    if (isKnown(row))
      key = !integers.empty() ? integers[row] : !numbers.empty() ? std::llround(numbers[row]) : textOf[row];
    auto [at, isNew] = seen.try_emplace(key, std::uint32_t(codes.names.size()));
    if (isNew) codes.names.push_back(text(row));
    codes.ofRow.push_back(at->second);
  }
  return codes;
}

const CifColumn* CifTable::find(std::string_view name) const {
  auto at = columns.find(name);
  return at == columns.end() ? nullptr : &at->second;
}

std::string CifTable::text(std::string_view name, std::size_t row) const {
  const CifColumn* column = find(name);
  return column ? column->text(row) : std::string();
}

double CifTable::number(std::string_view name, std::size_t row) const {
  const CifColumn* column = find(name);
  return column ? column->number(row) : NAN;
}

const CifTable* CifBlock::find(std::string_view name) const {
  auto at = tables.find(name);
  return at == tables.end() || at->second.rows == 0 ? nullptr : &at->second;
}

bool isWanted(std::string_view category, std::string_view column) {
  for (const WantedRow& row : kWanted)
    if (row.category == category)
      return row.columns.find(" " + std::string(column) + " ") != std::string_view::npos ||
             (category == "pdbx_struct_oper_list" && isOfMatrix(column));
  return false;
}

bool isNumeric(std::string_view column) {
  return column.starts_with("cartn_") || column == "formula_weight" || isOfMatrix(column);
}

}  // namespace velum::io
