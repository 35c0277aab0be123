#pragma once
#include <stdexcept>
#include <string>

namespace velum {

/// How a program of ours ends.
enum class ExitCode { Ok = 0, Usage = 1, Input = 2, Gpu = 3, CompareFailed = 4 };

/// Base of everything we throw. The message is one line: what, which value, what to do. It is made printable(), for it
/// may quote what a file or a path holds.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message);
  ExitCode exitCode() const { return mExitCode; }

 private:
  ExitCode mExitCode;
};

/// An argument of a public function, or of the command line, that cannot be used.
class ArgumentError : public Error {
 public:
  explicit ArgumentError(const std::string& message) : Error(ExitCode::Usage, message) {}
};

/// A file that is missing, damaged, or of a kind that we do not read.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::Input, message) {}
};

/// Thrown out of long work when the user asked it to stop. Not a failure: nothing is reported.
class Cancelled : public Error {
 public:
  Cancelled() : Error(ExitCode::Ok, "cancelled") {}
};

}  // namespace velum
