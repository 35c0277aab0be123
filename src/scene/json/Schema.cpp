#include "scene/json/Schema.h"

#include "scene/Scene.h"
#include "scene/json/FieldTable.h"
#include "scene/json/Json.h"

namespace velum::scene {

namespace detail {

namespace {

template <class T>
Json schemaOf(const T& defaults, const FieldInfo& info) {
  Json out = Json::object();
  if (!info.doc.empty())
    out["description"] = info.unit.empty() ? std::string(info.doc) : fmt::format("{} Unit: {}.", info.doc, info.unit);
  auto addRange = [&](Json& node) {
    Range range = rangeOf<T>(info);
    if (!std::isinf(range.min)) node["minimum"] = range.min;
    if (!std::isinf(range.max)) node["maximum"] = range.max;
  };
  // The type, with its limits; what is made of others by itself.
  if constexpr (std::is_same_v<T, bool>) {
    out["type"] = "boolean";
  } else if constexpr (Number<T>) {
    out["type"] = std::is_integral_v<T> ? "integer" : "number";
    if (info.nullIsEndless) out["type"] = {"number", "null"};
    addRange(out);
  } else if constexpr (std::is_same_v<T, std::string>) {
    out["type"] = "string";
  } else if constexpr (Anything<T>) {
    // of whatever type the field has
  } else if constexpr (Enumeration<T>) {
    out["enum"] = Json::array();
    for (auto name : EnumNames<T>::kNames) out["enum"].push_back(std::string(name));
  } else if constexpr (GlmVector<T>) {
    Json item = {{"type", std::is_integral_v<typename GlmTraits<T>::Value> ? "integer" : "number"}};
    addRange(item);
    out["type"] = "array";
    out["items"] = item;
    out["minItems"] = out["maxItems"] = GlmTraits<T>::kSize;
  } else if constexpr (List<T>) {
    out["type"] = "array";
    FieldInfo itemInfo = info;
    itemInfo.doc = "";
    out["items"] = schemaOf(typename ListTraits<T>::Item{}, itemInfo);
    out["maxItems"] = info.most;
  } else {
    out["type"] = "object";
    Json properties = Json::object();
    auto visit = [&](std::string_view name, const auto& member, const FieldInfo& memberInfo) {
      using M = std::remove_cvref_t<decltype(member)>;
      Json& property = properties[std::string(name)];
      if constexpr (Maybe<M>) {
        using Value = typename MaybeTraits<M>::Value;
        property = schemaOf(Value{}, memberInfo);
        if constexpr (!Fielded<Value>) {
          property["type"] = {property["type"], "null"};
          property["default"] = nullptr;
        }
      } else {
        property = schemaOf(member, memberInfo);
      }
    };
    T::fields(defaults, visit);
    out["properties"] = std::move(properties);
  }
  if constexpr (!Fielded<T> && !List<T>) out["default"] = write(defaults);
  return out;
}

}  // namespace

}  // namespace detail

std::vector<FieldRow> fieldTable() {
  std::vector<FieldRow> rows;
  detail::addRows(Scene{}, "", rows);
  return rows;
}

std::string jsonSchema() {
  detail::Json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Velum scene"}};
  out.update(detail::schemaOf(Scene{}, {}));
  out["properties"]["velum"] = {
      {"type", "integer"}, {"minimum", 1}, {"maximum", kSceneVersion}, {"description", "Version of the scene format."}};
  out["required"] = {"velum"};
  return out.dump(2) + "\n";
}

}  // namespace velum::scene
