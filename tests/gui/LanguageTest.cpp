// The window in German: all of its words, its numbers, its letters; and the list of words of tables below the window.
#include "gui/kit/Language.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QMenuBar>
#include <QTranslator>
#include <QXmlStreamReader>
#include <clocale>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "ModelFixture.h"
#include "gui/kit/NumberField.h"
#include "gui/kit/SideTabs.h"
#include "gui/kit/Words.h"
#include "gui/window/PreferencesDialog.h"
#include "gui/window/SavePictureDialog.h"
#include "scene/Finishes.h"
#include "scene/GreyWindows.h"
#include "scene/LitSpheres.h"
#include "scene/ModelLooks.h"
#include "scene/PlateStyles.h"
#include "scene/Presets.h"
#include "scene/json/FieldFacts.h"
#include "scene/json/Paths.h"
#include "scene/timeline/Tracks.h"
#include "session/command/Command.h"
#include "session/cut/NothingLeft.h"
#include "session/cut/ShapeTraits.h"
#include "session/document/Showcase.h"
#include "session/membrane/Advice.h"

namespace velum::gui {
namespace {

const std::filesystem::path kSource = VELUM_SOURCE_DIR;

/// Each text once, in order.
struct Words {
  std::vector<std::string> texts;
  void add(std::string_view text) {
    bool hasLetters = std::ranges::any_of(text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)); });
    if (hasLetters && std::ranges::find(texts, text) == texts.end()) texts.emplace_back(text);
  }
};

/// "Top left" of "topLeft".
std::string spelled(std::string name) {
  std::string text;
  for (char c : name) {
    if (std::isupper(static_cast<unsigned char>(c))) text += ' ';
    text += char(std::tolower(static_cast<unsigned char>(c)));
  }
  text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// Of forms that are made of a command's arguments: their names, meanings and choices.
void addArguments(const session::Command& command, Words& words) {
  static const std::regex choice("`([^`]+)`");
  for (const scene::FieldRow& row : command.arguments()) {
    words.add(spelled(row.path));
    words.add(row.doc);
    for (std::sregex_iterator i(row.type.begin(), row.type.end(), choice), end; i != end; ++i)
      words.add(spelled((*i)[1]));
  }
}

std::vector<std::string> tableWords() {
  Words words;
  for (const auto& one : scene::presets()) words.add(one.title);
  for (const auto& one : scene::plateStyles()) words.add(one.title), words.add(one.tip);
  for (const auto& one : scene::modelLooks()) words.add(one.title), words.add(one.tip);
  for (const auto& one : scene::finishes()) words.add(one.title), words.add(one.tip);
  for (const auto& one : scene::litSpheres()) words.add(one.title);
  for (const auto& one : scene::greyWindows()) words.add(one.title);
  for (const auto& one : session::showcases()) words.add(one.title), words.add(one.what);
  for (const auto& one : session::allShapes()) {
    words.add(one.title);
    if (one.menuText) words.add(one.menuText);
    for (const auto& size : one.sizes)
      if (size.tip) words.add(size.prefix), words.add(size.tip);
  }
  for (const CountKind& kind : kCountKinds)
    words.add(kind.adjective), words.add(kind.instances), words.add(kind.pixels);
  using Step = session::AdviceStep;
  for (Step step : {Step::DeepenReach, Step::MoveToKeep, Step::ProtectLess}) words.add(session::reasonOf(step));
  words.add(session::kNothingLeft);
  for (const char* path : {"timeline.orbitDeg", "volume.timeStep"}) words.add(scene::trackTitle({}, path));
  // Rows of forms that have no tip of their own.
  for (const char* field : {"inlayOpacity", "emphasis", "falloff", "look", "cloth.stretch", "cloth.bend",
                            "cloth.restoring", "cloth.particles", "cloth.finest"})
    words.add(scene::fieldFacts(std::string("cuts.N.membrane.") + field).meaning);
  for (const session::Command& command : session::commands()) {
    words.add(command.doc);
    if (command.doc.starts_with("Ready-made film")) addArguments(command, words);
  }
  return words.texts;
}

TEST(Language, TheListOfWordsOfTablesIsWhatTablesHave) {
  std::string now =
      "// Written by the test Language.TheListOfWordsOfTablesIsWhatTablesHave, read by lupdate alone: words that the\n"
      "// window takes out of tables below it, through wordsOf().\n"
      "inline constexpr const char* kTableWords[] = {\n";
  for (std::string text : tableWords()) {
    for (std::size_t at = 0; (at = text.find('"', at)) != text.npos; at += 2) text.insert(at, "\\");
    now += "    QT_TRANSLATE_NOOP(\"Words\", \"" + text + "\"),\n";
  }
  now += "};\n";
  std::filesystem::path path = kSource / "translations" / "TableWords.h";
  std::ifstream in(path, std::ios::binary);
  if (std::string((std::istreambuf_iterator<char>(in)), {}) == now) return;
  std::string beside = path.string() + ".new";
  std::ofstream(beside, std::ios::binary) << now;
  FAIL() << "words of tables have changed; accept them with\n  mv " << beside << " " << path.string()
         << "\nand translate them (docs/ADDING.md)";
}

/// What a translation says in English where it says something else, without the marks of letters.
QSet<QString> englishTexts() {
  QFile file(QString::fromStdString((kSource / "translations/velum_de.ts").string()));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  QSet<QString> english, german;
  QString source;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QStringLiteral("source")) source = xml.readElementText().remove('&');
    if (xml.name() == QStringLiteral("translation"))
      (source == xml.readElementText(QXmlStreamReader::IncludeChildElements).remove('&').trimmed() ? german : english)
          << source;
  }
  return english - german;
}

