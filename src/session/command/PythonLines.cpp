#include "session/command/PythonLines.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Text.h"
#include "scene/json/FieldPaths.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"

namespace velum::session {

namespace {

using scene::detail::Json;

/// The words of Python that are no names.
constexpr std::string_view kPythonWords[] = {"False", "None",   "True",   "and",      "as",       "assert", "async",
                                             "await", "break",  "class",  "continue", "def",      "del",    "elif",
                                             "else",  "except", "for",    "from",     "global",   "if",     "import",
                                             "in",    "is",     "lambda", "not",      "nonlocal", "or",     "pass",
                                             "raise", "return", "try",    "while",    "with",     "yield"};

std::string textOf(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string literal(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "True" : "False";
  if (value.is_null()) return "None";
  if (!value.is_structured()) return textOf(value);  // numbers and texts are written alike
  auto isNumber = [](const Json& item) { return item.is_number(); };
  bool isPlace = value.is_array() && value.size() > 1 && std::all_of(value.begin(), value.end(), isNumber);
  std::string inside;
  for (const auto& [key, item] : value.items()) {
    if (!inside.empty()) inside += ", ";
    if (value.is_object()) inside += textOf(Json(key)) + ": ";
    inside += literal(item);
  }
  return value.is_object() ? "{" + inside + "}" : isPlace ? "(" + inside + ")" : "[" + inside + "]";
}

/// What `s[FIELD] = text` gives to the command set: a text that is no JSON goes as it is, as in scripts.
std::string sentByPython(const Json& value) {
  std::string word = value.get<std::string>();
  bool isWord = !word.empty() && trimmed(word) == word && word.find_first_of("\r\n") == std::string::npos;
  return isWord && !Json::accept(word) ? word : textOf(value);
}

/// A text field may hold what looks like numbers: the text that arrives is the one of the line.
std::string setLine(const SetField& set) {
  Json value = scene::detail::parseValue(set.value);
  std::string path = literal(Json(set.path));
  bool isSame = value.is_string() ? scene::detail::parseValue(sentByPython(value)) == value
                                  : scene::detail::valueText(value) == set.value;
  return isSame ? fmt::format("s[{}] = {}", path, literal(value))
                : fmt::format("s.set({}, {})", path, literal(Json(set.value)));
}

std::string callLine(const Call& call) {
  if (call.command().name == SetField::kName) return setLine(std::any_cast<const SetField&>(call.arguments()));
  std::string words;
  auto rows = call.command().arguments();
  for (const auto& [name, json] : call.command().values(call.arguments())) {
    std::string first = rows.front().path.substr(0, rows.front().path.find('.'));
    bool isFirst = words.empty() && name == first;
    words += (words.empty() ? "" : ", ") + (isFirst ? "" : pythonName(name) + "=") + pythonValue(json);
  }
  return fmt::format("s.{}({})", pythonName(call.command().name), words);
}

}  // namespace

std::string pythonName(std::string_view name) {
  std::string out;
  while (!name.empty()) {
    std::string_view part = name.substr(0, name.find('.'));
    name.remove_prefix(std::min(part.size() + 1, name.size()));
    bool isWord = std::find(std::begin(kPythonWords), std::end(kPythonWords), part) != std::end(kPythonWords);
    out += (out.empty() ? "" : ".") + std::string(part) + (isWord ? "_" : "");
  }
  return out;
}

std::string pythonValue(std::string_view json) { return literal(Json::parse(json)); }

std::string pythonProgram(const std::vector<std::string>& lines) {
  std::string program = "import velum\n\ns = velum.Session()\n";
  for (const std::string& line : lines) {
    bool isCall = !line.empty() && !line.starts_with('#');
    program += (isCall ? callLine(parseCall(line)) : line) + "\n";
  }
  return program;
}

}  // namespace velum::session
