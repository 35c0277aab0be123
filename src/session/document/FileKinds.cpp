#include "session/document/FileKinds.h"

#include <fmt/format.h>

#include <sstream>

#include "io/meshes/ReadMesh.h"
#include "io/models/ReadModel.h"
#include "io/volumes/Formats.h"

namespace velum::session {

std::vector<FilePatterns> volumePatterns() {
  std::vector<FilePatterns> kinds;
  for (const auto& format : io::formats()) {
    if (!format.canRead) continue;
    FilePatterns kind{std::string(format.name), {}};
    std::istringstream words{std::string(format.extensions)};
    for (std::string word; words >> word;)
      if (word[0] == '.') kind.patterns.push_back("*" + word);
    if (!kind.patterns.empty()) kinds.push_back(std::move(kind));
  }
  return kinds;
}

std::vector<FilePatterns> readablePatterns() {
  std::vector<FilePatterns> kinds{{"Velum scene", {"*.json"}}};
  for (auto& kind : volumePatterns()) kinds.push_back(std::move(kind));
  FilePatterns& model = kinds.emplace_back("Model of molecules");
  for (const auto& format : io::modelFormats()) {
    std::istringstream words{std::string(format.extensions)};
    for (std::string word; words >> word;)
      if (word != ".json") model.patterns.push_back("*" + word);
  }
  FilePatterns& surface = kinds.emplace_back("Surface");
  for (std::string_view extension : io::meshExtensions()) surface.patterns.push_back(fmt::format("*{}", extension));
  kinds.push_back({"Picture with a scene", {"*.png", "*.exr", "*.tif", "*.tiff", "*.svg", "*.pdf"}});
  return kinds;
}

std::vector<FilePatterns> writtenPatterns(io::FileKind kind) {
  std::vector<FilePatterns> all;
  for (const io::WrittenFormat& format : io::writable(kind)) {
    FilePatterns& one = all.emplace_back(FilePatterns{format.name, {}});
    for (const std::string& ending : format.endings) one.patterns.push_back("*" + ending);
  }
  return all;
}

}  // namespace velum::session
