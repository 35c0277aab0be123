#include "io/images/ImageFormat.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "core/FileName.h"
#include "io/images/ImageFile.h"

namespace velum::io {

std::string imageFormatOf(const std::filesystem::path& path) {
  if (path == "-") return "png";
  std::string e = lowerExtension(path);
  if (e == ".png") return "png";
  if (e == ".tif" || e == ".tiff") return "tiff";
  if (e == ".exr") return "openexr";
  throw InputError(fmt::format("{}: pictures are written as .png, .tif or .exr, not '{}'", path.string(), e));
}

void expectImageFormat(const std::filesystem::path& path) { imageFormatOf(path); }

}  // namespace velum::io
