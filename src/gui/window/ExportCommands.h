#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gui/view/Room.h"
#include "session/picture/Picture.h"
#include "session/structure/StructureExport.h"

namespace velum::gui {

/// The commands that write files for other programs: pictures, sheets of membranes, volumes without the parts that are
/// cut away, models, counts and structures.
class ExportCommands : public Room {
  Q_OBJECT
 public:
  explicit ExportCommands(const WindowParts& parts) : Room(parts) {}
  /// Adds the commands where they stand in the File menu.
  void addActions(QMenu* menu);

  void savePictureTo(const QString& path, const session::PictureOptions& options, const scene::Scene& scene);
  /// Writes the sheet of the selected membrane, or of the first membrane where none is selected, as the sheet rests.
  void exportSheetTo(const QString& path);
  /// Writes the volume without the parts that the cuts take away.
  void exportClippedTo(const QString& path);
  /// Writes the instances of the model that the cuts leave.
  void exportModelTo(const QString& path);
  /// Writes how many instances of each type are seen, hidden and removed, in a picture as large as the view.
  void exportBarsTo(const QString& path);
  /// Writes structures as surfaces or as labels.
  void exportStructuresTo(const QString& path, const session::StructureExport& what);

 signals:
  /// Structures are to be exported: askExportStructures() is to be called with the selected structures.
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
  /// Writes a file from a scene whose sheets are at rest; called in a worker. @return what the file could not hold, one
  /// line each
  using Write = std::function<std::vector<std::string>(const scene::Scene& settled, Progress&)>;
  void write(const QString& path, Write work);
  int membraneToExport() const;
  std::function<scene::Scene(Progress&)> sceneAtRest() const;
};

}  // namespace velum::gui