/// A window that was made in German, with a cell model or data.
class German : public ModelWindow {
 protected:
  void SetUp() override {
    mLocale = QLocale();
    speak("de");
    Window::SetUp();
  }
  void TearDown() override {
    Window::TearDown();
    for (auto* words : qApp->findChildren<QTranslator*>()) {
      QCoreApplication::removeTranslator(words);
      delete words;
    }
    QLocale::setDefault(mLocale);
  }

  /// No text that is seen, nor any tip or name, is one that has a translation.
  void expectNothingEnglish(const QWidget& owner) {
    static const QSet<QString> english = englishTexts();
    ASSERT_GT(english.size(), 1500);
    auto check = [&](QString text, const QObject& of) {
      text.remove('&');
      if (text.isEmpty()) return;
      ++mTexts;
      EXPECT_FALSE(english.contains(text))
          << of.metaObject()->className() << " " << of.objectName().toStdString() << ": " << text.toStdString();
    };
    for (const auto* action : owner.findChildren<QAction*>()) {
      check(action->text(), *action);
      check(action->toolTip(), *action);
      check(action->statusTip(), *action);
    }
    for (const auto* menu : owner.findChildren<QMenu*>()) check(menu->title(), *menu);
    for (const auto* widget : owner.findChildren<QWidget*>()) {
      check(widget->toolTip(), *widget);
      check(widget->accessibleName(), *widget);
      if (const auto* label = qobject_cast<const QLabel*>(widget)) check(label->text(), *label);
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) check(button->text(), *button);
      if (const auto* box = qobject_cast<const QComboBox*>(widget))
        for (int i = 0; i < box->count(); ++i) check(box->itemText(i), *box);
      if (const auto* tabs = qobject_cast<const QTabWidget*>(widget))
        for (int i = 0; i < tabs->count(); ++i) check(tabs->tabText(i), *tabs), check(tabs->tabToolTip(i), *tabs);
    }
  }
  /// No two of them have the same letter.
  void expectDifferentLetters(const QStringList& texts, const QString& where) {
    QMap<QString, QString> letters;
    for (const QString& text : texts) {
      QString letter = QKeySequence::mnemonic(text).toString();
      if (letter.isEmpty()) continue;
      EXPECT_FALSE(letters.contains(letter)) << (where + ": " + text + " and " + letters[letter]).toStdString();
      letters[letter] = text;
    }
  }
  void expectDifferentLetters(const QMenu& menu) {
    QStringList texts;
    for (const QAction* action : menu.actions()) texts << action->text();
    expectDifferentLetters(texts, menu.title());
  }

  int mTexts = 0;

 private:
  QLocale mLocale;
};

TEST_F(German, MenusAndPagesSayNothingInEnglish) {
  openPhantom();
  expectNothingEnglish(*mWindow);
  EXPECT_GT(mTexts, 1000);
  EXPECT_EQ(mWindow->menuBar()->actions()[0]->text(), "&Datei");
  EXPECT_EQ(child<SideTabs>("sideTabs")->tabText(0), "Look");
  // A script's names of pages are the English ones.
  EXPECT_TRUE(child<SideTabs>("sideTabs")->showPage("cuts"));
  PreferencesDialog preferences(mWindow->actions(), mWindow.get());
  expectNothingEnglish(preferences);
  SavePictureDialog picture({640, 480}, {640, 480}, scene(), mWindow.get());
  expectNothingEnglish(picture);
}

TEST_F(German, AModelSaysNothingInEnglish) {
  openModel();
  expectNothingEnglish(*mWindow);
  for (const auto* menu : mWindow->menuBar()->findChildren<QMenu*>()) expectDifferentLetters(*menu);
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
  EXPECT_EQ(stepText("Something new"), "Something new");
  for (const char* pattern : stepPatterns()) EXPECT_NE(wordsOf(pattern), pattern);
}

TEST(Language, OthersAreRefused) { EXPECT_THROW(speak("fr"), ArgumentError); }

}  // namespace
}  // namespace velum::gui
