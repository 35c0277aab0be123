// Every key of keys.json, pressed in the real window, does what the guide says. A key without a row in
// Keys::checks() fails.
#include <QJsonArray>

#include "KeysFixture.h"

namespace velum::gui {

TEST_F(Keys, EachDoesWhatTheGuideSays) {
  auto known = checks();
  known.merge(filmChecks());
  known.merge(markChecks());
  QJsonObject table = keyTable();
  ASSERT_GT(table.size(), 40);
  for (auto row = table.begin(); row != table.end(); ++row) {
    auto check = known.find(row.key());
    if (check == known.end()) {
      ADD_FAILURE() << row.key().toStdString() << " has keys that nobody has tried: give it a row in Keys::checks()";
      continue;
    }
    EXPECT_FALSE(row.value().toArray().isEmpty()) << row.key().toStdString();
    for (const auto& text : row.value().toArray()) {
      SCOPED_TRACE(row.key().toStdString() + " by " + text.toString().toStdString());
      renew();
      if (HasFatalFailure()) return;
      check->second(*this, QKeySequence(text.toString(), QKeySequence::PortableText));
    }
  }
}

TEST_F(Keys, AreThoseOfTheGuide) {
  // What the guide says of each command; %1: its keys.
  const std::map<QString, QString> kWords = {
      {"file.new", "| %1 | close what is open |"},
      {"file.open", "| %1 | open files |"},
      {"file.openFolder", "| %1 | open a folder |"},
      {"file.add", "| %1 | add labels or surfaces |"},
      {"file.saveScene", "| %1 | save the scene |"},
      {"file.saveSceneAs", "| %1 | save the scene as |"},
      {"file.savePicture", "| %1 | save a picture |"},
      {"file.cancel", "| %1 | stop a load or a picture |"},
      {"file.quit", "| %1 | quit |"},
      {"file.newWindow", "New window* (%1)"},
      {"edit.undo", "| %1 | undo |"},
      {"edit.redo", "| %1 | redo |"},
      {"edit.preferences", "Preferences* (%1)"},
      {"time.play", "%1 plays and pauses"},
      {"time.next", "step with %1 and "},
      {"time.previous", "and %1 (full stop and comma)"},
      {"film.timeline", "*Time > Timeline* (%1)"},
      {"film.start", "%1 goes to the beginning"},
      {"film.previousKey", "%1 and Ctrl+Right go to the key before"},
      {"film.nextKey", "Ctrl+Left and %1 go to the key before and to the next one"},
      {"film.record", "*Record* (%1)"},
      {"film.keyCamera", "*Key camera* (%1)"},
      {"help.guide", "%1 opens this guide"},
      {"help.find", "%1 finds by a few letters"},
      {"view.anterior", "| %1 | look from anterior |"},
      {"view.posterior", "| %1 | from posterior |"},
      {"view.left", "| %1 | from the left |"},
      {"view.right", "| %1 | from the right |"},
      {"view.superior", "| %1 | from superior |"},
      {"view.inferior", "| %1 | from inferior |"},
      {"view.oblique", "| %1 | obliquely |"},
      {"view.parallel", "| %1 | parallel or perspective |"},
      {"view.reset", "| %1 | see all of it from the front |"},
      {"layout.four", "four views (%1)"},
      {"layout.volume", "3D alone (%1)"},
      {"layout.beside", "3D and one section (%1)"},
      {"layout.section", ", one section (%1)"},
      {"sections.next", "forward is away from you | PgUp, %1, Shift: ten |"},
      {"sections.previous", "forward is away from you | %1, PgDown, Shift: ten |"},
      {"sections.window.soft-tissue", "*Soft tissue* (%1)"},
      {"sections.window.abdomen", "*Abdomen* (%1)"},
      {"sections.window.lung", "*Lung* (%1)"},
      {"sections.window.bone", "*Bone* (%1)"},
      {"sections.window.brain", "*Brain* (%1)"},
      {"sections.window.angio", "*Angiography* (%1)"},
      {"sections.window.suv-5", "*SUV 0 to 5* (%1)"},
      {"sections.window.suv-10", "*SUV 0 to 10* (%1)"},
      {"sections.window.suv-20", "*SUV 0 to 20* (%1)"},
      {"sections.window.type", "type it there: click it, or press %1"},
      {"look.showThis", "| %1 | show tissue by clicking it |"},
      {"cut.addPlane", "| %1 | add a cut |"},
      {"cut.addMembrane", "Add one with *Membrane* (%1)"},
      {"cut.alongView", "| %1 | cut along the view |"},
      {"cut.duplicate", "| %1 | duplicate the selected cut |"},
      {"cut.handles", "| %1 | put handles away, or show them again |"},
      {"cut.flip", "| %1 | flip the selected cut |"},
      {"cut.remove", "| %1 | remove the selected cut |"},
      {"extrusion.pull", "| %1 | pull structures out of a cut |"},
      {"extrusion.secondPlane", "| %1 | second plane across the selected cut |"},
      {"membrane.pin", "*Pin* (%1)"},
      {"membrane.push", "*Push sheet* (%1)"},
      {"membrane.pull", "*Pull sheet* (%1)"},
      {"mark.distance", "| %1 | measure a distance |"},
      {"mark.angle", "| %1 | measure an angle |"},
      {"mark.label", "| %1 | write a label |"},
      {"mark.name", "| %1 | name what is clicked |"},
      {"structure.find", "| %1 | find a structure |"},
      {"structure.toggle", "| %1 | hide or show the selected structure |"},
      {"structure.solo", "| %1 | show it alone |"},
      {"structure.showAll", "| %1 | show all structures |"},
      {"structure.goTo", "| %1 | go to it |"},
      {"structure.spare", "| %1 | keep it whole in the selected cut |"},
  };
  QString guide = QString::fromUtf8(bytesOf(VELUM_SOURCE_DIR "/docs/USER-GUIDE.md")).simplified();
  QJsonObject table = keyTable();
  for (auto row = table.begin(); row != table.end(); ++row) {
    QStringList keys;
    for (const auto& key : row.value().toArray()) keys << key.toString();
    auto words = kWords.find(row.key());
    ASSERT_TRUE(words != kWords.end()) << "what does the guide say of " << row.key().toStdString() << "?";
    QString wanted = words->second.arg(keys.join(", "));
    EXPECT_TRUE(guide.contains(wanted)) << "the guide does not say: " << wanted.toStdString();
  }
}

TEST_F(Keys, OfASectionMoveTheCrosshairOnTheScreen) {
  using scene::SectionKind;
  renew();
  mWindow->resize(1100, 700);
  QTest::qWait(20);
  for (auto kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal}) {
    SectionView& view = mWindow->views().section(kind);
    view.setFocus();
    double step = scene::sectionStep(scene());
    for (auto keys : {Qt::NoModifier, Qt::ShiftModifier})
      for (auto [key, right, up, near] : {std::tuple(Qt::Key_Right, 1.0, 0.0, 0.0),
                                          {Qt::Key_Left, -1.0, 0.0, 0.0},
                                          {Qt::Key_Up, 0.0, 1.0, 0.0},
                                          {Qt::Key_Down, 0.0, -1.0, 0.0},
                                          {Qt::Key_PageDown, 0.0, 0.0, 1.0},
                                          {Qt::Key_PageUp, 0.0, 0.0, -1.0}}) {
        QTest::keyClick(&view, Qt::Key_Home);
        glm::dvec3 before = scene().sections.crosshair;
        scene::SectionPlane plane = view.plane();
        QTest::keyClick(&view, key, keys);
        glm::dvec3 wanted = step * (right * plane.right + up * plane.up + near * plane.normal);
        if (keys) wanted *= 10.0;
        EXPECT_LT(glm::length(scene().sections.crosshair - before - wanted), 1e-6)
            << int(kind) << " key " << int(key) << (keys ? " with Shift" : "");
      }
  }
}

}  // namespace velum::gui
