#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/Common.h"
#include "app/Inputs.h"
#include "session/model/PictureCounter.h"
#include "session/model/TargetSolver.h"

namespace velum::app {

/// How many instances of types are wanted, in addition to the targets that a scene has.
struct TargetOptions {
  std::vector<std::string> counts, visibles;  ///< TYPE=N, TYPE=P%
  bool meets = false;                         ///< the scene's own targets are to be met
};

/// What "NAME=N" asks for, or "NAME=P%" where a percentage is allowed.
struct WantedNumber {
  std::string name;
  double number = 0.0;
  bool isPercent = false;
  double of(std::uint64_t total) const { return isPercent ? number / 100.0 * double(total) : number; }
};
/// Reads an option's text. @param form  how the text is to be written, for errors  @throw ArgumentError
WantedNumber wantedNumber(const char* option, const std::string& text, const char* form, bool mayBePercent);

void addTargets(CLI::App& verb, TargetOptions& options);

/// Puts the options into the scene's targets, and sets the shares of its cuts so that all targets are met as far as
/// they can be, with membranes at rest. Targets that are not met are said on stderr. Without such options nothing
/// changes: a scene shows what its cuts say, here as in the window.
/// @param counter  counts what a picture shows; null: there is no picture that could tell how many instances are
/// visible  @return nothing where none is to be met
std::optional<session::TargetsReport> settleTargets(session::Session& session, const TargetOptions& options,
                                                    double aspect, session::PictureCounter* counter);

/// A target as verbs report it.
Json targetJson(const session::TargetReport& target);

}  // namespace velum::app
