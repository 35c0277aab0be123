#include "velum/io/models/ReadModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

#include "ModelReaders.h"
#include "read/ByteSource.h"
#include "read/FileBytes.h"
#include "read/FileNames.h"
#include "velum/core/Error.h"
#include "velum/core/FileName.h"

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

struct ModelRow {
  ModelFormat format;
  bool (*matches)(const ModelHead&);
  Model (*read)(const Path&, Progress&, const ModelReading&);
};

// All contents are tried, in this order. A new format is one row.
constexpr ModelRow kTable[] = {
    {{"cellPACK results", ".cpr .json"}, isResults, readCellPackResults},
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
