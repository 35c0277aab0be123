#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/Model.h"
#include "core/Task.h"

namespace velum::io {

/// A row of the table of model formats.
struct ModelFormat {
  std::string_view name;        ///< "BinaryCIF"
  std::string_view extensions;  ///< ".bcif .bcif.gz"
};
/// All formats of models, in the order in which they are tried. For file dialogs and `info --formats`.
std::span<const ModelFormat> modelFormats();

/// True when a reader of models takes the file, by its content or by its ending and what lies beside it.
/// Any thread; reads the file's first bytes.
bool looksLikeModel(const std::filesystem::path& path);

struct ModelReading {
  /// Add the parts that the files mention but do not hold: lipids of an envelope, the strand in a capsid.
  bool completes = true;
};

/// Reads a model of any of modelFormats().
///
/// The model is right-handed, in angstrom. Structures that the file names are searched for in its folder, in the
/// folders inside that, and in folders of structures beside it, and nowhere else.
/// @throw InputError for a file that is missing, damaged or of no such format, naming the file and the reason;
/// Cancelled
/// @note Any thread.
Model readModel(const std::filesystem::path& path, Progress& progress, const ModelReading& reading = {});

}  // namespace velum::io
