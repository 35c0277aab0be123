#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
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
  bool isScene = false;             ///< the camera and layout are the file's own
  std::string path;                 ///< the one of several files by which the scene is called; empty: the caller knows
  std::vector<std::string> notes;   ///< what the user should know, one line each
  std::unique_ptr<WorkClaim> lost;  ///< the claim on recovered work, held until the work is journaled anew
};

// Reading, for jobs: any thread. @throw InputError, Cancelled

/// Reads files and folders as one scene, each as its source says: a series, a layout of raw samples, a voxel size.
Loaded read(const std::vector<scene::Source>& sources, Progress& progress, const DataPolicy& policy);
/// As read(), for files that say themselves how they are to be read.
Loaded readPaths(const std::vector<std::string>& paths, Progress& progress, const DataPolicy& policy);
/// Reads the volume of a scene anew as another source says: with another voxel size or layout. Cuts and camera grow
/// with the voxels, and labels on the volume's grid are read anew with it; a volume whose type, size or range has
/// changed gets the look that fits it.
/// @throw ArgumentError where there is no volume, or where structures were grown in it and would lie elsewhere
void rereadVolume(scene::Scene& scene, const scene::Source& source, Progress& progress);
/// Reads files beside what is open. @param beside  the scene that is open
Loaded readBeside(scene::Scene beside, const std::vector<std::string>& paths, Progress& progress,
                  const DataPolicy& policy = {});
/// Reads a file as labels of what is open, whatever the file looks like. @param beside  the scene that is open
Loaded readLabels(scene::Scene beside, const scene::Source& source, Progress& progress);
/// Makes and reads a phantom. @param voxels  along its longest axis; 0: its own size  @param folder  where its files
/// are written
Loaded readPhantom(const std::string& name, int voxels, const std::filesystem::path& folder, Progress& progress);
/// Reads the work of a session that has died.
Loaded readLost(const std::filesystem::path& folder, Progress& progress, const DataPolicy& policy);
/// Reads the data that a scene still misses, now that its paths have been named.
void readMissing(Loaded& loaded, Progress& progress, const DataPolicy& policy);

/// To what file the document belongs: the file that is open, where the scene is saved, and the journal that keeps what
/// is not saved. The document's thread.
class WorkFile {
 public:
  explicit WorkFile(Document& document) : mDocument(document) {}

  bool isOpen() const { return mName.isOpen; }
  /// What is open: file, folder or scene; for a phantom its name; of a scene that was carried over to other data the
  /// path of these. Empty: what is open has no name.
  std::string path() const;
  /// Where the scene is saved; empty: nowhere yet.
  std::string scenePath() const { return isCarried() ? std::string() : mName.scenePath; }
  /// The last part of path(), for people.
  std::string name() const;
  bool isModified() const { return isOpen() && mDocument.isModified(); }

  /// Shows what was read, in the place of what is open. @param path  what the work is called from now on
  void open(Loaded loaded, const std::string& path);
  /// Adds what readBeside() or readLabels() gave, as one undo step: labels of another source, another model, surfaces
  /// that are not there yet, and the volume where there is none yet. What was changed while the data was read, such as
  /// the colour of a structure or the volume's look, stays.
  void add(const Loaded& loaded);
  /// Puts the scene as it was carried over to other data in the place of the scene, as one undo step, whatever the
  /// playhead shows. The file stays that of the scene before: unless undo brings its data back, saving asks for another
  /// one. @param command  line of a script that does the same
  void carry(scene::Scene scene, const std::string& command);
  /// Closes what is open: an empty scene without a name.
  void close();
  /// Writes the scene to a file, which is the document's file from now on. @throw InputError when the disk refuses
  void save(const std::string& path);

  /// By what what is open is called.
  struct Name {
    bool isOpen = false;
    std::string path, scenePath;
    std::optional<std::string> ownVolume;  ///< of a scene that was carried over: path of the volume that its file names
  };
  /// What is open, with its history.
  struct Before {
    Document document;
    Name name;
  };
  /// What there is before work that may be stopped.
  Before before() const { return {mDocument, mName}; }
  /// Puts back what there was: the work has not been done. Files that it has written stay.
  void restore(Before before);

  /// Journals every change from now on, in a folder under `root`. @param onError  told in words when the disk begins to
  /// refuse, and "" when the disk takes everything again, from a thread of the journal
  void protect(const std::filesystem::path& root, std::function<void(const std::string&)> onError);
  bool isProtected() const { return mJournal != nullptr; }
  const std::filesystem::path& recoveryRoot() const { return mRecoveryRoot; }
  /// To be called after every change of the document.
  void journalChange();
  /// Waits until what is journaled is on the disk.
  void flushJournal();
  /// Deletes the journal: the work that it keeps is saved, or given up. @param flush  waits until that is done on the
  /// disk
  void discardJournal(bool flush = false);

 private:
  void replace(scene::Scene scene, std::vector<std::string> opening = {});
  bool isCarried() const;
  void describe();
  void dropLost();

  Document& mDocument;
  Name mName;
  bool mIsReplacing = false;           ///< Another scene is coming in: that is no change to journal.
  std::uint64_t mJournaledChange = 0;  ///< the number of the document's change that the journal has heard of last
  std::filesystem::path mRecoveryRoot;
  std::unique_ptr<Journal> mJournal;
  std::unique_ptr<WorkClaim> mLost;  ///< the claim on recovered work, while no journal of ours holds that work
};

}  // namespace velum::session
