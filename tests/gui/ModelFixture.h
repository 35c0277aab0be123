#pragma once
#include "WindowFixture.h"
#include "gui/model/ModelList.h"
#include "makeModel.h"
#include "patience.h"

namespace velum::gui {

/// A window with a small model of five types.
class ModelWindow : public Window {
 protected:
  void openModel(int types = 5) { open({.types = types, .instances = 400, .moleculeRadius = 20.0f}); }
  /// So many in so little room that most are hidden.
  void openDenseModel() { open({.types = 5, .atoms = 150, .instances = 3000, .moleculeRadius = 20.0f}); }
  void open(const ModelMaker& maker) {
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(maker.make());
    mWindow->resize(1100, 860);
    mWindow->showScene(scene, "made");
    drawSoon();
    ASSERT_TRUE(QTest::qWaitFor([&] { return list().isVisible(); }, kPatience));
  }
  ModelList& list() { return *child<ModelList>("modelList"); }
  void clickEye(int type, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, keys, list().cellOfType(type, ModelTree::Eye).center());
  }
  std::vector<bool> shown() { return session::visibleTypes(scene().model); }
  /// A place of the picture with an instance.
  std::optional<std::pair<QPoint, render::Pick>> findInstance() {
    for (int y = 10; y < viewport().height(); y += 7)
      for (int x = 10; x < viewport().width(); x += 7)
        if (auto pick = viewport().pickAt(QPointF(x, y)); pick && pick->hit && pick->type >= 0)
          return std::pair(QPoint(x, y), *pick);
    return std::nullopt;
  }
  bool hasPage() {
    auto& tabs = mWindow->tabs();
    for (int i = 0; i < tabs.count(); ++i)
      if (tabs.tabText(i) == "Model") return tabs.isTabVisible(i);
    return false;
  }
};

}  // namespace velum::gui
