// The window in German: all of its words, its numbers, its letters; what it is told by the libraries below it.
#include <QAbstractItemView>
#include <clocale>

#include "GermanFixture.h"
#include "gui/kit/CoreWords.h"
#include "gui/kit/CutTitle.h"
#include "gui/kit/NumberField.h"
#include "gui/kit/Words.h"
#include "gui/window/CarryDialog.h"
#include "gui/window/ExportStructuresDialog.h"
#include "gui/window/PreferencesDialog.h"
#include "gui/window/RawDialog.h"
#include "gui/window/ReadyFilmDialog.h"
#include "gui/window/SaveFilmDialog.h"
#include "gui/window/SavePictureDialog.h"
#include "gui/window/SeriesDialog.h"
#include "gui/window/VoxelSizeDialog.h"
#include "scene/json/Paths.h"
#include "session/Session.h"
#include "session/command/Command.h"

namespace velum::gui {
namespace {

TEST_F(German, MenusAndPagesSayNothingInEnglish) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  expectGermanPages("data");
  EXPECT_GT(mTexts, 1000);
  EXPECT_EQ(mWindow->menuBar()->actions()[0]->text(), "&Datei");
  // A script's names of pages are the English ones.
  EXPECT_TRUE(child<SideTabs>("sideTabs")->showPage("cuts"));
  for (const char* id : {"cut.addPlane", "cut.addBox", "cut.addSphere", "cut.addCone", "cut.addMembrane"}) {
    mWindow->actions().find(id)->trigger();
    ASSERT_TRUE(waitForJob());
    ASSERT_TRUE(child<SideTabs>("sideTabs")->showPage("cuts"));
    QTest::qWait(30);
    expectGermanAndWhole(*mWindow, id);
  }
  mWindow->actions().find("film.timeline")->trigger();
  for (const char* line : {"mark.add distance [[1,1,1],[4,1,1]]", "mark.add area [[1,1,1],[4,1,1],[4,4,1]]",
                           "mark.add label [[1,1,1]] text=Kern", "mark.add profile [[1,1,1],[9,1,1]]"}) {
    Progress progress;
    session::run(mWindow->session(), session::parseCall(line), progress);
  }
  expectGermanPages("cut");
}

TEST_F(German, AModelSaysNothingInEnglish) {
  openModel();
  mWindow->actions().find("cut.addPlane")->trigger();
  ASSERT_TRUE(settle());
  expectGermanPages("model");
  for (const auto* menu : mWindow->menuBar()->findChildren<QMenu*>()) expectDifferentLetters(*menu);
}

TEST_F(German, DialogsSayNothingInEnglish) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  mWindow->actions().find("cut.addPlane")->trigger();
  QWidget* parent = mWindow.get();
  PreferencesDialog preferences(mWindow->actions(), parent);
  expectGermanDialog(preferences, "preferences");
  auto* tabs = preferences.findChild<QTabWidget*>();
  for (int i = 1; i < tabs->count(); ++i) {
    tabs->setCurrentIndex(i);
    expectGermanDialog(preferences, "preferences-" + QString::number(i));
  }
  SavePictureDialog picture({640, 480}, {640, 480}, scene(), parent);
  expectGermanDialog(picture, "picture");
  SaveFilmDialog film({640, 480}, scene(), "turn", parent);
  expectGermanDialog(film, "film");
  for (std::size_t i = 0; i < std::size(EnumNames<session::ReadyFilm>::kNames); ++i) {
    ReadyFilmDialog ready(scene(), session::ReadyFilm(i), 0.0, parent);
    expectGermanDialog(ready, "ready-" + QString::number(i));
  }
  CarryDialog carry(scene(), path(""), parent);
  expectGermanDialog(carry, "carry");
  VoxelSizeDialog size("phantom", parent);
  expectGermanDialog(size, "size");
  ExportStructuresDialog structures(scene(), {1}, parent);
  expectGermanDialog(structures, "structures");
  session::Series one{.description = "T1", .modality = "MR"};
  SeriesDialog series({one, one}, path(""), parent);
  expectGermanDialog(series, "series");
  QFile raw(path("plain.raw"));
  ASSERT_TRUE(raw.open(QIODevice::WriteOnly));
  raw.write(QByteArray(32 * 32 * 32, '\7'));
  raw.close();
  scene::Source source;
  source.path = raw.fileName().toStdString();
  RawDialog rawDialog(source, parent);
  expectGermanDialog(rawDialog, "raw");
}

