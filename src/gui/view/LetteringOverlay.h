#pragma once
#include <QString>
#include <map>
#include <utility>
#include <vector>

#include "core/Model.h"
#include "core/Shared.h"
#include "gui/tool/Manipulator.h"
#include "gui/view/Viewport.h"
#include "scene/SceneFwd.h"
#include "session/lettering/Lettering.h"

namespace velum::gui {

/// What is written over the 3D view (scene::Lettering), as over pictures of the view's size, and marks over sections.
class LetteringOverlay : public Manipulator {
 public:
  LetteringOverlay(const session::Document& document, Viewport& viewport) : mDocument(document), mViewport(viewport) {}

  /// To be called when a picture is complete, and when a legend is asked for: counts which types the picture shows.
  /// @return true when the legend's entries have changed
  bool count();
  /// What the legend names, from its top.
  std::vector<QString> names() const;

  /// What marks measure that are not measured at once, by their ids.
  void setMeasured(std::map<int, session::Measured> measured) { mMeasured = std::move(measured); }

  void paint(ViewPainter& over) const override;

 private:
  const session::TypePixels& pixels() const;

  const session::Document& mDocument;
  Viewport& mViewport;
  session::TypePixels mPixels;
  std::map<int, session::Measured> mMeasured;
  Shared<Model> mModel;  ///< the model whose types were counted
};

}  // namespace velum::gui
