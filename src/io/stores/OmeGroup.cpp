#include "io/stores/OmeGroup.h"

#include <nlohmann/json.hpp>

namespace velum::io {

Json omeAttributes(const Store& store, const std::string& key) {
  std::string file = keyBelow(store, key, "zarr.json");
  if (std::string text = textOf(store, file); !text.empty()) {
    Json metadata = parseJson(text, store.pathOf(file));
    if (!metadata.is_object() || !metadata.contains("attributes")) return nullptr;
    Json& attributes = metadata["attributes"];
    if (!attributes.is_object() || !attributes.contains("ome")) return nullptr;
    return std::move(attributes["ome"]);
  }
  file = keyBelow(store, key, ".zattrs");
  std::string text = textOf(store, file);
  return text.empty() ? Json(nullptr) : parseJson(text, store.pathOf(file));
}

Path omePath(const Store& store, const std::string& key) {
  for (const char* name : {"zarr.json", ".zattrs"})
    if (store.open(keyBelow(store, key, name))) return store.pathOf(keyBelow(store, key, name));
  return store.pathOf(key);
}

}  // namespace velum::io
