#include "velum/scene/json/Json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <vector>

#include "JsonText.h"
#include "OlderVersions.h"
#include "PathKey.h"
#include "velum/core/Error.h"
#include "velum/core/Log.h"
#include "velum/core/NearestName.h"
#include "velum/core/Text.h"

namespace velum::scene {

namespace {

using Json = nlohmann::ordered_json;

// What a field can be: a leaf (bool, number, string, enumeration, vector of numbers), a list, or a struct with
// fields().
template <class T>
concept Enumeration = std::is_enum_v<T>;
template <class T>
concept Number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <class T>
struct GlmTraits : std::false_type {};
template <int N, class T, glm::qualifier Q>
struct GlmTraits<glm::vec<N, T, Q>> : std::true_type {
  static constexpr int kSize = N;
  using Value = T;
};
template <class T>
concept GlmVector = GlmTraits<T>::value;
template <class T>
struct ListTraits : std::false_type {};
template <class T>
struct ListTraits<std::vector<T>> : std::true_type {
  using Item = T;
};
template <class T>
concept List = ListTraits<T>::value;
template <class T>
struct MaybeTraits : std::false_type {
  using Value = T;
};
template <class T>
struct MaybeTraits<std::optional<T>> : std::true_type {
  using Value = T;
};
template <class T>
concept Maybe = MaybeTraits<T>::value;
struct AnyVisitor {
  void operator()(auto&&...) const {}
};
template <class T>
concept Fielded = requires(T& t, AnyVisitor& v) {
  T::fields(t, v);
};

// ---- writing

Json write(const auto& value);

template <Fielded T>
Json writeStruct(const T& value) {
  static const T fresh{};
  std::vector<const void*> members;  // of a new object, in their order
  auto note = [&](std::string_view, const auto& member, const FieldInfo&) { members.push_back(&member); };
  T::fields(fresh, note);
  Json out = Json::object();
  std::size_t place = 0;
  auto visit = [&](std::string_view name, const auto& member, const FieldInfo& info) {
    const auto& unchanged = *static_cast<decltype(&member)>(members[place++]);
    if (info.leftOutByDefault && member == unchanged) return;
    out[std::string(name)] = write(member);
  };
  T::fields(value, visit);
  return out;
}

/// The shortest decimal that reads back as the same float, rather than its long double form.
Json writeNumber(float value) { return Json(numberIn(fmt::format("{}", value)).value()); }
/// Infinity, where a field may have it, is null.
Json writeNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json writeNumber(Number auto value) { return Json(value); }

Json write(const auto& value) {
  using T = std::remove_cvref_t<decltype(value)>;
  if constexpr (Enumeration<T>) {
    return Json(std::string(enumName(value)));
  } else if constexpr (GlmVector<T>) {
    Json out = Json::array();
    for (int i = 0; i < GlmTraits<T>::kSize; ++i) out.push_back(writeNumber(value[i]));
    return out;
  } else if constexpr (List<T>) {
    Json out = Json::array();
    for (const auto& item : value) out.push_back(write(item));
    return out;
  } else if constexpr (Maybe<T>) {
    return value ? write(*value) : Json(nullptr);
  } else if constexpr (Fielded<T>) {
    return writeStruct(value);
  } else if constexpr (Number<T>) {
    return writeNumber(value);
  } else {
    return Json(value);
  }
}

// ---- reading

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError(fmt::format("scene: {}: {}", path, what));
}

constexpr double kFarthestPlace = 1e15;  ///< In any unit of length; and the longest vector that is a direction.
constexpr double kLargestValue = 1e300;  ///< Of data: what is made of it stays a number.

/// The range of a field that states none: numbers so large only come of damage, and nothing can be drawn with them.
template <class T>
Range rangeOf(const FieldInfo& info) {
  if (!std::isinf(info.range.min) || !std::isinf(info.range.max)) return info.range;
  double most = info.unit == kLength || GlmVector<T> ? kFarthestPlace : kLargestValue;
  return {-most, most};
}

void read(auto& target, const Json& json, const std::string& path, const FieldInfo& info);

/// @param range  rangeOf() the field
template <Number T>
void readNumber(T& target, const Json& json, const std::string& path, const FieldInfo& info, const Range& range) {
  if constexpr (std::is_floating_point_v<T>) {
    if (info.nullIsEndless && json.is_null()) return void(target = std::numeric_limits<T>::infinity());
  }
  if (!json.is_number()) fail(path, "expected a number");
  double value = json.get<double>();
  if (!std::isfinite(value)) fail(path, "the number is not finite");
  if (value < range.min || value > range.max)
    fail(path, fmt::format("{:.6g} is outside {:.6g} .. {:.6g}{}{}", value, range.min, range.max,
                           info.unit.empty() ? "" : " ", info.unit));
  if constexpr (std::is_integral_v<T>) {
    if (value != std::floor(value) || std::abs(value) > 2147483647.0)
      fail(path, fmt::format("{} is not a whole number", value));
  }
  target = T(value);
}

/// Each by its name, with the one that was most likely meant.
void warnOfUnknown(const Json& json, const std::string& path, const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 5;
  std::string text;
  std::size_t unknown = 0;
  for (const auto& [key, value] : json.items()) {
    bool isVersion = path.empty() && key == "velum";
    if (isVersion || std::find(names.begin(), names.end(), key) != names.end() || ++unknown > kMostNamed) continue;
    std::string meant = nearestName(key, names);
    text += fmt::format("{}'{}'{}", text.empty() ? "" : ", ", printable(key),
                        meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant));
  }
  if (unknown > kMostNamed) text += fmt::format(" and {} more", unknown - kMostNamed);
  if (unknown > 0)
    log::warning(fmt::format("scene: {} has fields that this version does not know; they are left out: {}",
                             path.empty() ? "the file" : path, text));
}

