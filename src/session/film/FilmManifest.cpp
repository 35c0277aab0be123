#include "session/film/FilmManifest.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "io/stores/Crc32c.h"

namespace velum::session {

namespace {

using ManifestJson = nlohmann::ordered_json;
constexpr const char* kFilmMark = "velum film";
constexpr int kMostFrames = 10'000'000;

/// On one line; bytes of names that are not UTF-8 become the replacement character.
std::string lineOf(const ManifestJson& json) {
  return json.dump(-1, ' ', false, ManifestJson::error_handler_t::replace) + "\n";
}

/// A line; nothing where it is none, or lacks what each has. @param read  throws nlohmann's exceptions
template <class Read>
auto lineAs(const std::string& line, Read read) -> std::optional<decltype(read(ManifestJson()))> {
  try {
    return read(ManifestJson::parse(line));
  } catch (const ManifestJson::exception&) {
    return std::nullopt;
  }
}

FilmManifest headOf(const ManifestJson& json) {
  FilmManifest head;
  for (const auto& [name, value] : json.at(kFilmMark).items()) head.film.emplace_back(name, value.get<std::string>());
  head.frames = json.at("frames").get<int>();
  head.framesPerSecond = json.at("fps").get<double>();
  return head;
}

FrameRecord recordOf(const ManifestJson& json) {
  FrameRecord record{json.at("frame").get<int>(), json.at("ms").get<double>(), {}, json.value("error", "")};
  if (json.contains("files"))
    for (const ManifestJson& file : json.at("files"))
      record.files.push_back({file.at("name").get<std::string>(), file.at("bytes").get<std::uint64_t>(),
                              file.at("crc32c").get<std::uint32_t>()});
  return record;
}

/// A file beside the manifest, and no path that leads elsewhere.
bool isBeside(const FrameFile& file) { return std::filesystem::path(file.name).filename() == file.name; }

}  // namespace

std::optional<FilmManifest> readManifest(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  auto manifest = lineAs(line, headOf);
  if (!manifest || manifest->frames < 1 || manifest->frames > kMostFrames) return std::nullopt;
  while (std::getline(file, line)) {
    auto record = lineAs(line, recordOf);
    bool isOurs = record && record->frame >= 0 && record->frame < manifest->frames &&
                  std::all_of(record->files.begin(), record->files.end(), isBeside);
    if (isOurs) manifest->records.push_back(std::move(*record));
  }
  return manifest;
}

std::string recordLine(const FrameRecord& record) {
  ManifestJson json{{"frame", record.frame}, {"ms", record.ms}};
  if (!record.error.empty()) json["error"] = record.error;
  for (const FrameFile& file : record.files)
    json["files"].push_back({{"name", file.name}, {"bytes", file.bytes}, {"crc32c", file.sum}});
  return lineOf(json);
}

std::string manifestText(const FilmManifest& manifest) {
  ManifestJson film = ManifestJson::object();
  for (const auto& [name, value] : manifest.film) film[name] = value;
  std::string text = lineOf({{kFilmMark, film}, {"frames", manifest.frames}, {"fps", manifest.framesPerSecond}});
  for (const FrameRecord& record : manifest.records) text += recordLine(record);
  return text;
}

std::optional<FrameFile> frameFileAt(const std::filesystem::path& path) {
  std::error_code error;
  std::uint64_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) return std::nullopt;
  std::string all(size, '\0');
  if (!file.read(all.data(), std::streamsize(size))) return std::nullopt;
  return FrameFile{path.filename().string(), all.size(), io::crc32c(std::as_bytes(std::span(all)))};
}

}  // namespace velum::session
