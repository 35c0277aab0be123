#pragma once
#include <QComboBox>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "gui/service/NewestJob.h"
#include "scene/Scene.h"
#include "session/command/DocumentCommands.h"

namespace velum::gui {

/// Asks over which data a scene and its film are to be carried: a volume, its labels, and the structure of both by
/// which places are found again. Labels that are named are read meanwhile, for what they have in common with those of
/// the scene.
class CarryDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param folder  where files are looked for first; empty: where the program was started
  CarryDialog(const scene::Scene& scene, const QString& folder, QWidget* parent);
  session::CarryScene call() const;
  /// The labels that are named are still being read.
  bool isReading() const { return mReading.isBusy(); }

 private:
  QLineEdit* addPath(QGridLayout* grid, const QString& title, const char* name, const QString& tip, bool mayBeFolder);
  void addButtons(QLayout* layout);
  void browse(QLineEdit& line, bool folder);
  void readLabels();
  void offer(const std::vector<std::string>& structures);
  void tell();

  scene::LabelLayer mLabels;
  QString mFolder, mRead;  ///< mRead: the labels whose structures are offered, or are being read
  std::string mWhyNotRead;
  QLineEdit *mVolume, *mOther;
  QComboBox* mStructure;
  QLabel* mSaid;
  QPushButton* mCarry = nullptr;
  NewestJob mReading;
};

}  // namespace velum::gui
