#include "scene/json/ChangeLog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/Error.h"
#include "scene/json/Json.h"
#include "scene/json/JsonText.h"

namespace velum::scene {

namespace {

using LineJson = nlohmann::json;

constexpr std::ptrdiff_t kDeepestPath = 32;  ///< parts of a path; no scene is half as deep

// Between the parts of a line. Inside of a JSON text quotes are escaped, so that neither can occur in the head.
constexpr std::string_view kSumMark = ",\"sum\":\"", kPatchMark = "\",\"patch\":";

/// Parses text that may be hostile. @return discarded when it is no JSON or nests too deep
LineJson parseSafely(std::string_view text) {
  return nestsTooDeep(text) ? LineJson(LineJson::value_t::discarded) : LineJson::parse(text, nullptr, false);
}

std::string dumpSafely(const LineJson& json) { return json.dump(-1, ' ', false, LineJson::error_handler_t::replace); }

/// FNV-1a, 64 bits: finds damage, proves nothing.
std::string checkSum(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (unsigned char c : text) hash = (hash ^ c) * 1099511628211ull;
  return fmt::format("{:016x}", hash);
}

std::string textOf(const LineJson& object, const char* name) {
  auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Only what we write ourselves: "copy" and "move" would let a small text grow without bound.
bool isOurs(const LineJson& patch) {
  if (!patch.is_array()) return false;
  return std::all_of(patch.begin(), patch.end(), [](const LineJson& step) {
    if (!step.is_object()) return false;
    std::string kind = textOf(step, "op"), path = textOf(step, "path");
    bool known = kind == "add" || kind == "replace" || kind == "remove";
    return known && (kind == "remove" || step.contains("value")) &&
           std::count(path.begin(), path.end(), '/') <= kDeepestPath;
  });
}

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < kMostJournalLines) {
    std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;  // half written
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

std::optional<Scene> sceneOf(const SceneMirror& mirror) {
  try {
    return fromJson(mirror.text());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The lines of a journal that follow each other without a gap.
std::vector<ChangeLine> soundLines(std::string_view journal, bool& isWhole) {
  std::vector<ChangeLine> lines;
  bool first = true;
  for (std::string_view text : linesOf(journal)) {
    auto line = decodeLine(text);
    // The first may be damaged: the autosave holds what it held.
    if (!line && !first) break;
    if (!line) line = ChangeLine{};
    if (!first && lines.back().number != 0 && line->number != lines.back().number + 1) break;
    first = false;
    lines.push_back(std::move(*line));
  }
  std::size_t ends = std::size_t(std::count(journal.begin(), journal.end(), '\n'));
  isWhole = lines.size() == ends && (journal.empty() || journal.back() == '\n');
  return lines;
}

/// Applies the first lines. @return how many could be applied; the mirror stands after these
std::size_t applyLines(SceneMirror& mirror, std::string_view autosave, const std::vector<ChangeLine>& lines,
                       std::size_t count) {
  bool needsAutosave = lines.empty() || lines[0].patch.empty();
  std::size_t done = 0;
  try {
    mirror = needsAutosave ? SceneMirror(autosave) : SceneMirror();
    if (needsAutosave) done = std::min<std::size_t>(1, lines.size());
    for (; done < count; ++done) mirror.apply(lines[done].patch);
    return done;
  } catch (const InputError&) {
  }
  mirror = SceneMirror();
  // What the failing line left half done is made again without it.
  return done > (needsAutosave ? 1 : 0) ? applyLines(mirror, autosave, lines, done) : 0;
}

/// The longest start of the lines, by halving, that gives a scene: a value that no scene may hold came in with some
/// line. @param count  so many can be applied; the number for the scene that is given back
std::optional<Scene> bestScene(std::string_view autosave, const std::vector<ChangeLine>& lines, std::size_t& count) {
  SceneMirror mirror;
  std::optional<Scene> best;
  std::size_t bestCount = 0;
  for (std::size_t least = 0, most = count; least < most;) {
    std::size_t half = least + (most - least) / 2;
    applyLines(mirror, autosave, lines, half);
    if (auto scene = sceneOf(mirror)) {
      best = std::move(scene);
      bestCount = half;
      least = half + 1;
    } else {
      most = half;
    }
  }
  count = bestCount;
  return best;
}

}  // namespace

// ---- lines

std::string encodeLine(const ChangeLine& line) {
  LineJson head = {{"n", line.number}, {"s", std::round(line.seconds * 1000.0) / 1000.0}, {"label", line.label}};
  if (!line.title.empty()) head["title"] = line.title;
  if (!line.path.empty()) head["path"] = line.path;
  std::string text = dumpSafely(head);
  text.pop_back();
  // The patch as it is, so that the sum is of these very bytes.
  return fmt::format("{}{}{}{}{}}}\n", text, kSumMark, checkSum(text + line.patch), kPatchMark, line.patch);
}

std::optional<ChangeLine> decodeLine(std::string_view text) {
  std::size_t patchMark = text.find(kPatchMark), sumMark = text.substr(0, patchMark).find(kSumMark);
  if (patchMark == std::string_view::npos || sumMark == std::string_view::npos || text.back() != '}')
    return std::nullopt;
  std::string head(text.substr(0, sumMark));
  std::size_t sumBegin = sumMark + kSumMark.size(), patchBegin = patchMark + kPatchMark.size();
  ChangeLine line;
  line.patch = text.substr(patchBegin, text.size() - 1 - patchBegin);
  if (text.substr(sumBegin, patchMark - sumBegin) != checkSum(head + line.patch)) return std::nullopt;
  LineJson json = parseSafely(head + "}");
  if (!json.is_object()) return std::nullopt;
  auto number = json.find("n"), seconds = json.find("s");
  if (number == json.end() || !number->is_number_integer() || seconds == json.end() || !seconds->is_number())
    return std::nullopt;
  line.number = number->get<std::int64_t>();
  line.seconds = seconds->get<double>();
  line.label = textOf(json, "label");
  line.title = textOf(json, "title");
  line.path = textOf(json, "path");
  return line;
}

// ---- the mirror

struct SceneMirror::Data {
  LineJson json = LineJson::object();
};

SceneMirror::SceneMirror() : mData(std::make_unique<Data>()) {}

SceneMirror::SceneMirror(std::string_view sceneText) : SceneMirror() {
  LineJson json = parseSafely(sceneText);
  if (!json.is_object()) throw InputError("scene: the text is not a JSON object");
  mData->json = std::move(json);
}

SceneMirror::~SceneMirror() = default;
SceneMirror::SceneMirror(SceneMirror&&) noexcept = default;
SceneMirror& SceneMirror::operator=(SceneMirror&&) noexcept = default;

std::string SceneMirror::follow(const Scene& scene) {
  LineJson next = LineJson::parse(toJson(scene));
  LineJson patch = LineJson::diff(mData->json, next);
  if (patch.empty()) return {};
  mData->json = std::move(next);
  return dumpSafely(patch);
}

std::string SceneMirror::wholePatch() const {
  return dumpSafely(LineJson::array({{{"op", "replace"}, {"path", ""}, {"value", mData->json}}}));
}

void SceneMirror::apply(std::string_view patch) {
  LineJson json = parseSafely(patch);
  if (!isOurs(json)) throw InputError("journal: a change is not a list of add, replace and remove");
  try {
    mData->json.patch_inplace(json);
  } catch (const LineJson::exception& error) {
    throw InputError(fmt::format("journal: a change does not fit: {}", error.what()));
  }
  if (!mData->json.is_object()) throw InputError("journal: a change leaves no scene");
}

std::string SceneMirror::text() const { return dumpSafely(mData->json); }

// ---- replay

std::optional<Replayed> replay(std::string_view autosave, std::string_view journal) {
  Replayed out;
  std::vector<ChangeLine> lines = soundLines(journal, out.isWhole);
  SceneMirror mirror;
  std::size_t good = applyLines(mirror, autosave, lines, lines.size());
  out.isWhole = out.isWhole && good == lines.size();
  auto scene = sceneOf(mirror);
  if (!scene) {
    out.isWhole = false;
    scene = bestScene(autosave, lines, good);
  }
  if (!scene) return std::nullopt;
  out.scene = std::move(*scene);
  if (good > 0) out.last = std::move(lines[good - 1]);
  out.last.patch.clear();
  return out;
}

}  // namespace velum::scene
