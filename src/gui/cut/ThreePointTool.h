#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "gui/tool/Toolbox.h"
#include "session/document/Document.h"

namespace velum::gui {

/// Three clicks on what is seen, in any view, make a plane.
class ThreePointTool : public ClickTool {
  Q_OBJECT
 public:
  ThreePointTool(const session::Document& document, Toolbox& toolbox, QObject* parent);

  bool start() override;
  void stop() override { mPoints.clear(); }
  void click(const PointerEvent& event) override;
  bool hidesHandles() const override { return true; }
  QString hint() const override { return mHint; }
  void paint(ViewPainter& over) const override;

 signals:
  /// The third click has made a plane, and the tool has ended.
  void made(const velum::scene::Cut& cut);

 private:
  void say(const QString& text);
  QString whatIsNext() const;

  const session::Document& mDocument;
  Toolbox& mToolbox;
  std::vector<glm::dvec3> mPoints;
  QString mHint;
};

}  // namespace velum::gui
