#pragma once
#include "session/command/Command.h"

/// The commands by which a session is changed, each by its name: docs/COMMANDS.md lists all of them.
namespace velum {

using session::Call;
using session::Command;
using session::commandHelp;
using session::commands;
using session::parseCall;
using session::run;
using session::runScript;

}  // namespace velum