template <Fielded T>
void readStruct(T& target, const Json& json, const std::string& path) {
  if (!json.is_object()) fail(path.empty() ? "top" : path, "expected an object");
  std::size_t known = 0;
  std::vector<std::string> names;
  auto visit = [&](std::string_view name, auto& member, const FieldInfo& info) {
    names.emplace_back(name);
    auto it = json.find(std::string(name));
    if (it == json.end()) return;
    ++known;
    read(member, *it, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name), info);
  };
  T::fields(target, visit);
  if (known < json.size()) warnOfUnknown(json, path, names);
}

void read(auto& target, const Json& json, const std::string& path, const FieldInfo& info) {
  using T = std::remove_cvref_t<decltype(target)>;
  if constexpr (std::is_same_v<T, bool>) {
    if (!json.is_boolean()) fail(path, "expected true or false");
    target = json.get<bool>();
  } else if constexpr (Number<T>) {
    readNumber(target, json, path, info, rangeOf<T>(info));
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!json.is_string()) fail(path, "expected a text");
    target = json.get<std::string>();
  } else if constexpr (Enumeration<T>) {
    if (!json.is_string()) fail(path, "expected a word");
    auto value = enumValue<T>(json.get<std::string>());
    if (!value)
      fail(path, fmt::format("'{}' is not one of {}", json.get<std::string>(), fmt::join(EnumNames<T>::kNames, ", ")));
    target = *value;
  } else if constexpr (GlmVector<T>) {
    constexpr int kSize = GlmTraits<T>::kSize;
    if (!json.is_array() || json.size() != kSize) fail(path, fmt::format("expected {} numbers", kSize));
    for (int i = 0; i < kSize; ++i)
      readNumber(target[i], json[std::size_t(i)], fmt::format("{}.{}", path, i), info, rangeOf<T>(info));
  } else if constexpr (List<T>) {
    if (!json.is_array()) fail(path, "expected a list");
    if (json.size() > info.most)
      fail(path, fmt::format("the list has {} items; {} is the most", json.size(), info.most));
    T items;
    for (std::size_t i = 0; i < json.size(); ++i) {
      items.emplace_back();
      read(items.back(), json[i], fmt::format("{}.{}", path, i), info);
    }
    target = std::move(items);
  } else if constexpr (Maybe<T>) {
    if (json.is_null()) return target.reset();
    read(target.emplace(), json, path, info);
  } else {
    readStruct(target, json, path);
  }
}

/// An object. @param what  "scene: "; begins the message  @throw InputError with the line where it is none
Json parseObject(std::string_view text, const std::string& what) {
  if (nestsTooDeep(text)) throw InputError(what + "brackets are nested deeper than in any scene");
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& error) {
    // "[json.exception...] parse error at line 3, column 5: syntax error ...; last read: ..."
    constexpr std::size_t kLongest = 160;  // of what was read last; a file can be all one string
    std::string_view said = error.what();
    said.remove_prefix(
        std::min(said.size(), said.find("line ") != said.npos ? said.find("line ") : said.find("] ") + 2));
    throw InputError(fmt::format("{}the text is no JSON; {}", what, printable(said.substr(0, kLongest))));
  }
  if (!json.is_object())
    throw InputError(what + "the text is not a JSON object; the file is damaged or of another kind");
  return json;
}

// ---- paths

/// JSON as it stands; else a comma list of numbers; else a bare word.
Json parseValue(std::string_view text) {
  Json value = Json::parse(text, nullptr, false);
  if (!value.is_discarded()) return value;
  if (text.find(',') != std::string_view::npos) {
    value = Json::parse(fmt::format("[{}]", text), nullptr, false);
    if (!value.is_discarded()) return value;
  }
  return Json(std::string(text));
}

