#pragma once
#include "session/Session.h"
#include "velum/commands.h"
#include "velum/errors.h"
#include "velum/picture.h"
#include "velum/progress.h"
#include "velum/scene.h"

/// Session: what is open, and the work that goes on in the background. With the headers above a program opens files,
/// runs commands and draws pictures.
namespace velum {

using session::Session;

}  // namespace velum
