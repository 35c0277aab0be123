#pragma once
#include <span>
#include <string>
#include <vector>

#include "io/read/Refuse.h"
#include "io/volumes/Formats.h"
#include "io/volumes/Readers.h"

namespace velum::io {

/// What a file shows before it is opened as anything.
struct FileHead {
  Path path;
  std::string extension;  ///< Lower case, ".nii.gz" in one.
  std::string bytes;      ///< The first 4 KiB, inflated when the file is gzip.
};

/// A row of the table of formats with what it takes to read and write it.
struct FormatRow {
  Format format;
  bool (*matches)(const FileHead&);  ///< The content says so. Null: only the extension can tell.
  Volume (*read)(const scene::Source&, Progress&);
  /// Null when we do not write it. The caller commits. Returns what was lost.
  std::vector<std::string> (*write)(const Volume&, ReplaceFile&, Progress&);
};

std::span<const FormatRow> formatTable();
FileHead readFileHead(const Path& path);
/// The row that reads the file: by content, else by extension; null when none does.
const FormatRow* chooseReader(const FileHead& head);
/// The row that writes files of this extension; null when none does.
const FormatRow* chooseWriter(const Path& path);

}  // namespace velum::io
