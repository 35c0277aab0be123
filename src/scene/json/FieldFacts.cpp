#include "scene/json/FieldFacts.h"

#include "scene/Scene.h"
#include "scene/json/FieldPaths.h"

namespace velum::scene {

namespace {

template <class T>
FieldKind kindOf(const FieldInfo& info) {
  if constexpr (std::is_same_v<T, bool>)
    return FieldKind::Truth;
  else if constexpr (detail::Enumeration<T>)
    return FieldKind::Choice;
  else if constexpr (std::is_same_v<T, std::string>)
    return FieldKind::Text;
  else if constexpr (std::is_same_v<T, glm::vec3>)
    return info.range.min == 0.0 && info.range.max == 1.0 ? FieldKind::Color : FieldKind::Number;
  else if constexpr (detail::GlmVector<T>)
    return kindOf<typename detail::GlmTraits<T>::Value>(info);
  else if constexpr (detail::Number<T>)
    return std::is_integral_v<T> ? FieldKind::Whole : FieldKind::Number;
  else
    return FieldKind::Other;
}

/// @param path  of the field, for errors  @param rest  of it, behind the field
template <class T>
FieldFacts factsOf(const FieldInfo& info, std::string_view rest, std::string_view path) {
  if constexpr (detail::Maybe<T>) {
    return factsOf<typename detail::MaybeTraits<T>::Value>(info, rest, path);
  } else if constexpr (detail::List<T> && !std::is_same_v<T, std::string>) {
    if (rest.empty()) return {FieldKind::Other, 1, std::string(info.unit), info.range, std::string(info.doc), {}};
    bool isNamed = rest.starts_with('[');
    rest = isNamed ? detail::takeKey(rest, std::string(path.substr(0, path.size() - rest.size()))).rest
                   : detail::takePart(rest).tail;
    return factsOf<typename detail::ListTraits<T>::Item>(info, rest, path);
  } else if constexpr (detail::Fielded<T>) {
    static const T kFresh{};
    detail::PathPart part = detail::takePart(rest);
    if (part.head.empty()) return {FieldKind::Other, 1, "", {}, std::string(info.doc), {}};
    std::vector<std::string> known;
    std::optional<FieldFacts> found;
    auto visit = [&](std::string_view name, const auto& member, const FieldInfo& facts) {
      known.emplace_back(name);
      if (name == part.head) found = factsOf<std::remove_cvref_t<decltype(member)>>(facts, part.tail, path);
    };
    T::fields(kFresh, visit);
    if (!found) detail::failNoField(part.head, std::string(path), known);
    return *found;
  } else {
    if (!rest.empty()) throw ArgumentError(fmt::format("{}: there is no part '{}'", path, rest));
    FieldFacts facts{kindOf<T>(info), 1, std::string(info.unit), info.range, std::string(info.doc), {}};
    if constexpr (detail::GlmVector<T>) facts.count = detail::GlmTraits<T>::kSize;
    if constexpr (detail::Enumeration<T>)
      facts.names.assign(std::begin(EnumNames<T>::kNames), std::end(EnumNames<T>::kNames));
    return facts;
  }
}

}  // namespace

FieldFacts fieldFacts(std::string_view path) { return factsOf<Scene>({}, path, path); }

}  // namespace velum::scene
