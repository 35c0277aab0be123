#pragma once
#include <QColor>
#include <QString>
#include <cstdint>
#include <vector>

#include "core/Model.h"
#include "core/Shared.h"
#include "gui/tool/Manipulator.h"
#include "gui/view/Viewport.h"
#include "scene/SceneFwd.h"

namespace velum::gui {

/// Colours and names of the types that the picture shows most, painted over the picture.
class Legend : public Manipulator {
 public:
  Legend(const session::Document& document, Viewport& viewport) : mDocument(document), mViewport(viewport) {}

  void setShown(bool shown);
  bool isShown() const { return mIsShown; }
  /// To be called when a picture is complete: counts which types it shows, if the legend is shown. @return true when
  /// the legend's rows have changed
  bool count();
  const std::vector<QString>& names() const { return mNames; }

  void paint(ViewPainter& over) const override;

 private:
  const session::Document& mDocument;
  Viewport& mViewport;
  bool mIsShown = false;
  std::vector<std::uint32_t> mTypes;  ///< The type of which most is seen comes first.
  std::vector<QString> mNames;
  Shared<Model> mModel;  ///< the model that the types belong to
};

}  // namespace velum::gui
