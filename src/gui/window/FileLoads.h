#pragma once
#include <QObject>
#include <functional>

#include "gui/view/Room.h"
#include "session/document/Series.h"

namespace velum::gui {

/// Reads what is opened, in the background, asks for data that is missing, and shows it; remembers it among the recent
/// files.
class FileLoads : public QObject {
  Q_OBJECT
 public:
  explicit FileLoads(const WindowParts& parts);

  /// Files or folders. @param add  beside what is open, instead of in its place
  void openPaths(const QStringList& paths, bool add);
  void openPhantom(const QString& name, int voxels);
  /// One of session::showcases().
  void openSample(const QString& name);
  /// A file as labels of what is open, whatever it looks like.
  void openLabels(const QString& path);
  /// The work of a session that has died. @param path  what it was of
  void openLost(const std::filesystem::path& folder, const QString& path);
  /// Shows what has been read. @param path  what it is called
  void show(session::Loaded& loaded, const QString& path);

  /// Nothing is asked: data that is missing is an error.
  void setUnattended(bool unattended) { mUnattended = unattended; }
  bool isUnattended() const { return mUnattended; }
  /// Puts a file in front of the recent ones.
  void rememberFile(const QString& path);
  /// Keeps a picture of what is open for its card.
  void rememberPicture();

 signals:
  /// Something is about to be shown: the views are to have the size that they will have.
  void aboutToShow();
  /// It is a look, for what is open.
  void lookOpened(const QString& path);
  /// A volume was opened from its own file: what that does not say may be asked.
  void volumeOpened();
  /// Recovered work is safe again.
  void lostWorkTaken();

 private:
  void readPaths(const QStringList& paths, bool add);
  void askLayout(const QString& path);
  void askSeries(const QString& path);
  void openSeries(const QString& path, const std::vector<session::Series>& series);
  using Read = std::function<session::Loaded(Progress&)>;
  void start(const QString& what, Read read, bool add, const QString& path);
  void finish(std::shared_ptr<session::Loaded> loaded, const QString& path);
  bool locateMissing(session::Loaded& loaded);
  void sayNotes(const QString& name, const std::vector<std::string>& notes);
  session::DataPolicy policy() const;

  const WindowParts& mParts;
  bool mUnattended = false;
  bool mWantsPicture = false;  ///< The recent file that is open has no picture since it was opened.
};

}  // namespace velum::gui
