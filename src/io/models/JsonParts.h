#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "io/models/ModelParts.h"

/// Values out of JSON by strangers.
namespace velum::io {

using Json = nlohmann::json;

/// @throw InputError with where the text is no JSON
Json parseJson(const std::string& text, const Path& path);
/// The member, or null where there is none or where it is of no object.
const Json& memberOf(const Json& object, std::string_view name);
/// Empty where it is no text.
std::string wordOf(const Json& value);
bool isTrue(const Json& value);
/// A number, also one that stands as text. @throw InputError @param what  for the message
double numberOf(const Json& value, const Path& path, std::string_view what);
/// Three numbers. @throw InputError
glm::dvec3 vectorOf(const Json& value, const Path& path, std::string_view what);
/// Three numbers each: [[x, y, z], ...], or all in a row. @throw InputError
std::vector<glm::vec3> pointsOf(const Json& value, const Path& path, std::string_view what);
/// @throw InputError
std::vector<double> numbersOf(const Json& value, const Path& path, std::string_view what);

}  // namespace velum::io
