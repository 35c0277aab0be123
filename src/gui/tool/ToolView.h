#pragma once
#include <QWidget>
#include <optional>

#include "render/Renderer.h"
#include "render/section/SectionImage.h"
#include "session/ViewSpace.h"

namespace velum::gui {

/// A view of the scene as tools know it: what its pixels mean, and what is seen there. The 3D picture and each section
/// are such views.
class ToolView {
 public:
  virtual ~ToolView() = default;
  virtual QWidget& widget() = 0;
  /// What the widget's (logical) pixels mean in the world.
  virtual session::ViewSpace space() const = 0;
  /// What is seen at a place of the widget; nothing while there is no picture.
  virtual std::optional<render::Pick> pickAt(QPointF place) = 0;
  /// The handles of cuts, and of what belongs to cuts, are shown over this view and can be taken hold of.
  virtual bool showsHandles() const = 0;
  /// The cursor where nothing can be taken hold of and no tool has the pointer.
  virtual Qt::CursorShape restCursor() const = 0;
  /// A section as its view shows it in full.
  struct ShownSection {
    const render::SectionImage& image;
    scene::SectionPlane plane;  ///< in pixels of the screen
    int number = 0;             ///< another one for each image
    bool isMoving = false;      ///< the section has moved a moment ago: another image may come soon
  };
  /// Nothing in the 3D picture, and while a section is drawn or coarse.
  virtual std::optional<ShownSection> shownSection() const { return std::nullopt; }
};

}  // namespace velum::gui
