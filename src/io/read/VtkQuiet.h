#pragma once
#include <string>

#include "core/Task.h"

class vtkAlgorithm;
class vtkObject;

namespace velum::io {

/// Stops VTK from printing, and stores the first error that an algorithm reports.
class VtkQuiet {
 public:
  VtkQuiet();

  /// From now on the first error of `algorithm` is stored and `progress` is reported to (unless it is null); cancelling
  /// `progress` makes VTK stop.
  void listen(vtkAlgorithm& algorithm, Progress* progress);
  /// The first error, in one line; empty where there was none.
  const std::string& error() const { return mError; }

 private:
  static void observe(vtkObject* caller, unsigned long event, void* self, void* data);
  std::string mError;
  Progress* mProgress = nullptr;
};

}  // namespace velum::io
