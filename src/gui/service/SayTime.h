#pragma once
#include <QString>
#include <chrono>

namespace velum::gui {

/// A time as text: "today 14:32", "yesterday 9:05", else the date.
QString sayTime(std::chrono::system_clock::time_point when);

}  // namespace velum::gui