/// On the command line a bare value stands for an object with its key field alone: spares=3,4.
template <class T>
Json expanded(Json value) {
  if constexpr (List<T>) {
    if (!value.is_array()) value = Json::array({value});
    for (auto& item : value) item = expanded<typename ListTraits<T>::Item>(std::move(item));
  } else if constexpr (requires { T::kKey; }) {
    if (!value.is_object()) return {{std::string(T::kKey), std::move(value)}};
  }
  return value;
}

void assign(auto& target, std::string_view rest, std::string_view text, const std::string& path, const FieldInfo& info);

template <Fielded T>
void assignMember(T& target, std::string_view rest, std::string_view text, const std::string& path) {
  std::string_view head = rest.substr(0, rest.find_first_of(".["));
  std::string_view tail = rest.substr(head.size());
  if (tail.starts_with('.')) tail.remove_prefix(1);
  bool found = false;
  std::vector<std::string> known;
  auto visit = [&](std::string_view name, auto& member, const FieldInfo& info) {
    known.emplace_back(name);
    if (name != head) return;
    found = true;
    assign(member, tail, text, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name), info);
  };
  T::fields(target, visit);
  if (found) return;
  std::string meant = nearestName(head, known);
  throw ArgumentError(fmt::format("no field '{}' in {}{}; there are {}", head, path.empty() ? "a scene" : path,
                                  meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant),
                                  fmt::join(known, ", ")));
}

void assign(auto& target, std::string_view rest, std::string_view text, const std::string& path,
            const FieldInfo& info) {
  using T = std::remove_cvref_t<decltype(target)>;
  if (rest.empty()) {
    try {
      Json value = parseValue(text);
      if constexpr (std::is_same_v<T, std::string>) {
        if (!value.is_string()) value = std::string(text);
      }
      read(target, expanded<T>(std::move(value)), path, info);
    } catch (const InputError& error) {
      throw ArgumentError(error.what());
    }
    return;
  }
  if constexpr (Maybe<T>) {
    if (!target) target.emplace();
    assign(*target, rest, text, path, info);
  } else if constexpr (List<T>) {
    if (rest.starts_with('[')) {
      detail::PathKey key = detail::takeKey(rest, path);
      std::size_t found = detail::findByKey(target, key.name, path);
      return assign(target[found], key.rest, text, fmt::format("{}[{}]", path, key.name), info);
    }
    std::string_view head = rest.substr(0, rest.find('.'));
    std::string_view tail = head.size() == rest.size() ? "" : rest.substr(head.size() + 1);
    if (head == "*") {
      for (std::size_t i = 0; i < target.size(); ++i)
        assign(target[i], tail, text, fmt::format("{}.{}", path, i), info);
      return;
    }
    std::size_t index = target.size();
    if (head != "+") {
      index = 0;
      for (char c : head)
        index = c >= '0' && c <= '9' ? std::min(info.most, index * 10 + std::size_t(c - '0')) : info.most;
      if (head.empty() || index > target.size())
        throw ArgumentError(fmt::format("{} has {} items; '{}' is none of them (use + to append, * for each)", path,
                                        target.size(), head));
    }
    if (index >= info.most)
      throw ArgumentError(fmt::format("{} has {} items, and more it cannot have", path, info.most));
    if (index == target.size()) target.emplace_back();
    assign(target[index], tail, text, fmt::format("{}.{}", path, index), info);
  } else if constexpr (Fielded<T>) {
    assignMember(target, rest, text, path);
  } else {
    throw ArgumentError(fmt::format("{} has no part '{}'", path, rest));
  }
}

// ---- documentation

template <class T>
std::string typeName() {
  if constexpr (std::is_same_v<T, bool>)
    return "true or false";
  else if constexpr (std::is_integral_v<T>)
    return "whole number";
  else if constexpr (Number<T>)
    return "number";
  else if constexpr (std::is_same_v<T, std::string>)
    return "text";
  else if constexpr (GlmVector<T>)
    return fmt::format("{} numbers", GlmTraits<T>::kSize);
  else if constexpr (List<T>)
    return fmt::format("list of {}", typeName<typename ListTraits<T>::Item>());
  else if constexpr (Enumeration<T>) {
    std::string names;
    for (auto name : EnumNames<T>::kNames) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
    return names;
  } else
    return "object";
}

std::string rangeText(const Range& range) {
  if (std::isinf(range.min) && std::isinf(range.max)) return "";
  return fmt::format("{} .. {}", range.min, range.max);
}

