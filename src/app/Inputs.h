#pragma once
#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/Common.h"
#include "core/Error.h"
#include "core/Fields.h"
#include "scene/SceneFwd.h"
#include "scene/Source.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/picture/Picture.h"

/// What verbs open, and the options for it: each option stands for a command that is run once the data has been read.
namespace velum::app {

/// The value that an option names. @throw ArgumentError that lists what there is
template <class Enum>
Enum named(const char* option, const std::string& name) {
  if (auto value = enumValue<Enum>(name)) return *value;
  throw ArgumentError(fmt::format("{} {}: not one of {}", option, name, fmt::join(EnumNames<Enum>::kNames, ", ")));
}

/// The options of verbs that open data.
struct InputOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> sets;  ///< path=value
  std::string series, preset, finish, transfer, view, labels;
  int level = scene::kFittingLevel;
  bool hidesTable = false, makesSurface = false;
  std::vector<double> spacing;
  std::optional<bool> smooth;
  std::string raw;  ///< "XxYxZ:type[:be][:+header]"
};

void addInput(CLI::App& verb, InputOptions& input, bool withScene);

/// The options of verbs that write over pictures.
struct LetteringOptions {
  std::vector<std::string> captions;
  std::string style;
  bool legend = false, scaleBar = false, timeStamp = false, names = false;
  double pageWidth = 0.0;  ///< mm; 0: as the scene says
};
void addLettering(CLI::App& verb, LetteringOptions& lettering);
/// Runs the commands that the options stand for.
void writeOver(session::Session& session, const LetteringOptions& lettering);

/// The options of verbs that draw pictures.
struct DrawnOptions {
  std::string size = "1280x720", section;
  session::PictureOptions picture;  ///< but for its size; layers and transparent are the verbs' own options
};
void addDrawn(CLI::App& verb, DrawnOptions& drawn);
/// With the size. @throw ArgumentError
session::PictureOptions pictureOf(const DrawnOptions& drawn);
/// None: the 3D picture. @throw ArgumentError for what is no section, and for layers of one
std::optional<scene::SectionKind> sectionOf(const DrawnOptions& drawn);

/// The first input's source, with the reading options applied.
scene::Source firstSource(const InputOptions& input);
/// Opens all inputs in a session and runs the commands that the options stand for: preset, transfer function, surface,
/// table, view, finish and --set, in this order; then lets all that grows come to rest. Shows progress on a terminal.
/// @param aspect  width by height of the picture in which the camera is to show everything that is opened
void openInputs(session::Session& session, const InputOptions& input, double aspect);
/// The same of what is open already: all but the opening. @param hasCamera  the scene has a camera of its own, which
/// stays where no view is asked for
void applyInput(session::Session& session, const InputOptions& input, double aspect, bool hasCamera);
/// Pairs: the words of a command that an error may begin with, and the option of the command line that they stand for.
using Words = std::vector<std::pair<std::string, std::string>>;
/// Does some work. @throw what it throws; an ArgumentError names the option in place of the command's own words
void withOptionsNamed(const Words& options, const std::function<void()>& work);
/// Runs a command so, and prints, as warnings, what the command tells.
void run(session::Session& session, const session::Call& call, const Words& options = {});

}  // namespace velum::app
