#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gpu/Allocation.h"
#include "gpu/GpuError.h"

namespace velum {

/// The numbers, from 1, of those allocations that are the first of their label.
inline std::vector<std::size_t> firstOfEach(const std::vector<std::string>& asked) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (std::find(asked.begin(), asked.begin() + std::ptrdiff_t(i), asked[i]) == asked.begin() + std::ptrdiff_t(i))
      numbers.push_back(i + 1);
  return numbers;
}

/// Runs something while allocations fail. @return the one line that was said; empty: it went well all the same
template <class Run>
std::string refusalOf(gpu::AllocationFault::Which which, std::size_t n, const Run& run) {
  gpu::AllocationFault fault(which, n);
  try {
    run();
    return {};
  } catch (const gpu::GpuError& error) {
    std::string words = error.what();
    EXPECT_EQ(words.find('\n'), std::string::npos) << words;
    EXPECT_NE(words.find("memory"), std::string::npos) << words;
    EXPECT_NE(words.find(": "), std::string::npos) << "it says what to do: " << words;
    return words;
  }
}

}  // namespace velum
