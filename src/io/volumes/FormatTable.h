#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/VoxelSource.h"
#include "io/read/Refuse.h"
#include "io/volumes/Formats.h"
#include "io/volumes/Readers.h"

namespace velum::io {

/// True where the source says how the samples of a headerless file lie.
bool hasRawLayout(const scene::Source& source);

/// What is known of a file before its format is chosen.
struct FileHead {
  Path path;
  std::string extension;  ///< Lower case, ".nii.gz" in one.
  std::string bytes;      ///< The first 4 KiB, inflated when the file is gzip.
};

/// A row of the table of formats, with the functions that recognise, read and write the format.
struct FormatRow {
  Format format;
  bool (*matches)(const FileHead&);  ///< Whether a file's content is of this format. Null: only the extension can tell.
  Volume (*read)(const scene::Source&, Progress&);
  /// Writes the format; null when we do not write it. The caller commits the file. Returns what was lost, one line
  /// each.
  std::vector<std::string> (*write)(const Volume&, ReplaceFile&, Progress&);
  /// Writes a format of many files, or of one that is made of many, in its own safe way; null: `write` does.
  std::vector<std::string> (*writeAlone)(const Volume&, const Path&, Progress&) = nullptr;
  /// Opens a file to read it brick by brick, or gives nothing for one that is read whole; null: all are.
  std::unique_ptr<VoxelSource> (*open)(const scene::Source&) = nullptr;

  bool isWritten() const { return write || writeAlone; }
};

std::span<const FormatRow> formatTable();
FileHead readFileHead(const Path& path);
/// The row whose format the file has, by content, else by extension; null when no row reads it.
const FormatRow* chooseReader(const FileHead& head);
/// The row that writes files with the path's extension; null when no row does.
const FormatRow* chooseWriter(const Path& path);

}  // namespace velum::io
