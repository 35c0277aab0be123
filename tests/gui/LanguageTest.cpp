// The list of words of tables below the window, for its other languages.
#include "gui/kit/Language.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "core/Counts.h"
#include "core/Error.h"
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
  std::filesystem::path path = std::filesystem::path(VELUM_SOURCE_DIR) / "translations" / "TableWords.h";
  std::ifstream in(path, std::ios::binary);
  if (std::string((std::istreambuf_iterator<char>(in)), {}) == now) return;
  std::string beside = path.string() + ".new";
  std::ofstream(beside, std::ios::binary) << now;
  FAIL() << "words of tables have changed; accept them with\n  mv " << beside << " " << path.string()
         << "\nand translate them (docs/ADDING.md)";
}

TEST(Language, OthersAreRefused) { EXPECT_THROW(speak("fr"), ArgumentError); }

}  // namespace
}  // namespace velum::gui
