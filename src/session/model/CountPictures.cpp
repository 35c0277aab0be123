#include "velum/session/model/CountPictures.h"

#include <fmt/format.h>

#include "velum/core/Error.h"
#include "velum/core/ReplaceFile.h"
#include "velum/gpu/Context.h"
#include "velum/render/Renderer.h"
#include "velum/session/model/CountFiles.h"
#include "velum/session/model/PictureCounter.h"

namespace velum::session {

Solved findVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                   glm::ivec2 size, Progress& progress) {
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  Progress inPicture([&progress](double, const std::string&) { progress.throwIfCancelled(); });
  PictureCounter counter(renderer, size, context->limits(), inPicture);
  int pictures = 0;
  auto picture = [&](const scene::Scene& of) {
    progress.report(double(pictures++) / kMostPicturesOfOne, "Counting what is seen");
    return counter.count(of);
  };
  return solveVisible(scene, cuts, path, wanted, picture, {}, counter.aspect());
}

TargetsReport findTargets(scene::Scene scene, glm::ivec2 size, Progress& progress) {
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  Progress inPicture([&progress](double, const std::string&) { progress.throwIfCancelled(); });
  PictureCounter counter(renderer, size, context->limits(), inPicture);
  int pictures = 0;
  auto picture = [&](const scene::Scene& of) {
    progress.report(double(pictures++) / kMostPictures, "Counting what is seen");
    return counter.count(of);
  };
  std::vector<int> cuts = cutsToSet(scene);
  return solveTargets(scene, cuts, scene.model.targets, picture, {}, counter.aspect());
}

void writeBars(const scene::Scene& scene, glm::ivec2 size, const std::filesystem::path& path, Progress& progress) {
  if (!scene.model.data) throw InputError("there is no model to count in");
  std::string extension = path.extension().string();
  if (extension != ".svg" && extension != ".csv")
    throw InputError(fmt::format("{}: bars are written as .svg or .csv", path.string()));
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  PictureCounter counter(renderer, size, context->limits(), progress);
  const Model& model = *scene.model.data;
  std::vector<CountRow> rows = countRows(model, render::countTypes(model, counter.count(scene)));
  std::string title = fmt::format("{}, {} x {} pixels", model.name, size.x, size.y);
  replaceFile(path, extension == ".svg" ? countsSvg(rows, title) : countsCsv(rows));
}

Hiding findHiding(const scene::Scene& scene, std::string_view path, glm::ivec2 size, Progress& progress) {
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  PictureCounter counter(renderer, size, context->limits(), progress);
  return whatHides(scene, path, [&](const scene::Scene& of) { return counter.types(of); });
}

}  // namespace velum::session
