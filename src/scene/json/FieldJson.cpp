#include "scene/json/FieldJson.h"

#include "core/Error.h"
#include "core/Log.h"
#include "core/NearestName.h"

namespace velum::scene::detail {

void fail(const std::string& path, const std::string& what) {
  throw InputError(fmt::format("scene: {}: {}", path, what));
}

void warnOfUnknown(const Json& json, const std::string& path, const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 5;
  std::string text;
  std::size_t unknown = 0;
  for (const auto& [key, value] : json.items()) {
    bool isVersion = path.empty() && key == "velum";
    if (isVersion || std::find(names.begin(), names.end(), key) != names.end() || ++unknown > kMostNamed) continue;
    text += fmt::format("{}'{}'{}", text.empty() ? "" : ", ", printable(key), meantText(key, names));
  }
  if (unknown > kMostNamed) text += fmt::format(" and {} more", unknown - kMostNamed);
  if (unknown > 0)
    log::warning(fmt::format("scene: {} has fields that this version does not know; they are left out: {}",
                             path.empty() ? "the file" : path, text));
}

}  // namespace velum::scene::detail
