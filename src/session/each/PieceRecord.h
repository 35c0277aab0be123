#pragma once
#include <filesystem>
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
/// disk. Whoever writes to it has the piece's OutputLocks.
class PieceRecord {
 public:
  /// Begins the file, and the folder, where there is none. @throw InputError when the disk refuses
  explicit PieceRecord(std::filesystem::path file);
  PieceRecord(const PieceRecord&) = delete;
  PieceRecord& operator=(const PieceRecord&) = delete;
  ~PieceRecord();

  /// @throw InputError when the disk refuses
  void begin(const FilmIdentity& wanted);
  void done(double ms, const std::vector<std::filesystem::path>& outputs);
  void failed(double ms, const std::string& error);
  /// Somebody has stopped the work, and it is not the piece's fault.
  void stopped();

 private:
  void append(const std::string& line);

  std::filesystem::path mPath;
  int mFile;
};

/// What a record tells of the piece that is wanted; all else in it is passed over: attempts at other data or with other
/// options, and lines that are none. Reads the outputs, however they are spelled: one that is not there, or not as it
/// was written, is missing.
PieceState stateOf(const std::filesystem::path& record, const FilmIdentity& wanted,
                   const std::vector<std::filesystem::path>& outputs);

/// A file or folder as identities tell it: its bytes and the time of its last change, with those of files of voxels
/// beside a header (.mhd, .nhdr, .hdr) that have its name. @throw InputError where it cannot be read
std::string dataStamp(const std::filesystem::path& path);

}  // namespace velum::session
