#pragma once
#include <QObject>
#include <QString>

#include "gui/tool/Manipulator.h"

namespace velum::gui {

/// Something that is taken up to work with the pointer, and laid down again: at most one tool has the pointer, see
/// Toolbox. A tool makes edits of the document; the mathematics of these edits is in session.
class Tool : public QObject, public Manipulator {
  Q_OBJECT
 public:
  using QObject::QObject;

  bool isActive() const { return mIsActive; }
  /// Takes the tool up; called by the toolbox. @return false when there is nothing to work on; the tool has then told
  /// the user
  virtual bool start() { return true; }
  /// Lays the tool down; called by the toolbox. Work that is half done is given up.
  virtual void stop() {}
  /// The left button went down and up in one place, and nothing had been taken hold of.
  virtual void click(const PointerEvent&) {}
  /// While this tool is active the handles of cuts are neither shown nor taken.
  virtual bool hidesHandles() const { return false; }
  /// The picture marks what the extrusions of two planes share, see render::Frame::marksOverlaps.
  virtual bool marksOverlaps() const { return false; }
  /// What to do next, shown over a view; empty: nothing.
  virtual QString hint() const { return {}; }
  std::optional<Qt::CursorShape> hover(const ViewPoint&) override { return Qt::CrossCursor; }

 signals:
  void activeChanged(bool active);

 private:
  friend class Toolbox;
  bool mIsActive = false;
};

/// A tool whose clicks mean places of the world. In the 3D picture a drag still turns the camera, and handles can be
/// taken hold of; on a section, where a press would move the crosshair otherwise, the press counts as the click.
class ClickTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  bool press(const PointerEvent& event) override {
    if (!event.at.isOnSection() || event.button != Qt::LeftButton) return false;
    click(event);
    return true;
  }
  std::optional<Qt::CursorShape> hover(const ViewPoint& at) override {
    return at.isOnSection() ? std::optional(Qt::CrossCursor) : std::nullopt;
  }
};

}  // namespace velum::gui
