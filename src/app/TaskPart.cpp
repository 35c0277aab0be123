#include "app/TaskPart.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "core/Error.h"

namespace velum::app {

namespace {

constexpr const char* kTaskId = "SLURM_ARRAY_TASK_ID";

std::optional<int> numberFrom(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text) return std::nullopt;
  std::string_view view = text;
  int number = 0;
  auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), number);
  if (error != std::errc() || end != view.data() + view.size()) return std::nullopt;
  return number;
}

std::optional<TaskPart> partOfSlurm() {
  auto id = numberFrom(kTaskId), first = numberFrom("SLURM_ARRAY_TASK_MIN"),
       count = numberFrom("SLURM_ARRAY_TASK_COUNT");
  if (!id || !first || !count) return std::nullopt;
  int step = std::max(1, numberFrom("SLURM_ARRAY_TASK_STEP").value_or(1));
  int number = (*id - *first) / step + 1, last = numberFrom("SLURM_ARRAY_TASK_MAX").value_or(*id);
  bool isWhole = (last - *first) / step + 1 <= *count;
  if (number < 1 || number > *count || (*id - *first) % step != 0 || !isWhole)
    throw ArgumentError(fmt::format(
        "task {} of an array of {} tasks from {} is no part of its own where indices are left out; give "
        "--part, as --part $SLURM_ARRAY_TASK_ID/60 for tasks 1 to 60, or --part 1/1 where each task has data "
        "of its own",
        *id, *count, *first));
  return TaskPart{{number, *count}, fmt::format("{} is {}", kTaskId, *id)};
}

}  // namespace

TaskPart taskPart(const std::string& option) {
  if (!option.empty()) return {session::parsePart(option), {}};
  return partOfSlurm().value_or(TaskPart());
}

}  // namespace velum::app
