#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "session/film/FilmManifest.h"
#include "session/film/FrameNames.h"

namespace velum::session {

/// Which frames of a film are there.
struct FramesThere {
  FilmManifest film;                  ///< without records
  std::vector<std::string> pictures;  ///< by frame, its picture's name; empty: missing or broken
  std::vector<FrameRecord> records;   ///< by frame, of those that are there
};

/// Looks for the frames of a film among its files: those whose files have the size and sum that a manifest tells. Reads
/// all files of the frames of the part; others count as missing. @return nothing where there is no manifest  @throw
/// InputError where manifests tell of several films, or one is damaged
std::optional<FramesThere> findFrames(const FrameNames& names, Part part, Progress& progress);

/// "3, 7-9 and 240", of numbers in order; no more than some of them are named.
std::string rangesOf(const std::vector<int>& numbers);

/// The folder that a film's frames are written to, with this process' manifest.
class FrameFolder {
 public:
  /// What is to become of frames that are there: of this film, and of another one.
  struct Old {
    bool resume = false;     ///< whole frames of this film are kept; else they are drawn anew
    bool overwrite = false;  ///< another film may be written over; else it is refused
  };
  /// Begins the manifest of a part; makes the folder where a user names one that is not there.
  /// @param film  its records are not read  @throw InputError where the files are another film's, and when the disk
  /// refuses
  FrameFolder(const FrameNames& names, Part part, const FilmManifest& film, Old old, Progress& progress);
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  /// The frame is there and whole, and is to be kept.
  bool has(int frame) const { return mKept[std::size_t(frame)]; }
  std::filesystem::path place(int frame) const { return mNames.frame(frame); }
  /// Notes what became of a frame. Takes as long for each. @param files  those that were written, whole on the disk
  /// @throw InputError when the disk refuses
  void add(int frame, double ms, const std::vector<std::filesystem::path>& files);
  void addFailure(int frame, double ms, const std::string& error);

 private:
  void append(const FrameRecord& record);

  FrameNames mNames;
  std::filesystem::path mManifest;
  std::vector<bool> mKept;
  int mFile = -1;  ///< the manifest, open for appending
};

}  // namespace velum::session
