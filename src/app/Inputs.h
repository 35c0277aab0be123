#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/Common.h"
#include "scene/SceneFwd.h"
#include "session/Session.h"
#include "session/command/Command.h"

/// What verbs open, and with which options: each option is a command that is run when the data is there.
namespace velum::app {

/// What verbs that open data take.
struct InputOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> sets;  ///< path=value
  std::string series, preset, finish, transfer, view, labels;
  bool hidesTable = false, makesSurface = false;
  std::vector<double> spacing;
  std::optional<bool> smooth;
  std::string raw;  ///< "XxYxZ:type[:be][:+header]"
};

void addInput(CLI::App& verb, InputOptions& input, bool withScene);
/// The first input's source, with the reading options applied.
scene::Source firstSource(const InputOptions& input);
/// Opens all inputs in a session and runs the commands that the options stand for: preset, transfer function, surface,
/// table, view, finish and --set, in this order; then lets all that grows come to rest. Shows progress on a terminal.
/// @param aspect  of the picture that is to hold what is opened
void openInputs(session::Session& session, const InputOptions& input, double aspect);
/// With which words of a command an error begins, and the option that was meant.
using Words = std::vector<std::pair<std::string, std::string>>;
/// Runs a command and says what there is to say of it. @throw as session::run(), in the words of the options
void run(session::Session& session, const session::Call& call, Words options = {});

}  // namespace velum::app
