#pragma once
#include "session/Session.h"
#include "velum/commands.h"
#include "velum/errors.h"
#include "velum/picture.h"
#include "velum/progress.h"
#include "velum/scene.h"

/// Session: what is open, and goes on beside it. With the headers above: open files, run commands, draw pictures.
namespace velum {

using session::Session;

}  // namespace velum
