#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/Task.h"
#include "session/document/Document.h"
#include "session/document/Journal.h"
#include "session/document/Recovery.h"
#include "session/document/Sources.h"

namespace velum::session {

/// What a load gives.
struct Loaded {
  scene::Scene scene;
  bool isScene = false;             ///< camera and layout are its own
  std::string path;                 ///< of several files the one by which the scene is called; empty: the caller knows
  std::vector<std::string> notes;   ///< for the user
  std::unique_ptr<WorkClaim> lost;  ///< recovered work, until it is journaled anew
};

// Reading, for jobs: any thread. @throw InputError, Cancelled

/// Files and folders as one scene, each as its source says: a series, a layout of raw samples, a voxel size.
Loaded read(const std::vector<scene::Source>& sources, Progress& progress, const DataPolicy& policy);
/// The same of files that are read as they say themselves.
Loaded readPaths(const std::vector<std::string>& paths, Progress& progress, const DataPolicy& policy);
/// The volume of a scene read anew as another source says: with another voxel size or layout. Cuts and camera
/// grow with the voxels, labels on its grid go with it; what has another type or size gets the look that fits it.
/// @throw ArgumentError where structures were grown in it and would lie elsewhere
void rereadVolume(scene::Scene& scene, const scene::Source& source, Progress& progress);
/// The same beside what is open. @param beside  the scene as it is
Loaded readBeside(scene::Scene beside, const std::vector<std::string>& paths, Progress& progress);
/// A file as labels of what is open, whatever it looks like.
Loaded readLabels(scene::Scene beside, const std::string& path, Progress& progress);
/// A phantom. @param voxels  along its longest axis; 0: its own size  @param folder  where its files are written
Loaded readPhantom(const std::string& name, int voxels, const std::filesystem::path& folder, Progress& progress);
/// The work of a session that has died.
Loaded readLost(const std::filesystem::path& folder, Progress& progress, const DataPolicy& policy);
/// The data that a scene still misses, its paths named meanwhile.
void readMissing(Loaded& loaded, Progress& progress, const DataPolicy& policy);

/// What the document is of: the file that is open, where the scene is saved, and the journal that keeps what is not.
/// The document's thread.
class WorkFile {
 public:
  explicit WorkFile(Document& document) : mDocument(document) {}

  bool isOpen() const { return mIsOpen; }
  /// What is open: file, folder or scene; of a phantom its name. Empty: nothing has a name.
  const std::string& path() const { return mPath; }
  /// Where the scene is saved; empty: not yet.
  const std::string& scenePath() const { return mScenePath; }
  /// Its last part, for people.
  std::string name() const;
  bool isModified() const { return mIsOpen && mDocument.isModified(); }

  /// Shows what was read, in the place of what is open. @param path  what it is called
  void open(Loaded loaded, const std::string& path);
  /// Adds what was read beside, as one undo step: a look that was changed meanwhile stays.
  void add(const Loaded& loaded);
  /// Back to nothing.
  void close();
  /// Writes the scene; it is the file's from now on. @throw InputError when the disk refuses
  void save(const std::string& path);

  /// Journals every change from now on, in a folder under this one. @param onError  told in words when the disk begins
  /// to refuse, and nothing when it takes all again, from a thread of the journal
  void protect(const std::filesystem::path& root, std::function<void(const std::string&)> onError);
  bool isProtected() const { return mJournal != nullptr; }
  const std::filesystem::path& recoveryRoot() const { return mRecoveryRoot; }
  /// To be called after every change of the document.
  void journalChange();
  /// Waits until what is journaled is on the disk.
  void flushJournal();
  /// What is journaled is saved, or given up. @param flush  waits until that is on the disk
  void discardJournal(bool flush = false);

 private:
  void replace(scene::Scene scene, std::vector<std::string> opening = {});
  void describe();
  void dropLost();

  Document& mDocument;
  bool mIsOpen = false;
  std::string mPath, mScenePath;
  bool mIsReplacing = false;           ///< Another scene is coming in: that is no change to journal.
  std::uint64_t mJournaledChange = 0;  ///< The document's change that the journal heard of last.
  std::filesystem::path mRecoveryRoot;
  std::unique_ptr<Journal> mJournal;
  std::unique_ptr<WorkClaim> mLost;  ///< What was recovered, while no journal of ours holds it.
};

}  // namespace velum::session