template <Fielded T>
void addRows(const T& defaults, const std::string& path, std::vector<FieldRow>& rows) {
  auto visit = [&](std::string_view name, const auto& member, const FieldInfo& info) {
    using M = typename MaybeTraits<std::remove_cvref_t<decltype(member)>>::Value;
    std::string here = path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
    if constexpr (Maybe<std::remove_cvref_t<decltype(member)>> && Fielded<M>) {
      addRows(M{}, here, rows);
    } else if constexpr (Fielded<M>) {
      addRows(member, here, rows);
    } else {
      std::string range = List<M> ? fmt::format("at most {}", info.most) : rangeText(info.range);
      rows.push_back(
          {here, typeName<M>(), std::string(info.unit), std::move(range), std::string(info.doc), write(member).dump()});
      if constexpr (List<M>) {
        if constexpr (Fielded<typename ListTraits<M>::Item>) addRows(typename ListTraits<M>::Item{}, here + ".N", rows);
      }
    }
  };
  T::fields(defaults, visit);
}

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

std::string toJson(const Scene& scene) {
  Json out = Json::object();
  out["velum"] = kSceneVersion;
  out.update(writeStruct(scene));
  // A path may hold bytes that are no UTF-8; JSON cannot.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Scene fromJson(std::string_view text) {
  Json json = parseObject(text, "scene: ");
  auto version = json.find("velum");
  if (version == json.end() || !version->is_number_integer())
    throw InputError("scene: no \"velum\" version number; this is not a scene of ours");
  if (version->get<double>() > kSceneVersion || version->get<double>() < 1)
    throw InputError(
        fmt::format("scene: written by a newer Velum (scene version {}, this one reads up to {}); update Velum",
                    version->get<double>(), kSceneVersion));
  detail::bringUpToDate(json, version->get<int>());
  Scene scene;
  readStruct(scene, json, "");
  completeCuts(scene);
  return scene;
}

std::string transferToJson(const TransferFunction& transfer) {
  Json out = Json::object();
  out["velumTransfer"] = kTransferVersion;
  out.update(writeStruct(transfer));
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

TransferFunction transferFromJson(std::string_view text) {
  Json json = parseObject(text, "transfer function: ");
  auto version = json.find("velumTransfer");
  if (version == json.end() || !version->is_number_integer())
    throw InputError("no \"velumTransfer\" version number; this is not a transfer function of ours, or it is damaged");
  if (version->get<double>() > kTransferVersion || version->get<double>() < 1)
    throw InputError(
        fmt::format("written by a newer Velum (transfer version {}, this one reads up to {}); update Velum",
                    version->get<double>(), kTransferVersion));
  json.erase("velumTransfer");
  TransferFunction transfer;
  readStruct(transfer, json, "transfer");
  return transfer;
}

namespace {

/// "aorta,left kidney" as ids, where structures of those names are there; what else the value is stays as it is.
std::string withIdsOfStructures(const Scene& scene, std::string_view path, std::string_view value) {
  std::string_view field = path.substr(0, path.find_last_not_of("+.0123456789") + 1);
  bool isSpares = path.starts_with("cuts") && (field.ends_with(".spares") || field.ends_with(".structure"));
  if (!isSpares || value.empty() || value.front() == '[' || value.front() == '{') return std::string(value);
  std::string ids;
  for (std::size_t begin = 0; begin <= value.size();) {
    std::size_t end = std::min(value.find(',', begin), value.size());
    std::string name(trimmed(value.substr(begin, end - begin)));
    if (!numberIn(name))
      name = fmt::format(
          "{}", scene.labels.structures[detail::findByKey(scene.labels.structures, name, "labels.structures")].id);
    ids += (ids.empty() ? "" : ",") + name;
    begin = end + 1;
  }
  return ids;
}

}  // namespace

void setField(Scene& scene, std::string_view path, std::string_view value) {
  Scene next = scene;
  assignMember(next, path, withIdsOfStructures(scene, path, value), "");
  for (std::size_t i = 0; i < next.cuts.size(); ++i) {
    const Cut& cut = next.cuts[i];
    bool wasNone = i >= scene.cuts.size() || !scene.cuts[i].membrane;
    if (cut.membrane && wasNone && !isMembrane(cut))
      throw ArgumentError(fmt::format("cuts.{}.membrane: the cut is a {}; say cuts.{}.shape=membrane first", i,
                                      enumName(cut.shape), i));
  }
  completeCuts(next);
  scene = std::move(next);
}

std::vector<FieldRow> fieldTable() {
  std::vector<FieldRow> rows;
  addRows(Scene{}, "", rows);
  return rows;
}

std::string jsonSchema() {
  Json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Velum scene"}};
  out.update(schemaOf(Scene{}, {}));
  out["properties"]["velum"] = {
      {"type", "integer"}, {"minimum", 1}, {"maximum", kSceneVersion}, {"description", "Version of the scene format."}};
  out["required"] = {"velum"};
  return out.dump(2) + "\n";
}

}  // namespace velum::scene
