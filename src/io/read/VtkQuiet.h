#pragma once
#include <string>

#include "core/Task.h"

class vtkAlgorithm;
class vtkObject;

namespace velum::io {

/// Keeps VTK from printing, and keeps the first error that an algorithm reports.
class VtkQuiet {
 public:
  VtkQuiet();

  /// From now on errors of `algorithm` are kept and `progress` is told; a cancel makes VTK stop.
  void listen(vtkAlgorithm& algorithm, Progress* progress);
  /// Empty, or the first error in one line.
  const std::string& error() const { return mError; }

 private:
  static void observe(vtkObject* caller, unsigned long event, void* self, void* data);
  std::string mError;
  Progress* mProgress = nullptr;
};

}  // namespace velum::io
