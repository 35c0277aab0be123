#pragma once
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/read/Refuse.h"

/// Reads values from JSON that strangers wrote, in which anything may be of the wrong type.
namespace velum::io {

using Json = nlohmann::json;

/// @throw InputError that says where the text is not JSON
Json parseJson(const std::string& text, const Path& path);
/// The member of that name; a JSON null where there is none or where @p object is not an object.
const Json& memberOf(const Json& object, std::string_view name);
/// The value as text; empty where it is not a text.
std::string wordOf(const Json& value);
bool isTrue(const Json& value);
/// The value as a number, also where the number is written as text. @throw InputError @param what  for the message
double numberOf(const Json& value, const Path& path, std::string_view what);
/// The value as three numbers. @throw InputError
glm::dvec3 vectorOf(const Json& value, const Path& path, std::string_view what);
/// The value as points of three numbers each: [[x, y, z], ...], or all numbers in one list. @throw InputError
std::vector<glm::vec3> pointsOf(const Json& value, const Path& path, std::string_view what);
/// @throw InputError
std::vector<double> numbersOf(const Json& value, const Path& path, std::string_view what);

}  // namespace velum::io
