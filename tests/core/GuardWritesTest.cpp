#include "core/GuardWrites.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <span>
#include <string>

#include "TempFolder.h"
#include "core/ReplaceFile.h"

namespace velum {

namespace {

/// Runs it in a process of its own. @return the exit code; minus the signal that ended it
int inChild(const std::function<int()>& work) {
  pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

TEST(GuardWrites, AFileBeyondTheLimitIsAnErrorNotTheEnd) {
  TempFolder folder;
  EXPECT_EQ(inChild([&] {
              guardWrites();
              rlimit limit{10, 10};
              ::setrlimit(RLIMIT_FSIZE, &limit);
              int file = ::open((folder / "a").c_str(), O_WRONLY | O_CREAT, 0600);
              std::string text(100, 'x');
              return writeAll(file, std::as_bytes(std::span(text))) ? 1 : errno == EFBIG ? 0 : 2;
            }),
            0);
}

TEST(GuardWrites, AReaderThatHasGoneIsAnErrorNotTheEnd) {
  EXPECT_EQ(inChild([] {
              guardWrites();
              int ends[2];
              if (::pipe(ends) != 0) return 3;
              ::close(ends[0]);
              return ::write(ends[1], "x", 1) == 1 ? 1 : errno == EPIPE ? 0 : 2;
            }),
            0);
}

TEST(GuardWrites, NoFileTakesThePlaceOfAClosedStream) {
  TempFolder folder;
  EXPECT_EQ(inChild([&] {
              for (int stream : {0, 1, 2}) ::close(stream);
              guardWrites();
              return ::open((folder / "a").c_str(), O_WRONLY | O_CREAT, 0600) > 2 ? 0 : 1;
            }),
            0);
}

}  // namespace velum
