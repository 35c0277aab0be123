#include "scene/Crowd.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "scene/Scene.h"

namespace velum::scene {

void refuseCrowd(const ModelLayer& layer, std::string_view what) {
  if (!layer.data || !isCrowd(layer)) return;
  throw InputError(fmt::format(
      "{} copies of {} instances are drawn as a crowd, in which instances have no numbers: {} can be had of up to {} "
      "copies",
      copyCount(layer), layer.data->instances.size(), what, numberedCopies(layer)));
}

}  // namespace velum::scene
