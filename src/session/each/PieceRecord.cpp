#include "session/each/PieceRecord.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "core/Error.h"
#include "core/ReplaceFile.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

using PieceJson = nlohmann::ordered_json;

std::string pieceLine(const PieceJson& json) {
  return json.dump(-1, ' ', false, PieceJson::error_handler_t::replace) + "\n";
}

PieceJson identityJson(const FilmIdentity& wanted) {
  PieceJson json = PieceJson::object();
  for (const auto& [name, value] : wanted) json[name] = value;
  // As it is read back: bytes that are not UTF-8 are replaced.
  return PieceJson::parse(pieceLine(json));
}

bool areWhole(const PieceJson& files, const std::vector<fs::path>& outputs) {
  if (files.size() != outputs.size()) return false;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    FrameFile told{outputs[i].filename().string(), files[i].at("bytes").get<std::uint64_t>(),
                   files[i].at("crc32c").get<std::uint32_t>()};
    std::error_code error;
    if (fs::file_size(outputs[i], error) != told.bytes || frameFileAt(outputs[i]) != told) return false;
  }
  return true;
}

/// Takes in a line of an attempt at what is wanted.
void follow(PieceState& state, const PieceJson& line, const std::vector<fs::path>& outputs) {
  using enum PieceState::Is;
  if (line.contains("begun")) {
    state.is = Begun;
    ++state.begun;
  } else if (line.contains("failed")) {
    state = {Failed, 0, line.at("failed").get<std::string>(), line.at("ms").get<double>()};
  } else if (line.contains("done")) {
    bool isWhole = areWhole(line.at("done"), outputs);
    state = {isWhole ? Done : Missing, 0, {}, isWhole ? line.at("ms").get<double>() : 0.0};
  } else if (line.contains("stopped")) {
    state.begun = std::max(0, state.begun - 1);
    state.is = state.begun > 0 ? Begun : Missing;
  }
}

/// The files of a data set: all of a folder; beside a header those of its name, where voxels lie that it tells of.
std::vector<fs::path> filesOf(const fs::path& path) {
  std::vector<fs::path> files;
  auto add = [&](const fs::directory_entry& entry) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  };
  if (fs::is_directory(path)) {
    for (const auto& entry : fs::recursive_directory_iterator(path)) add(entry);
    return files;
  }
  std::string extension = path.extension().string();
  if (extension != ".mhd" && extension != ".nhdr" && extension != ".hdr") return {path};
  for (const auto& entry : fs::directory_iterator(path.has_parent_path() ? path.parent_path() : fs::path(".")))
    if (entry.path().stem() == path.stem()) add(entry);
  return files;
}

}  // namespace

PieceRecord::PieceRecord(fs::path file) : mPath(std::move(file)) {
  std::error_code error;
  fs::create_directories(mPath.parent_path(), error);
  mFile = ::open(mPath.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (mFile < 0)
    throw InputError(fmt::format("{}: cannot be written ({})", mPath.string(), std::generic_category().message(errno)));
}

PieceRecord::~PieceRecord() { ::close(mFile); }

void PieceRecord::append(const std::string& line) {
  if (!writeAll(mFile, std::as_bytes(std::span(line))))
    throw InputError(fmt::format("{}: cannot be written; check the free space", mPath.string()));
}

void PieceRecord::begin(const FilmIdentity& wanted) {
  // What a killed process has begun to write is a line of its own.
  append("\n" + pieceLine({{"begun", identityJson(wanted)}}));
}

void PieceRecord::done(double ms, const std::vector<fs::path>& outputs) {
  PieceJson files = PieceJson::array();
  for (const fs::path& path : outputs) {
    auto file = frameFileAt(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read again", path.string()));
    files.push_back({{"file", path.string()}, {"bytes", file->bytes}, {"crc32c", file->sum}});
  }
  append(pieceLine({{"done", files}, {"ms", ms}}));
}

void PieceRecord::failed(double ms, const std::string& error) { append(pieceLine({{"failed", error}, {"ms", ms}})); }

void PieceRecord::stopped() { append(pieceLine({{"stopped", true}})); }

PieceState stateOf(const fs::path& record, const FilmIdentity& wanted, const std::vector<fs::path>& outputs) {
  std::ifstream file(record, std::ios::binary);
  PieceJson identity = identityJson(wanted);
  PieceState state;
  bool isWanted = false;
  for (std::string line; std::getline(file, line);) {
    if (line.empty()) continue;
    try {
      PieceJson json = PieceJson::parse(line);
      if (json.contains("begun")) isWanted = json.at("begun") == identity;
      if (isWanted) follow(state, json, outputs);
    } catch (const PieceJson::exception&) {
      isWanted = false;  // the last line of a process that was killed
    }
  }
  return state;
}

std::string dataStamp(const fs::path& path) {
  try {
    std::uintmax_t bytes = 0;
    fs::file_time_type latest = fs::last_write_time(path);
    const std::vector<fs::path> files = filesOf(path);
    for (const fs::path& file : files) {
      bytes += fs::file_size(file);
      latest = std::max(latest, fs::last_write_time(file));
    }
    return fmt::format("{} bytes in {} file{}, {}", bytes, files.size(), files.size() == 1 ? "" : "s",
                       latest.time_since_epoch().count());
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.code().message()));
  }
}

}  // namespace velum::session
