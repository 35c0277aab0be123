#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gui/view/Room.h"
#include "session/picture/Film.h"
#include "session/structure/StructureExport.h"

namespace velum::gui {

/// What is written for other programs: pictures, sheets of membranes, volumes without what is cut away.
class ExportCommands : public Room {
  Q_OBJECT
 public:
  explicit ExportCommands(const WindowParts& parts) : Room(parts) {}
  /// Adds the commands where they stand in the File menu.
  void addActions(QMenu* menu);

  void savePictureTo(const QString& path, const session::PictureOptions& options, const scene::Scene& scene);
  /// Its frames, NAME-0000 and on.
  void saveAnimationTo(const QString& path, const session::PictureOptions& options, const scene::Scene& scene,
                       session::Motion motion, int frames);
  /// The sheet of the selected membrane, or of the first, as it rests.
  void exportSheetTo(const QString& path);
  /// The volume without what the cuts take away.
  void exportClippedTo(const QString& path);
  /// The instances that cuts leave of the model.
  void exportModelTo(const QString& path);
  /// How many of each type are seen, hidden and removed, in a picture as large as the view.
  void exportBarsTo(const QString& path);
  /// Structures as surfaces or as labels.
  void exportStructuresTo(const QString& path, const session::StructureExport& what);

 signals:
  /// Structures are to be exported: askExportStructures() with those that are selected.
  void exportStructuresAsked();

 public slots:
  void askExportSheet();
  void askExportClipped();
  void askExportModel();
  void askExportBars();
  /// @param selected  ids of structures
  void askExportStructures(const std::vector<int>& selected);

 private:
  void askSavePicture();
  QString askPath(const QString& title, const char* suffix, const QString& filters);
  /// What is to be written, from a scene at rest. @return what the file could not hold
  using Write = std::function<std::vector<std::string>(const scene::Scene& settled, Progress&)>;
  void write(const QString& path, Write work);
  int membraneToExport() const;
  std::function<scene::Scene(Progress&)> sceneAtRest() const;
};

}  // namespace velum::gui
