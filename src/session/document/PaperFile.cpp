#include "session/document/PaperFile.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "scene/PaperPicture.h"
#include "scene/Scene.h"
#include "session/document/LitSphereFiles.h"
#include "session/document/Sources.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

Shared<Image> readPaper(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(fmt::format("{}: there is no such file", path.string()));
  return Shared<Image>(scene::fitPaper(io::readImage(path)));
}

}  // namespace

void takePaper(scene::Scene& scene, const fs::path& path) {
  scene::OwnPaper paper;
  paper.data = readPaper(path);
  paper.source.path = fs::absolute(path).lexically_normal().string();
  paper.source.fingerprint = fingerprintOf(path);
  scene.finish.ownPaper = std::move(paper);
  scene.finish.paper = scene::Paper::Own;
}

std::optional<std::string> loadPaper(scene::Scene& scene, const fs::path& folder) {
  scene::OwnPaper& paper = scene.finish.ownPaper;
  if (paper.data) return std::nullopt;
  bool isWanted = scene.finish.paper == scene::Paper::Own;
  if (paper.source.path.empty())
    return isWanted ? std::optional("own paper: no picture is named; it is smooth") : std::nullopt;
  fs::path path(paper.source.path);
  if (path.is_relative() && !folder.empty()) paper.source.path = (folder / path).lexically_normal().string();
  try {
    paper.data = readPaper(paper.source.path);
  } catch (const InputError& wrong) {
    return fmt::format("own paper: {}; it is smooth", wrong.what());
  }
  return std::nullopt;
}

std::vector<std::string> loadOwnPictures(scene::Scene& scene, const fs::path& folder) {
  std::vector<std::string> notes = loadLitSpheres(scene, folder);
  if (auto note = loadPaper(scene, folder)) notes.push_back(*note);
  return notes;
}

}  // namespace velum::session
