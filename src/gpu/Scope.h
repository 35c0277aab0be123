#pragma once
#include <map>
#include <string>
#include <string_view>

namespace velum::gpu {

/// Collects how long named passes take on the GPU, by timestamps.
class PassTimes {
 public:
  PassTimes() = default;
  ~PassTimes();
  PassTimes(const PassTimes&) = delete;
  PassTimes& operator=(const PassTimes&) = delete;
  /// Milliseconds that the passes took since the last call, summed by name. Waits for the GPU.
  std::map<std::string, double> collectMs();

 private:
  friend class Scope;
  std::multimap<std::string, std::pair<unsigned, unsigned>> mQueries;
};

/// Names a stretch of GL commands for debuggers and, where `times` is given, measures it.
class Scope {
 public:
  Scope(PassTimes* times, std::string_view name);
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  PassTimes* mTimes;
  std::string mName;
  unsigned mBegin = 0;
};

}  // namespace velum::gpu
