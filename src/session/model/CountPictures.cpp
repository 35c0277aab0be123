#include "session/model/CountPictures.h"

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "gpu/Context.h"
#include "render/Renderer.h"
#include "session/model/CountFiles.h"
#include "session/model/PictureCounter.h"
#include "session/model/TypeDials.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

/// Counts in pictures, in a GL context of its own, and reports before each picture how many have been drawn of the most
/// that there may be.
class Counting {
 public:
  Counting(glm::ivec2 size, int most, Progress& progress)
      : mMost(most), mProgress(progress), mCounter(mRenderer, size, mContext->limits(), mInPicture) {}
  render::InstanceBits operator()(const scene::Scene& scene) {
    mProgress.report(double(mPictures++) / mMost, "Counting what is seen");
    return mCounter.count(scene);
  }
  double aspect() const { return mCounter.aspect(); }

 private:
  int mMost, mPictures = 0;
  Progress& mProgress;
  Progress mInPicture{[this](double, const std::string&) { mProgress.throwIfCancelled(); }};
  std::unique_ptr<gpu::Context> mContext = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer mRenderer{*mContext};
  PictureCounter mCounter;
};

}  // namespace

Solved findVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                   glm::ivec2 size, Progress& progress) {
  Counting counting(size, kMostPicturesOfOne, progress);
  return solveVisible(scene, cuts, path, wanted, std::ref(counting), {}, counting.aspect());
}

TargetsReport findTargets(const scene::Scene& scene, glm::ivec2 size, Progress& progress) {
  Counting counting(size, kMostPictures, progress);
  return solveTargets(scene, scene.model.targets, std::ref(counting), {}, counting.aspect());
}

SeenRange findSeenRange(scene::Scene scene, std::string_view path, glm::ivec2 size, Progress& progress) {
  if (!scene.model.data) throw InputError("there is no model to count in");
  TypeNumbers types = typesAt(*scene.model.data, path).types;
  Counting counting(size, 2, progress);
  auto seen = [&] {
    Counts sum;
    std::vector<Counts> counts = render::countTypes(*scene.model.data, counting(scene));
    for (std::uint32_t type : types) sum += counts[type];
    return sum;
  };
  Counts now = seen();
  std::vector<int> cuts = enabledCuts(scene);
  for (std::uint32_t type : types) {
    std::string of = pathOf(*scene.model.data, scene.model.data->types[type]);
    setDial(scene, cuts, of, DialField::Share, 1.0);
    setDial(scene, cuts, of, DialField::ViewShare, 1.0);
  }
  setTypesVisible(scene, types, true);
  return {now.visible(), seen().visible(), now.total()};
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
  std::vector<CountRow> rows = countRows(scene.model, render::countTypes(model, counter.count(scene)));
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
