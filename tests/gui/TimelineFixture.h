#pragma once
#include <QContextMenuEvent>
#include <QElapsedTimer>
#include <QMenu>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Theme.h"
#include "gui/rows/FieldForm.h"
#include "gui/rows/FieldKey.h"
#include "gui/timeline/TimelineRoom.h"
#include "gui/view/TimeBar.h"
#include "scene/Navigate.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/FilmCommands.h"

namespace velum::gui {

/// A window with a phantom, whose film is made and worked by hand.
class Timelines : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 760);
    openPhantom();
    drawSoon();
  }
  session::Document& document() { return mWindow->document(); }
  const scene::Timeline& film() { return scene().timeline; }
  TimelineStrip& strip() { return *mWindow->findChild<TimelineStrip*>("timeline"); }
  TrackCanvas& canvas() { return strip().canvas(); }
  QWidget& tracks() { return *canvas().viewport(); }
  void trigger(const char* id) { mWindow->actions().find(id)->trigger(); }
  void key(const std::string& path, double time, const std::string& value) {
    session::editKey(document(), session::SetFilmKey{path, time, value});
  }
  /// Two numbers, three keys each.
  void makeFilm() {
    for (double time : {0.0, 2.0, 6.0}) {
      key("lighting.specular", time, time == 2.0 ? "2" : "1");
      key("lighting.ambient", time, time == 6.0 ? "0.8" : "0.2");
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return strip().isVisible(); }, kPatience));
    QTest::qWait(30);
  }
  QPoint placeOf(const KeyName& name) { return canvas().placeOf(name).value_or(QPointF(-1, -1)).toPoint(); }
  std::vector<double> timesOf(const std::string& path) {
    std::vector<double> times;
    if (const scene::Track* track = scene::findTrack(film(), path))
      for (const scene::Key& one : track->keys) times.push_back(one.time);
    return times;
  }
  /// Chooses an entry of the menu that opens next.
  void chooseNext(const QString& text) {
    QTimer::singleShot(100, [text] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      ASSERT_TRUE(menu);
      takeShot(*menu, "timeline-menu-" + text);
      for (QAction* entry : menu->actions())
        if (entry->text() == text) {
          menu->setActiveAction(entry);
          QTest::keyClick(menu, Qt::Key_Return);
          return;
        }
      menu->close();
      ADD_FAILURE() << "no entry " << text.toStdString();
    });
  }
  void openMenu(QWidget& widget, QPoint place) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, widget.mapToGlobal(place));
    QApplication::sendEvent(&widget, &event);
  }
  static constexpr const char* kShine = "lighting.specular";
  static constexpr const char* kAmbient = "lighting.ambient";
};

}  // namespace velum::gui
