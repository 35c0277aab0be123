#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/Error.h"
#include "growth/GrowOverTime.h"
#include "makeVolume.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"

namespace {

using namespace velum;

/// Two materials, checkered by twos.
const Shared<Volume>& smallVolume() {
  static const Shared<Volume> volume(makeVolume(
      {7, 6, 5}, SampleType::UInt8, [](glm::ivec3 p) { return (p.x / 2 + p.y / 2 + p.z / 2) % 2 ? 200 : 50; },
      glm::dmat4(1.0)));
  return volume;
}

}  // namespace

/// What a scene says of growing is refused with an Error or grows, and only structures that it names.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    scene::Scene scene = scene::fromJson(text);
    const auto& steps = scene.labels.growths;
    Progress progress;
    auto labels = growth::growLabels(smallVolume(), {}, steps, 0, progress);
    for (int id : labels->idsInUse())
      if (std::none_of(steps.begin(), steps.end(), [id](const auto& step) { return step.structure == id; }))
        std::abort();
  } catch (const Error&) {
  }
  return 0;
}
