#include "io/images/ImageFormat.h"

#include <fmt/format.h>

#include <fstream>

#include "core/Error.h"
#include "core/FileName.h"
#include "io/images/ImageFile.h"
#include "io/read/TiffPages.h"

namespace velum::io {

std::string imageFormatOf(const std::filesystem::path& path) {
  if (path == "-") return "png";
  std::string e = lowerExtension(path);
  if (e == ".png") return "png";
  if (e == ".tif" || e == ".tiff") return "tiff";
  if (e == ".exr") return "openexr";
  throw InputError(fmt::format("{}: pictures are written as .png, .tif or .exr, not '{}'", path.string(), e));
}

bool isTiffWithoutScene(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  try {
    std::ifstream file(path, std::ios::binary);
    return !scanTiff(file, path.string(), 1).description.starts_with(kTiffScenePrefix);
  } catch (const InputError&) {
    return false;
  }
}

void expectImageFormat(const std::filesystem::path& path) { imageFormatOf(path); }

}  // namespace velum::io
