#pragma once
#include <QWidget>

#include "gui/kit/Widgets.h"
#include "gui/look/ChannelList.h"
#include "gui/look/PresetGrid.h"
#include "gui/look/TransferEditor.h"
#include "gui/rows/FieldForm.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Presets, channels, the transfer function, way of rendering, light and background. Reads the document, and
/// changes it by edits only.
class LookPanel : public QWidget {
  Q_OBJECT
 public:
  LookPanel(session::Document& document, QWidget* parent);
  /// Shows the document as it is now.
  void refresh();
  /// True when no histogram is being counted and no preset's picture is being drawn for this panel in the background.
  bool isComplete() const { return mPresets->isComplete() && mEditor->isComplete(); }

 public slots:
  /// The view's picture is complete: the machine is free to draw the presets' pictures.
  void viewIsComplete() { mPresets->drawPictures(); }
  /// Shows the value that is under the pointer in a view.
  void setProbe(double value) { mEditor->setProbe(value); }
  void clearProbe() { mEditor->clearProbe(); }

 private:
  QWidget* makeLook();
  QWidget* makeLight();
  QWidget* makeBackground();
  void showIso(const Volume& volume);

  session::Document& mDocument;
  ChannelList* mChannels;
  PresetGrid* mPresets;
  TransferEditor* mEditor;
  FieldForm mForm;
  NumberRow* mIso = nullptr;
};

}  // namespace velum::gui
