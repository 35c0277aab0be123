#include "io/models/ReadModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

#include "core/Error.h"
#include "core/FileName.h"
#include "io/models/ModelReaders.h"
#include "io/models/Recipe.h"
#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {

struct ModelHead {
  Path path;
  std::string bytes;  ///< The first 64 KiB, inflated.
};

bool contains(const ModelHead& head, std::string_view text) { return head.bytes.find(text) != std::string::npos; }

/// JSON that cellPACK wrote: its recipe comes first or behind thousands of places.
bool isResults(const ModelHead& head) {
  std::size_t first = head.bytes.find_first_not_of(" \t\r\n");
  return first != std::string::npos && head.bytes[first] == '{' &&
         (contains(head, "\"ingredients\"") || contains(head, "\"recipe\"")) && contains(head, "\"results\"");
}

/// MessagePack with the keys of BinaryCIF, of which one stands in the first bytes.
bool isBinaryCif(const ModelHead& head) {
  if (head.bytes.empty()) return false;
  auto first = static_cast<unsigned char>(head.bytes.front());
  bool isMap = (first >= 0x81 && first <= 0x8f) || first == 0xde || first == 0xdf;
  return isMap && head.bytes.substr(0, 512).find("dataBlocks") != std::string::npos;
}

/// Text with a data block; all text that may stand before it is comments.
bool isCifText(const ModelHead& head) {
  std::string_view rest(head.bytes);
  while (!rest.empty()) {
    rest = rest.substr(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (!rest.starts_with('#')) break;
    rest = rest.substr(std::min(rest.find('\n'), rest.size()));
  }
  return rest.size() > 5 && lowerCase(rest.substr(0, 5)) == "data_" && contains(head, "_");
}

/// A line of an atom, and before it none that is of no such file.
bool isPdb(const ModelHead& head) {
  std::string_view rest(head.bytes);
  constexpr std::string_view kRecords[] = {"HEADER", "TITLE ", "COMPND", "REMARK", "CRYST1",
                                           "MODEL ", "EXPDTA", "AUTHOR", "SOURCE", "SEQRES"};
  while (!rest.empty()) {
    if (rest.starts_with("ATOM  ") || rest.starts_with("HETATM")) return true;
    bool isKnown = rest.starts_with('\n') || rest.starts_with('\r') ||
                   std::any_of(std::begin(kRecords), std::end(kRecords), [&](auto r) { return rest.starts_with(r); });
    bool isUsual =
        rest.size() > 6 && std::all_of(rest.begin(), rest.begin() + 3, [](char c) { return c >= 'A' && c <= 'Z'; });
    if (!isKnown && !isUsual) return false;
    std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return isKnown;  // what stands before the atoms fills what was looked at
    rest.remove_prefix(end + 1);
  }
  return false;
}

/// Bare numbers: the ending, and the recipe beside it.
bool isPacking(const ModelHead& head) { return lowerExtension(head.path) == ".bin" && recipePathBeside(head.path); }

struct ModelRow {
  ModelFormat format;
  bool (*matches)(const ModelHead&);
  Model (*read)(const Path&, Progress&, const ModelReading&);
};

// All contents are tried, in this order. A new format is one row.
constexpr ModelRow kTable[] = {
    {{"BinaryCIF", ".bcif .bcif.gz"}, isBinaryCif, readBinaryCif},
    {{"mmCIF", ".cif .cif.gz .mmcif .mmcif.gz"}, isCifText, readCifText},
    {{"cellPACK results", ".cpr .json"}, isResults, readCellPackResults},
    {{"cellPACKgpu packing", ".bin"}, isPacking, readCellPackBinary},
    {{"PDB", ".pdb .pdb.gz .ent .ent.gz .pdb1 .pdb1.gz"}, isPdb, readPdb},
};

const ModelRow* chooseReader(const ModelHead& head) {
  for (const ModelRow& row : kTable)
    if (row.matches(head)) return &row;
  return nullptr;
}

ModelHead readModelHead(const Path& path) { return {path, readHead(path, 1 << 16)}; }

}  // namespace

std::span<const ModelFormat> modelFormats() {
  static constexpr auto kFormats = [] {
    std::array<ModelFormat, std::size(kTable)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = kTable[i].format;
    return all;
  }();
  return kFormats;
}

bool looksLikeModel(const Path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && chooseReader(readModelHead(path));
}

Model readModel(const Path& path, Progress& progress, const ModelReading& reading) try {
  progress.report(0.0, "reading model");
  sizeOfFile(path);
  const ModelRow* row = chooseReader(readModelHead(path));
  if (!row) refuse(path, "is no model that can be read");
  Model model = row->read(path, progress, reading);
  if (model.name.empty()) model.name = titleOf(path);
  return model;
} catch (const std::bad_alloc&) {
  refuse(path, "needs more memory than there is");
} catch (const std::length_error&) {
  refuse(path, "is damaged (a length in it makes no sense)");
}

}  // namespace velum::io