TEST_F(German, MenusOfTheRightButtonSayNothingInEnglish) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  mWindow->views().setLayout(scene::Layout::FourUp);
  mWindow->actions().find("cut.addPlane")->trigger();
  Progress progress;
  session::run(mWindow->session(), session::parseCall("mark.add distance [[1,1,1],[4,1,1]]"), progress);
  auto expectMenuOfList = [&](const char* page, const char* name) {
    mWindow->tabs().showPage(page);
    QTest::qWait(30);
    auto* list = child<QAbstractItemView>(name);
    ASSERT_TRUE(list) << name;
    list->setCurrentIndex(list->model()->index(0, 0));
    QPoint first = list->visualRect(list->currentIndex()).center();
    expectGermanMenu(*list->viewport(), first, name);
  };
  expectMenuOfList("Structures", "structureList");
  expectMenuOfList("Marks", "markList");
  auto* section = child<QWidget>("section.axial");
  ASSERT_TRUE(section);
  expectGermanMenu(*section, section->rect().center(), "section", QContextMenuEvent::Keyboard);
}

TEST_F(German, MenusOfAModelSayNothingInEnglish) {
  openModel();
  mWindow->actions().find("cut.addPlane")->trigger();
  expectGermanMenu(*list().viewport(), list().cellOfType(0, ModelTree::Name).center(), "type");
}

TEST_F(German, LettersOfMenusAndDialogsDiffer) {
  openPhantom();
  QStringList bar;
  for (const QAction* action : mWindow->menuBar()->actions()) bar << action->text();
  for (const auto* button : mWindow->findChildren<QAbstractButton*>())
    if (button->window() == mWindow.get()) bar << button->text();
  expectDifferentLetters(bar, "the window");
  for (const QAction* action : mWindow->menuBar()->actions()) {
    expectDifferentLetters(*action->menu());
    for (const QAction* entry : action->menu()->actions())
      if (entry->menu()) expectDifferentLetters(*entry->menu());
  }
  PreferencesDialog preferences(mWindow->actions(), mWindow.get());
  QStringList texts;
  for (const auto* button : preferences.findChildren<QAbstractButton*>()) texts << button->text();
  for (const auto* label : preferences.findChildren<QLabel*>())
    if (label->buddy()) texts << label->text();
  for (const auto* tabs : preferences.findChildren<QTabWidget*>())
    for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i);
  expectDifferentLetters(texts, "preferences");
}

TEST_F(German, NumbersHaveACommaAndAreTypedWithEither) {
  openPhantom();
  NumberField field;
  field.setDecimals(2);
  field.setRange(0, 100);
  field.setSuffix(" %");
  for (const char* typed : {"12.5", "12,5", "12,5 %"}) {
    field.setValue(1);
    field.enter(typed);
    EXPECT_EQ(field.value(), 12.5) << typed;
    EXPECT_EQ(field.text(), "12,50 %");
  }
  EXPECT_EQ(localNumber("1.5 mm, -0.25"), "1,5 mm, -0,25");
  EXPECT_EQ(std::string(std::localeconv()->decimal_point), ".");
  EXPECT_EQ(scene::getField(scene(), "lighting.ambient").find(','), std::string::npos);
}

TEST_F(German, OneAndSeveralDiffer) {
  auto say = [](const char* context, const char* text, int n) {
    return QCoreApplication::translate(context, text, nullptr, n);
  };
  EXPECT_EQ(say("velum::gui::EqualizerBar", "%n cuts", 1), "1 Schnitt");
  EXPECT_EQ(say("velum::gui::EqualizerBar", "%n cuts", 2), "2 Schnitte");
  EXPECT_EQ(say("velum::gui::StatusLine", "%n structure(s)", 1), "1 Struktur");
  EXPECT_EQ(say("velum::gui::StatusLine", "%n structure(s)", 0), "0 Strukturen");
}

TEST_F(German, StepsOfTheHistoryAreSaidInGerman) {
  EXPECT_EQ(stepText("Add cut"), QString::fromUtf8("Schnitt hinzufügen"));
  EXPECT_EQ(stepText("Hide aorta"), "aorta ausblenden");
  EXPECT_EQ(stepText("Hide label"), "label ausblenden") << "a structure's name";
  EXPECT_EQ(stepText("Hide 3 structures"), "3 Strukturen ausblenden");
  EXPECT_EQ(stepText("Set number of capsid"), "Anzahl von capsid setzen");
  EXPECT_EQ(stepText("Something new"), "Something new");
  for (const char* pattern : stepPatterns()) EXPECT_NE(wordsOf(pattern), pattern);
}

