#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "session/film/FilmManifest.h"

namespace velum::session {

/// What became of a piece.
struct PieceState {
  enum class Is { Missing, Begun, Failed, Done };
  Is is = Is::Missing;
  int begun = 0;      ///< how often it was begun and neither done nor stopped by anybody: its process has died
  std::string error;  ///< Failed: why, one line
  double ms = 0.0;    ///< Done, Failed: how long it took
};

/// The record of a piece: a file of lines of JSON that only ever grows. Each attempt is a line that says what is
/// wanted, with the data's size and time, and one that says how it ended, written when the outputs are whole on the
/// disk. While a process works at a piece it has the record locked; the lock ends with the process.
class PieceRecord {
 public:
  /// Takes a piece. @return nothing while another process has it  @throw InputError when the disk refuses
  static std::optional<PieceRecord> take(const std::filesystem::path& file);
  PieceRecord(PieceRecord&& other) noexcept : mPath(std::move(other.mPath)), mFile(std::exchange(other.mFile, -1)) {}
  PieceRecord& operator=(PieceRecord&&) = delete;
  ~PieceRecord();

  /// @throw InputError when the disk refuses
  void begin(const FilmIdentity& wanted);
  void done(double ms, const std::vector<std::filesystem::path>& outputs);
  void failed(double ms, const std::string& error);
  /// Somebody has stopped the work, and it is not the piece's fault.
  void stopped();

 private:
  PieceRecord(std::filesystem::path path, int file) : mPath(std::move(path)), mFile(file) {}
  void append(const std::string& line);

  std::filesystem::path mPath;
  int mFile;
};

/// What a record tells of the piece that is wanted; all else in it is passed over: attempts at other data or with other
/// options, and lines that are none. Reads the outputs: one that is not there, or not as it was written, is missing.
PieceState stateOf(const std::filesystem::path& record, const FilmIdentity& wanted,
                   const std::vector<std::filesystem::path>& outputs);

/// A file or folder as identities tell it: its bytes and the time of its last change, with those of files of voxels
/// beside a header (.mhd, .nhdr, .hdr) that have its name. @throw InputError where it cannot be read
std::string dataStamp(const std::filesystem::path& path);

}  // namespace velum::session
