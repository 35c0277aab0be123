#pragma once
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace velum::bench {

/// What was measured: Markdown for people, printed as it comes, and figures for programs.
class Report {
 public:
  /// @param name  key of the figures that follow
  void section(const std::string& name, std::string_view title);
  void note(std::string_view text);
  void table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows);
  /// @param path  under the section, levels divided by '/'
  void figure(const std::string& path, const nlohmann::json& value);

  /// A document with the sections that were measured in the place of those of the same title; new ones at its end.
  std::string markdownInto(const std::string& old) const;
  const nlohmann::json& figures() const { return mFigures; }

 private:
  void add(const std::string& text);
  struct Chapter {
    std::string title, text;
  };
  std::vector<Chapter> mChapters;
  std::string mSection;
  nlohmann::json mFigures = nlohmann::json::object();
};

/// The middle one. @param values  not empty
double median(std::vector<double> values);
/// Processor time that this process has used on all of its threads, ms. A software driver draws with nothing else, so
/// unlike the time on the wall it stays the same on a machine that has other work too.
double processorMs();
/// Time since then, ms.
double msFrom(std::chrono::steady_clock::time_point start);
/// Milliseconds with as many digits as they deserve.
std::string formatMs(double ms);

}  // namespace velum::bench
