#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace velum::session {

/// What the frames of a film depend on besides their numbers, by names for people: scene, size, renderer ... Two films
/// with the same pairs have the same frames.
using FilmIdentity = std::vector<std::pair<std::string, std::string>>;

/// A file of a frame, as it was when it was whole.
struct FrameFile {
  std::string name;  ///< without its folder
  std::uint64_t bytes = 0;
  std::uint32_t sum = 0;  ///< CRC-32C
  bool operator==(const FrameFile&) const = default;
};

/// What became of a frame: its files (its layers have files of their own), or why there are none.
struct FrameRecord {
  int frame = 0;
  double ms = 0;
  std::vector<FrameFile> files;
  std::string error;  ///< empty: it was drawn
  bool operator==(const FrameRecord&) const = default;
};

/// What a process has to say of the frames that it drew: a file of lines of JSON, of which the first tells the film and
/// each of the others a frame. A line is appended when the frame's files are whole on the disk, so that whatever a line
/// says is so, unless somebody has changed the files since.
struct FilmManifest {
  FilmIdentity film;
  int frames = 0;  ///< of the whole film
  double framesPerSecond = 25.0;
  std::vector<FrameRecord> records;
};

/// Reads a manifest. Lines that are none, as the last may be where a process was killed, are passed over.
/// @return nothing where the file is no manifest
std::optional<FilmManifest> readManifest(const std::filesystem::path& path);

/// The manifest as text: its lines, each with its end.
std::string manifestText(const FilmManifest& manifest);
/// The line of one frame, with its end.
std::string recordLine(const FrameRecord& record);

/// A file as a manifest tells it: reads all of it. @return nothing where it cannot be read
std::optional<FrameFile> frameFileAt(const std::filesystem::path& path);

}  // namespace velum::session
