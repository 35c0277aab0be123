#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/Common.h"
#include "app/Inputs.h"
#include "session/model/PictureCounter.h"
#include "session/model/TargetSolver.h"

namespace velum::app {

/// How many instances of types are wanted, beside what a scene says.
struct TargetOptions {
  std::vector<std::string> counts, visibles;  ///< TYPE=N
};

/// What "NAME=N" or, where it may be so, "NAME=P%" asks for.
struct WantedNumber {
  std::string name;
  double number = 0.0;
  bool isPercent = false;
  double of(std::uint64_t total) const { return isPercent ? number / 100.0 * double(total) : number; }
};
/// @param form  how it is to be written, for errors  @throw ArgumentError
WantedNumber wantedNumber(const char* option, const std::string& text, const char* form, bool mayBePercent);

void addTargets(CLI::App& verb, TargetOptions& options);

/// Puts the options into the scene's targets, and sets the shares of its cuts so that all are met as far as they can
/// be, membranes at rest; nothing where there are no targets. What is not met is said on stderr.
/// @param counter  null: there is no picture, so that none can say how many show
std::optional<session::TargetsReport> settleTargets(session::Session& session, const TargetOptions& options,
                                                    double aspect, session::PictureCounter* counter);

/// A target as verbs report it.
Json targetJson(const session::TargetReport& target);

}  // namespace velum::app
