#include "Report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>

namespace velum::bench {

void Report::add(const std::string& text) {
  mChapters.back().text += text;
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void Report::section(const std::string& name, std::string_view title) {
  mSection = name;
  mChapters.push_back({std::string(title), {}});
  add(fmt::format("\n## {}\n\n", title));
}

void Report::note(std::string_view text) { add(fmt::format("{}\n\n", text)); }

std::string Report::markdownInto(const std::string& old) const {
  std::string out = old;
  for (const Chapter& chapter : mChapters) {
    std::size_t from = out.find(fmt::format("\n## {}\n", chapter.title));
    if (from == std::string::npos) from = out.size();
    std::size_t to = std::min(out.find("\n## ", from + 1), out.size());
    out.replace(from, to - from, chapter.text);
  }
  return out;
}

void Report::table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows) {
  auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const auto& cell : cells) text += fmt::format(" {} |", cell);
    return text + "\n";
  };
  std::string rule = "|---|";
  for (std::size_t i = 1; i < columns.size(); ++i) rule += "---:|";
  std::string text = line(columns) + rule + "\n";
  for (const auto& row : rows) text += line(row);
  add(text + "\n");
}

void Report::figure(const std::string& path, const nlohmann::json& value) {
  std::string pointer = "/" + mSection + (path.empty() ? "" : "/" + path);
  mFigures[nlohmann::json::json_pointer(pointer)] = value;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

double msFrom(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double processorMs() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  auto ms = [](const timeval& t) { return 1e3 * double(t.tv_sec) + 1e-3 * double(t.tv_usec); };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

std::string formatMs(double ms) { return ms < 10 ? fmt::format("{:.1f}", ms) : fmt::format("{:.0f}", ms); }

}  // namespace velum::bench