TEST_F(German, NamesThatTheProgramGivesToCutsAreGermanWhereTheyAreShown) {
  auto title = [](const char* name) {
    scene::Cut cut;
    cut.name = name;
    return cutTitle(cut, 0).toStdString();
  };
  EXPECT_EQ(title(""), "Schnitt 1");
  EXPECT_EQ(title("Plane 12"), "Ebene 12");
  EXPECT_EQ(title("Membrane"), "Membran");
  EXPECT_EQ(title("Plane 1 copy copy"), "Kopie von Kopie von Ebene 1");
  EXPECT_EQ(title("Way to capsid"), "Weg zu capsid");
  for (const char* own : {"Plane of the heart", "my Plane 1", "Box set", "copy", "3"}) EXPECT_EQ(title(own), own);
}

/// What a pattern says with something in its places, by the rules of Qt's translations.
QString withValues(const char* text, const QStringList& values) {
  QString said = QString::fromUtf8(text);
  for (int i = 0; i < values.size(); ++i) said.replace("%" + QString::number(i + 1), values[i]);
  return said;
}

TEST_F(German, EachMessageOfTheLibrariesIsFoundAgain) {
  const QStringList values{"21", "32", "43", "54", "65", "76", "87", "98", "19"};
  for (const char* pattern : corePatterns()) {
    QString german = QCoreApplication::translate("Core", pattern);
    EXPECT_EQ(inWords(withValues(pattern, values)), withValues(german.toUtf8(), values)) << pattern;
  }
}

TEST_F(German, MessagesAreGermanWithTheirNamesAndACommaInNumbers) {
  auto expectSaid = [](const char* english, const char* german) {
    EXPECT_EQ(inWords(english).toStdString(), german) << english;
  };
  expectSaid("/data/a b.nii: is cut off: 12 bytes of data are missing",
             "/data/a b.nii: ist abgeschnitten: 12 Bytes Daten fehlen");
  expectSaid(
      "the driver has no memory for light extinction (64 x 32 x 16, 12 MiB): close other programs that draw, make "
      "the picture smaller, or lower VELUM_GPU_MEMORY_MB",
      "der Treiber hat keinen Speicher für Abschwächung des Lichts (64 x 32 x 16, 12 MiB): andere Programme "
      "schließen, die zeichnen, das Bild kleiner machen oder VELUM_GPU_MEMORY_MB senken");
  expectSaid("a: cannot be written (No space left on device); check the folder and the free space",
             "a: kann nicht geschrieben werden (kein Platz mehr auf dem Datenträger); Ordner und freien Platz prüfen");
  expectSaid("planes are not evenly apart; each was put on the nearest of 1.5 mm, by up to 0.25 mm",
             "die Ebenen haben ungleiche Abstände; jede wurde auf die nächste von 1,5 mm gelegt, um bis zu 0,25 mm "
             "verschoben");
  expectSaid("12 of 30 capsid drawn, not 20: there are no more",
             "12 von 30 capsid gezeichnet, nicht 20: mehr gibt es nicht");
  expectSaid("40 % of capsid is hidden: 30 % by blood, 5 % by cell wall, the rest by 3 more",
             "40 % von capsid ist verdeckt: 30 % durch blood, 5 % durch cell wall, der Rest durch 3 weitere");
  expectSaid("lit sphere wax: /x/y.png: is damaged; it looks like porcelain",
             "Lichtkugel wax: /x/y.png: is damaged; sie sieht aus wie Porzellan");
  expectSaid("a.nrrd: the encoding 'zstd' is not supported; raw, gzip and ascii are",
             "a.nrrd: die Kodierung „zstd“ wird nicht unterstützt; raw, gzip und ascii schon");
  expectSaid("Something that nobody knows", "Something that nobody knows");
  expectSaid("no finish 'nope' (is 'none' meant?); there are none, plate",
             "Ausführung „nope“ gibt es nicht (ist „none“ gemeint?); es gibt: none, plate");
  expectSaid("this display (xcb) gives windows no OpenGL (libraries say: MESA: failed (see: log))",
             "diese Anzeige (xcb) gibt Fenstern kein OpenGL (Bibliotheken melden: MESA: failed (see: log))");
  // Two of a line.
  expectSaid("Reading voxels\nReading labels", "Voxel werden gelesen\nLabels werden gelesen");
}

}  // namespace
}  // namespace velum::gui
