#include "scene/Caption.h"

#include <fmt/format.h>

#include <utility>

#include "core/Error.h"

namespace velum::scene {

int addCaption(std::vector<Caption>& captions, Caption caption) {
  if (captions.size() >= kMostCaptions)
    throw ArgumentError(fmt::format("a scene holds {} captions at most; remove one first", kMostCaptions));
  caption.id = nextId(captions);
  captions.push_back(std::move(caption));
  return captions.back().id;
}

}  // namespace velum::scene
