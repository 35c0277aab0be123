#pragma once
#include <optional>
#include <string>

#include "session/film/FrameNames.h"

/// Which part of a work a process has that was started as one of many.
namespace velum::app {

struct TaskPart {
  session::Part part;
  std::string task;  ///< "SLURM_ARRAY_TASK_ID is 5": why it is this part; empty where the command line says so
};

/// The part of --part; where that is empty, in a task of a Slurm array the task's, else the whole. The array's indices
/// in order are the parts. @throw ArgumentError for a text that is no part, and where indices are left out of the array
TaskPart taskPart(const std::string& option);

}  // namespace velum::app
