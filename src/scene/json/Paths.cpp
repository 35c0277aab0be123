#include "scene/json/Paths.h"

#include <algorithm>
#include <optional>

#include "core/NearestName.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "scene/json/FieldPaths.h"

namespace velum::scene {

namespace {

/// "aorta,left kidney" as ids, where structures of those names are there; what else the value is stays as it is.
std::string withIdsOfStructures(const Scene& scene, std::string_view path, std::string_view value) {
  std::string_view field = path.substr(0, path.find_last_not_of("+.0123456789") + 1);
  bool isSpares = path.starts_with("cuts") &&
                  ((field.ends_with(".spares") && !field.ends_with(".model.spares")) || field.ends_with(".structure"));
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

namespace {

using detail::Json;

/// Where a sheet came to rest is no wish of anybody's: it follows from the others.
constexpr std::string_view kResult = "membrane.shape";

Json lookUp(const auto& target, std::string_view rest, const std::string& path);

template <detail::Fielded T>
Json lookUpMember(const T& target, std::string_view rest, const std::string& path) {
  detail::PathPart part = detail::takePart(rest);
  std::vector<std::string> known;
  std::optional<Json> found;
  auto visit = [&](std::string_view name, const auto& member, const FieldInfo&) {
    known.emplace_back(name);
    if (name == part.head)
      found = lookUp(member, part.tail, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name));
  };
  T::fields(target, visit);
  if (!found) detail::failNoField(part.head, path, known);
  return *found;
}

template <detail::List T>
Json lookUpItem(const T& target, std::string_view rest, const std::string& path) {
  if (rest.starts_with('[')) {
    detail::PathKey key = detail::takeKey(rest, path);
    return lookUp(target[detail::findInBrackets(target, key.name, path)], key.rest,
                  fmt::format("{}[{}]", path, key.name));
  }
  detail::PathPart part = detail::takePart(rest);
  if (part.head == "*") {
    Json all = Json::array();
    for (const auto& item : target) all.push_back(lookUp(item, part.tail, path));
    return all;
  }
  auto index = numberIn(part.head);
  if (!index || *index < 0 || *index >= double(target.size()) || *index != std::floor(*index))
    throw ArgumentError(
        fmt::format("{} has {} items; '{}' is none of them (use * for each)", path, target.size(), part.head));
  return lookUp(target[std::size_t(*index)], part.tail, fmt::format("{}.{}", path, part.head));
}

Json lookUp(const auto& target, std::string_view rest, const std::string& path) {
  using T = std::remove_cvref_t<decltype(target)>;
  if (rest.empty()) return detail::write(target);
  if constexpr (detail::Maybe<T>) {
    if (!target) throw ArgumentError(fmt::format("{} is not there: it is null", path));
    return lookUp(*target, rest, path);
  } else if constexpr (detail::List<T>) {
    return lookUpItem(target, rest, path);
  } else if constexpr (detail::Fielded<T>) {
    return lookUpMember(target, rest, path);
  } else {
    throw ArgumentError(fmt::format("{} has no part '{}'", path, rest));
  }
}

void addChanges(const auto& before, const auto& after, const std::string& path, std::vector<FieldValue>& out) {
  using T = std::remove_cvref_t<decltype(after)>;
  if (before == after || path.ends_with(kResult)) return;
  auto whole = [&] { out.push_back({path, detail::valueText(detail::write(after))}); };
  if constexpr (detail::Maybe<T>) {
    before&& after ? addChanges(*before, *after, path, out) : whole();
  } else if constexpr (detail::Fielded<T>) {
    std::vector<const void*> members;  // of the one before, in their order
    auto note = [&](std::string_view, const auto& member, const FieldInfo&) { members.push_back(&member); };
    T::fields(before, note);
    std::size_t place = 0;
    auto visit = [&](std::string_view name, const auto& member, const FieldInfo&) {
      const auto& was = *static_cast<decltype(&member)>(members[place++]);
      addChanges(was, member, path.empty() ? std::string(name) : fmt::format("{}.{}", path, name), out);
    };
    T::fields(after, visit);
  } else if constexpr (detail::List<T>) {
    if constexpr (detail::Fielded<typename detail::ListTraits<T>::Item>) {
      if (before.size() != after.size()) return whole();
      for (std::size_t i = 0; i < after.size(); ++i)
        addChanges(before[i], after[i], fmt::format("{}.{}", path, i), out);
    } else {
      whole();
    }
  } else {
    whole();
  }
}

}  // namespace

std::string valueOfText(const std::string& text) { return detail::valueText(Json(text)); }

std::string getField(const Scene& scene, std::string_view path) {
  return detail::valueText(path.empty() ? detail::write(scene) : lookUpMember(scene, path, ""));
}

std::vector<FieldValue> fieldChanges(const Scene& before, const Scene& after) {
  std::vector<FieldValue> changes;
  addChanges(before, after, "", changes);
  return changes;
}

void setField(Scene& scene, std::string_view path, std::string_view value) {
  Scene next = scene;
  detail::assignMember(next, path, withIdsOfStructures(scene, path, value), "");
  for (std::size_t i = 0; i < next.cuts.size(); ++i) {
    const Cut& cut = next.cuts[i];
    bool wasNone = i >= scene.cuts.size() || !scene.cuts[i].membrane;
    if (cut.membrane && wasNone && !isMembrane(cut))
      throw ArgumentError(fmt::format("cuts.{}.membrane: the cut is a {}; say cuts.{}.shape=membrane first", i,
                                      enumName(cut.shape), i));
  }
  completeItems(next);
  scene = std::move(next);
}

}  // namespace velum::scene
