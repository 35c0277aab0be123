#include "io/video/FedProgram.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

#include "core/Error.h"
#include "core/Text.h"

namespace velum::io {

namespace {

/// How the program is started: its standard streams, its process group, and signals as they are by default.
class SpawnPlan {
 public:
  SpawnPlan(int input, int said) {
    ::posix_spawn_file_actions_init(&mStreams);
    ::posix_spawn_file_actions_adddup2(&mStreams, input, STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&mStreams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&mStreams, said, STDERR_FILENO);
    ::posix_spawnattr_init(&mState);
    ::posix_spawnattr_setflags(&mState, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    ::posix_spawnattr_setpgroup(&mState, 0);
    sigset_t all, none;
    ::sigfillset(&all);
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigdefault(&mState, &all);
    ::posix_spawnattr_setsigmask(&mState, &none);
  }
  ~SpawnPlan() {
    ::posix_spawn_file_actions_destroy(&mStreams);
    ::posix_spawnattr_destroy(&mState);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  /// @return 0, or why the program was not started
  int start(pid_t& child, const std::vector<std::string>& words) const {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // as C has it
    arguments.push_back(nullptr);
    return ::posix_spawnp(&child, arguments[0], &mStreams, &mState, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t mStreams;
  posix_spawnattr_t mState;
};

InputError notInstalled(const std::string& name, const std::string& package) {
  return InputError(fmt::format("{} is not installed: apt install {}", name, package));
}

/// @return the status with which a child ended; nothing good where there is no such child
int waitFor(pid_t child) {
  int status = -1;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return status;
}

}  // namespace

void expectProgram(const std::string& name, const std::string& package) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/bin:/usr/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + name).c_str(), X_OK) == 0) return;
  throw notInstalled(name, package);
}

FedProgram::FedProgram(const std::vector<std::string>& words, const std::string& package) {
  int ends[2] = {-1, -1};
  mSaid = ::memfd_create("said", MFD_CLOEXEC);
  int reason = mSaid < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ? errno : 0;
  mInput = ends[0];
  if (reason == 0) reason = SpawnPlan(ends[1], mSaid).start(mChild, words);
  if (ends[1] >= 0) ::close(ends[1]);
  if (reason == 0) return;
  mChild = -1;
  closeInput();
  if (mSaid >= 0) ::close(mSaid);
  if (reason == ENOENT) throw notInstalled(words[0], package);
  throw InputError(fmt::format("{}: cannot be started ({})", words[0], std::strerror(reason)));
}

FedProgram::~FedProgram() {
  closeInput();
  if (mChild > 0) {
    ::kill(mChild, SIGKILL);
    waitFor(mChild);
  }
  ::close(mSaid);
}

void FedProgram::closeInput() {
  if (mInput >= 0) ::close(std::exchange(mInput, -1));
}

bool FedProgram::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    ssize_t sent = ::send(mInput, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes = bytes.subspan(std::size_t(sent));
  }
  return true;
}

bool FedProgram::end() {
  closeInput();
  return mChild > 0 && waitFor(std::exchange(mChild, -1)) == 0;
}

std::string FedProgram::lastLine() const {
  std::string said(1 << 16, '\0');
  off_t size = ::lseek(mSaid, 0, SEEK_END);
  ssize_t count = ::pread(mSaid, said.data(), said.size(), std::max<off_t>(0, size - off_t(said.size())));
  said.resize(std::size_t(std::max<ssize_t>(count, 0)));
  std::string last;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);)
    if (!trimmed(line).empty()) last = trimmed(line);
  return last;
}

}  // namespace velum::io
