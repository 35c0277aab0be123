#pragma once
#include <span>
#include <string>
#include <string_view>

namespace velum::io {

/// One row of the table of formats.
struct Format {
  std::string_view name;        ///< "NIfTI"
  std::string_view extensions;  ///< ".nii .nii.gz .hdr"
  bool canRead;
  std::string_view written;  ///< ".nii.gz .nii", the usual one first; empty: it is not written
};

/// Every volume format, in the order in which they are tried. For file dialogs, `--help` and the docs.
std::span<const Format> formats();

}  // namespace velum::io
