#include "io/stores/OmeGroup.h"

#include <nlohmann/json.hpp>

namespace velum::io {

namespace {

bool isVersion3(const Store& store, const std::string& key) {
  return store.open(keyBelow(store, key, "zarr.json")) != nullptr;
}

}  // namespace

Json attributesOf(const Store& store, const std::string& key) {
  bool isNew = isVersion3(store, key);
  std::string file = keyBelow(store, key, isNew ? "zarr.json" : ".zattrs"), text = textOf(store, file);
  if (text.empty() && !isNew) return nullptr;
  Json json = parseJson(text, store.pathOf(file));
  if (!isNew) return json;
  return json.is_object() && json.contains("attributes") ? std::move(json["attributes"]) : Json(nullptr);
}

Json omeAttributes(const Store& store, const std::string& key) {
  Json attributes = attributesOf(store, key);
  if (!isVersion3(store, key)) return attributes;
  return attributes.is_object() && attributes.contains("ome") ? std::move(attributes["ome"]) : Json(nullptr);
}

Path omePath(const Store& store, const std::string& key) {
  for (const char* name : {"zarr.json", ".zattrs"})
    if (store.open(keyBelow(store, key, name))) return store.pathOf(keyBelow(store, key, name));
  return store.pathOf(key);
}

}  // namespace velum::io
