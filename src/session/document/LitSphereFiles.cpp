#include "session/document/LitSphereFiles.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "scene/Finishes.h"
#include "scene/LitSpheres.h"
#include "session/document/Sources.h"

namespace velum::session {

namespace fs = std::filesystem;

Shared<Image> readLitSphere(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(fmt::format("{}: there is no such file", path.string()));
  return Shared<Image>(scene::fitLitSphere(io::readImage(path)));
}

std::vector<std::string> loadLitSpheres(scene::Scene& scene, const fs::path& folder) {
  std::vector<std::string> notes;
  for (scene::LitSphere& sphere : scene.finish.spheres) {
    if (sphere.data || sphere.source.path.empty()) continue;
    fs::path path(sphere.source.path);
    if (path.is_relative() && !folder.empty()) sphere.source.path = (folder / path).lexically_normal().string();
    try {
      sphere.data = readLitSphere(sphere.source.path);
    } catch (const InputError& wrong) {
      notes.push_back(fmt::format("lit sphere {}: {}; it looks like porcelain", sphere.name, wrong.what()));
    }
  }
  for (const std::string& name : scene::unknownLitSpheres(scene))
    notes.push_back(fmt::format("there is no lit sphere {}; it looks like porcelain", name));
  return notes;
}

std::string addLitSphere(scene::Scene& scene, const fs::path& path) {
  Shared<Image> data = readLitSphere(path);
  std::string whole = fs::absolute(path).lexically_normal().string();
  for (scene::LitSphere& sphere : scene.finish.spheres)
    if (sphere.source.path == whole) {
      sphere.data = data;
      return sphere.name;
    }
  std::string stem = path.stem().string(), name = stem;
  for (int n = 2; scene::isLitSphere(scene.finish, name); ++n) name = fmt::format("{} {}", stem, n);
  scene::LitSphere sphere;
  sphere.name = name;
  sphere.source.path = whole;
  sphere.source.fingerprint = fingerprintOf(whole);
  sphere.data = data;
  scene.finish.spheres.push_back(std::move(sphere));
  return name;
}

}  // namespace velum::session
