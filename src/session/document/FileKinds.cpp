#include "velum/session/document/FileKinds.h"

#include <fmt/format.h>

#include <sstream>

#include "velum/io/meshes/ReadMesh.h"
#include "velum/io/models/ReadModel.h"
#include "velum/io/volumes/Formats.h"

namespace velum::session {

std::vector<FileKind> volumeKinds() {
  std::vector<FileKind> kinds;
  for (const auto& format : io::formats()) {
    if (!format.canRead) continue;
    FileKind kind{std::string(format.name), {}};
    std::istringstream words{std::string(format.extensions)};
    for (std::string word; words >> word;)
      if (word[0] == '.') kind.patterns.push_back("*" + word);
    if (!kind.patterns.empty()) kinds.push_back(std::move(kind));
  }
  return kinds;
}

std::vector<FileKind> readableKinds() {
  std::vector<FileKind> kinds{{"Velum scene", {"*.json"}}};
  for (auto& kind : volumeKinds()) kinds.push_back(std::move(kind));
  FileKind& model = kinds.emplace_back("Model of molecules");
  for (const auto& format : io::modelFormats()) {
    std::istringstream words{std::string(format.extensions)};
    for (std::string word; words >> word;)
      if (word != ".json") model.patterns.push_back("*" + word);
  }
  FileKind& surface = kinds.emplace_back("Surface");
  for (std::string_view extension : io::meshExtensions()) surface.patterns.push_back(fmt::format("*{}", extension));
  kinds.push_back({"Picture with a scene", {"*.png", "*.exr"}});
  return kinds;
}

}  // namespace velum::session
