#include "Child.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace velum::bench {

namespace {

/// In the child: replaces this process. Never returns.
[[noreturn]] void become(const std::vector<std::string>& arguments,
                         const std::vector<std::pair<std::string, std::string>>& environment, int output) {
  dup2(output, STDOUT_FILENO);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<std::string> words{"velum-bench", "--child"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv("/proc/self/exe", pointers.data());
  _exit(127);
}

}  // namespace

nlohmann::json runChild(const std::vector<std::string>& arguments,
                        const std::vector<std::pair<std::string, std::string>>& environment) {
  int pipes[2];
  std::fflush(nullptr);
  if (pipe(pipes) != 0) return nullptr;
  pid_t child = fork();
  if (child < 0) return nullptr;
  if (child == 0) become(arguments, environment, pipes[1]);
  close(pipes[1]);
  std::string text;
  char buffer[4096];
  for (ssize_t n; (n = read(pipes[0], buffer, sizeof buffer)) > 0;) text.append(buffer, std::size_t(n));
  close(pipes[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return nullptr;
  auto figures = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  return figures.is_discarded() ? nullptr : figures;
}

int childMain(const std::vector<std::string>& arguments) {
  nlohmann::json figures;
  if (arguments.size() == 3 && arguments[0] == "read")
    figures = childRead(arguments[1], arguments[2]);
  else if (arguments.size() == 2 && arguments[0] == "first-picture")
    figures = childFirstPicture(std::stoi(arguments[1]));
  else if (arguments.size() == 2 && arguments[0] == "answers")
    figures = childAnswers(std::stoi(arguments[1]));
  else
    return 1;
  fmt::print("{}\n", figures.dump());
  return 0;
}

}  // namespace velum::bench
