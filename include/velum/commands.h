#pragma once
#include "session/command/Command.h"

/// What can be done, by name: docs/COMMANDS.md has all of them.
namespace velum {

using session::Call;
using session::Command;
using session::commandHelp;
using session::commands;
using session::parseCall;
using session::run;
using session::runScript;

}  // namespace velum
