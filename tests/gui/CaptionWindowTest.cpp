// Captions are added, typed and changed in the window.
#include <QComboBox>
#include <QListWidget>
#include <QPlainTextEdit>

#include "Shots.h"
#include "ShownPictures.h"
#include "WindowFixture.h"
#include "gui/kit/Widgets.h"

namespace velum::gui {
namespace {

class CaptionWindow : public Window {
 protected:
  void add(const char* words) {
    mWindow->actions().find("view.addCaption")->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return text().hasFocus(); }, kPatience)) << "what is typed goes there";
    QTest::keyClicks(&text(), words);
  }
  QPlainTextEdit& text() { return *child<QPlainTextEdit>("captionText"); }
  QListWidget& list() { return *child<QListWidget>("captionList"); }
  const std::vector<scene::Caption>& captions() { return scene().lettering.captions; }
};

TEST_F(CaptionWindow, OneActionAddsACaptionAndTypingSaysItsWords) {
  openPhantom();
  ASSERT_TRUE(settle());
  int pictures = shownPictures(viewport());
  QImage without = viewport().grab().toImage();
  add("The two spheres");
  ASSERT_EQ(captions().size(), 1u);
  EXPECT_EQ(captions()[0].text, "The two spheres");
  EXPECT_EQ(list().item(0)->text(), "The two spheres");
  EXPECT_TRUE(QTest::qWaitFor([&] { return text().visibleRegion().boundingRect() == text().rect(); }, kPatience))
      << "the page has scrolled there";
  EXPECT_NE(viewport().grab().toImage(), without);
  EXPECT_EQ(viewport().shownCount(), pictures) << "the picture below is the same";
  takeShot(*mWindow, "caption");
  mWindow->document().undo();
  EXPECT_EQ(captions()[0].text, "Caption") << "typing is one step";
  EXPECT_EQ(text().toPlainText(), "Caption");
  mWindow->document().undo();
  EXPECT_TRUE(captions().empty());
  EXPECT_FALSE(text().isVisible());
}

TEST_F(CaptionWindow, ControlsAreOfTheSelectedOne) {
  openPhantom();
  add("first");
  add("second");
  QTest::keyClick(&text(), Qt::Key_Return);
  QTest::keyClicks(&text(), "line");
  ASSERT_EQ(captions().size(), 2u);
  EXPECT_EQ(captions()[1].text, "second\nline");
  list().setCurrentRow(0);
  EXPECT_EQ(text().toPlainText(), "first");
  auto* place = child<QComboBox>("captionPlace");
  place->setCurrentIndex(1);
  emit place->activated(1);
  child<NumberRow>("captionSize")->spin()->setValue(200);
  child<NumberRow>("captionOpacity")->spin()->setValue(50);
  child<QCheckBox>("captionOwnColor")->click();
  EXPECT_EQ(captions()[0], (scene::Caption{.id = 1,
                                           .text = "first",
                                           .place = scene::CaptionPlace::Top,
                                           .size = 2,
                                           .color = glm::vec3(1),
                                           .opacity = 0.5}));
  EXPECT_EQ(captions()[1], (scene::Caption{.id = 2, .text = "second\nline"}));
  EXPECT_TRUE(child<ColorButton>("captionColor")->isVisible());
  child<QCheckBox>("captionOwnColor")->click();
  EXPECT_FALSE(captions()[0].color);
  EXPECT_FALSE(child<ColorButton>("captionColor")->isVisible());
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Delete);
  ASSERT_EQ(captions().size(), 1u);
  EXPECT_EQ(captions()[0].id, 2);
  EXPECT_EQ(text().toPlainText(), "second\nline") << "the neighbour takes its place";
  child<QPushButton>("captionRemove")->click();
  EXPECT_TRUE(captions().empty());
  mWindow->document().undo();
  EXPECT_EQ(text().toPlainText(), "second\nline");
}

TEST_F(CaptionWindow, WhatIsTypedCanBeQuotesAndNumbersAndUndoneInTheField) {
  openPhantom();
  add("\"42\"");
  EXPECT_EQ(captions()[0].text, "\"42\"");
  text().selectAll();
  QTest::keyClicks(&text(), "7");
  EXPECT_EQ(captions()[0].text, "7");
  QTest::keySequence(&text(), QKeySequence::Undo);
  EXPECT_NE(captions()[0].text, "7");
  EXPECT_EQ(text().toPlainText().toStdString(), captions()[0].text);
  EXPECT_FALSE(mWindow->actions().find("view.timeStamp")->isEnabled()) << "there is no time";
}

}  // namespace
}  // namespace velum::gui
