#include "app/MarkText.h"

#include <fmt/format.h>

#include <sstream>

#include "app/Common.h"
#include "core/Error.h"
#include "core/NearestName.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "session/structure/StructureExport.h"

namespace velum::app {

namespace {

constexpr const char* kOption = "--mark";

scene::MarkKind kindOf(const std::string& word) {
  if (auto kind = enumValue<scene::MarkKind>(word)) return *kind;
  std::vector<std::string> names(std::begin(EnumNames<scene::MarkKind>::kNames),
                                 std::end(EnumNames<scene::MarkKind>::kNames));
  std::string meant = nearestName(word, names);
  throw ArgumentError(fmt::format("{}: there is no kind '{}'{}; kinds are {}", kOption, printable(word),
                                  meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant),
                                  fmt::join(names, ", ")));
}

std::vector<glm::dvec3> pointsOf(const std::string& text) {
  std::vector<glm::dvec3> points;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ';');) {
    auto n = numbersOf("--mark: points", part, 3, "x,y,z;x,y,z;...");
    points.emplace_back(n[0], n[1], n[2]);
  }
  return points;
}

bool flagOf(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  throw ArgumentError(fmt::format("{}: alongSurface={}: it is true or false", kOption, printable(text)));
}

}  // namespace

scene::Mark parseMark(const scene::Scene& scene, const std::string& text) {
  scene::Mark mark;
  std::string rest = text, label = " text=";
  if (std::size_t at = rest.find(label); at != std::string::npos) {
    mark.text = rest.substr(at + label.size());
    rest.resize(at);
  }
  std::vector<std::string> words = velum::wordsOf(rest);
  if (words.empty())
    throw ArgumentError(fmt::format("{}: give a kind, as in \"distance points=0,0,0;10,0,0\"", kOption));
  mark.kind = kindOf(words.front());
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::size_t equals = std::min(words[i].find('='), words[i].size());
    std::string name = words[i].substr(0, equals), value = words[i].substr(std::min(equals + 1, words[i].size()));
    if (name == "points")
      mark.points = pointsOf(value);
    else if (name == "alongSurface")
      mark.alongSurface = flagOf(value);
    else if (name == "structure")
      mark.structure = session::findStructures(session::labelsOf(scene).table, {value}).front();
    else
      throw ArgumentError(
          fmt::format("{}: '{}' is none of points=, alongSurface=, structure=, text=", kOption, printable(words[i])));
  }
  if (mark.kind == scene::MarkKind::Region && mark.structure == 0)
    throw ArgumentError(fmt::format("{}: say which structure a region is: structure=NAME", kOption));
  return mark;
}

}  // namespace velum::app
