#pragma once
#include <sys/types.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace velum::io {

/// Checks, before there is work for it, that a program can be found by PATH. @param package  Debian's package that has
/// it
/// @throw InputError that names the package
void expectProgram(const std::string& name, const std::string& package);

/// A program of others that reads its standard input from us. What it says on its standard error is kept; its standard
/// output goes nowhere. The program is found by PATH, without a shell, and is in a process group of its own: what a
/// terminal sends to us when a user presses Ctrl+C does not end it. One thread at a time.
class FedProgram {
 public:
  /// Starts the program. @param words  its name and its arguments  @param package  Debian's package that has it
  /// @throw InputError when it is not installed, or cannot be started
  FedProgram(const std::vector<std::string>& words, const std::string& package);
  /// A program that has not ended is killed.
  ~FedProgram();
  FedProgram(const FedProgram&) = delete;
  FedProgram& operator=(const FedProgram&) = delete;

  /// Waits until the program has room for all of it. @return false where the program reads no more; no signal comes
  bool write(std::span<const std::byte> bytes);
  /// Says that nothing more comes, and waits for the program's end. @return true where it ended well
  bool end();
  /// The last line that the program has said on its standard error; empty: none.
  std::string lastLine() const;

 private:
  void closeInput();

  pid_t mChild = -1;  ///< -1: has ended
  int mInput = -1;    ///< our end of its standard input, a socket: a write to it need not send SIGPIPE
  int mSaid = -1;     ///< a file in memory
};

}  // namespace velum::io
