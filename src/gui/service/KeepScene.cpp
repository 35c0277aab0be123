#include "gui/service/KeepScene.h"

#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>

#include "scene/Scene.h"
#include "session/document/Open.h"

namespace velum::gui {

std::filesystem::path keepScene(const scene::Scene& scene) {
  QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/velum/scenes";
  QDir().mkpath(folder);
  std::filesystem::path place(folder.toStdString());
  std::string text = session::sceneTextFor(scene, place / "scene.json");
  QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex().left(12);
  std::filesystem::path file = place / ("scene-" + hash.toStdString() + ".json");
  session::saveScene(scene, file);
  return file;
}

}  // namespace velum::gui
