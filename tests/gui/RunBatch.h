#pragma once
#include <gtest/gtest.h>

#include <QStringList>
#include <cstdio>
#include <string>

namespace velum::gui {

/// Runs a program and fails the test where that fails. Not by QProcess: its child shares this program's memory until it
/// is another program, and the thread sanitizer then takes what it does for ours.
/// @param variable  one more for its environment, NAME=VALUE
inline void runProgram(const QStringList& words, const std::string& variable = {}) {
  std::string command = "VELUM_DRIVER_ERRORS=fatal " + variable, said;
  for (QString word : words) command += " '" + word.replace('\'', "'\\''").toStdString() + "'";
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  char buffer[4096];
  while (std::fgets(buffer, sizeof buffer, pipe)) said += buffer;
  EXPECT_EQ(::pclose(pipe), 0) << command << "\n" << said;
}

inline void runBatch(const QStringList& words) { runProgram(QStringList{VELUM_BATCH} + words); }

}  // namespace velum::gui
