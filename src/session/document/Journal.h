#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "scene/Scene.h"
#include "scene/json/ChangeLog.h"

namespace velum::session {

/// Keeps on the disk what is done to a document, so that after a crash at most the last second is lost.
///
/// Each journal has a folder of its own, which holds generations: `journal-N.jsonl` begins with the whole scene and
/// goes on with what each change changed (scene/json/ChangeLog.h); `autosave-N.json` is the scene with which that
/// journal began, to open by hand or when the journal's first line is damaged. When a journal has grown, the next
/// generation begins; the generation before it is kept. `lock` is held (flock) while the session lives. The folder is
/// made with the first change, and goes with discard().
///
/// A disk that is full takes nothing from what is in memory: the next generation, once there is room, begins with the
/// scene as it is then.
///
/// Writing is done in threads of the journal: no call waits for the disk, except flush() and the destructor. Every
/// change is handed to the system within a tenth of a second, and synced to the disk about once a second.
class Journal {
 public:
  struct Options {
    std::filesystem::path root;             ///< where the journal's folder is made
    std::chrono::milliseconds pause{100};   ///< at least between two lines: a drag is a few lines, not hundreds
    std::size_t compactBytes = 256 << 10;   ///< a journal that is longer, and four times its autosave, begins anew
    std::chrono::milliseconds retry{5000};  ///< between two tries, after the disk has refused
    std::size_t mostBytes = scene::kMostJournalBytes;  ///< of a journal; a scene that is larger cannot be journaled
    std::size_t mostLines = scene::kMostJournalLines;
  };

  explicit Journal(Options options);
  /// Writes what is due and leaves the folder on the disk, unless discard() came after the last change.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// What is open, for the offer after a crash. @param path  file of the scene; empty: not saved yet
  void describe(const std::string& title, const std::string& path);
  /// To be called after each change of the scene. @param label  what was done
  void record(const scene::Scene& scene, const std::string& label);
  /// The work is saved, or given up: the journal's folder goes. The next change makes another folder.
  void discard();
  /// Waits until all that was asked for (changes, or discard()) is done and on the disk. @return false when the disk
  /// refuses
  bool flush();

  /// @param listener  told in words when the disk begins to refuse, and "" when the disk takes everything again, from a
  /// thread of the journal. Meanwhile the journal goes on trying, with and without changes. To be set before the first
  /// change.
  void setErrorListener(std::function<void(const std::string&)> listener);

 private:
  struct Impl;
  std::unique_ptr<Impl> mImpl;
};

}  // namespace velum::session
