#pragma once
#include <QObject>
#include <functional>

#include "gui/view/Room.h"
#include "session/document/Series.h"

namespace velum::gui {

/// Reads files in the background, asks for data that is missing, and shows what was read; remembers the file among the
/// recent ones.
class FileLoads : public QObject {
  Q_OBJECT
 public:
  explicit FileLoads(const WindowParts& parts);

  /// Opens files or folders. @param add  to the open scene, instead of in its place
  void openPaths(const QStringList& paths, bool add);
  void openPhantom(const QString& name, int voxels);
  /// Opens one of session::showcases().
  void openSample(const QString& name);
  /// Opens a file as its source says, however much memory it takes.
  void openWhole(const scene::Source& source);
  /// Opens a file as labels of the open scene, whatever kind of file it seems to be.
  void openLabels(const QString& path);
  /// Opens the work of a session that has died. @param path  the file that this work was of
  void openLost(const std::filesystem::path& folder, const QString& path);
  /// Shows what has been read. @param path  of the file, as the user knows it
  void show(session::Loaded& loaded, const QString& path);

  /// Nothing is asked: data that is missing is an error.
  void setUnattended(bool unattended) { mUnattended = unattended; }
  bool isUnattended() const { return mUnattended; }
  /// Puts a file in front of the recent ones.
  void rememberFile(const QString& path);
  /// Keeps a picture of the open scene for the card of its file.
  void rememberPicture();

 signals:
  /// A scene is about to be shown: the views are to take their final size now.
  void aboutToShow();
  /// The file is a look, which is to be given to the open scene.
  void lookOpened(const QString& path);
  /// A volume was opened from its own file: facts that the file does not tell may now be asked for.
  void volumeOpened();
  /// A file was not read, as it takes more memory than is taken unasked.
  void tooLarge(const velum::scene::Source& source);
  /// Recovered work is safe again.
  void lostWorkTaken();

 private:
  void readPaths(const QStringList& paths, bool add);
  void askLayout(const QString& path);
  void askSeries(const QString& path);
  void openSeries(const QString& path, const std::vector<session::Series>& series);
  using Read = std::function<session::Loaded(Progress&)>;
  void start(const QString& what, Read read, bool add, const QString& path);
  void openUnlessLarge(const scene::Source& source);
  void finish(std::shared_ptr<session::Loaded> loaded, const QString& path);
  bool locateMissing(session::Loaded& loaded);
  void sayNotes(const QString& name, const std::vector<std::string>& notes);
  session::DataPolicy policy() const;

  const WindowParts& mParts;
  bool mUnattended = false;
  bool mWantsPicture = false;  ///< No picture of the open recent file has been kept since it was opened.
};

}  // namespace velum::gui
