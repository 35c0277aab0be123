#pragma once
#include <string>
#include <vector>

#include "velum/gpu/Program.h"

namespace velum {

/// The variants of an entry point: those that its text asks about.
/// @param isWide  also those that differ in a line or two only
inline std::vector<gpu::Defines> shaderVariantsOf(const std::string& file, bool isWide) {
  std::string text = gpu::expandedShader(file);
  auto values = [&](const char* name, int count) { return text.find(name) == std::string::npos ? 1 : count; };
  std::vector<gpu::Defines> variants;
  for (int mode = 0; mode < values("MODE", 3); ++mode)
    for (int labels = 0; labels < values("LABELS", 3); ++labels)
      for (int color = 0; color < values("COLOR", isWide ? 3 : 2); ++color)
        for (int gradients = 0; gradients < values("GRADIENTS", isWide ? 2 : 1); ++gradients)
          for (int membranes = 0; membranes < values("cutsKeep", 2); ++membranes) {
            variants.push_back(
                {{"MODE", std::to_string(mode)}, {"LABELS", std::to_string(labels)}, {"COLOR", std::to_string(color)}});
            if (gradients) variants.back().push_back({"GRADIENTS", "1"});
            if (membranes) variants.back().push_back({"MEMBRANES", "1"});
          }
  return variants;
}

inline std::string textOf(const gpu::Defines& defines) {
  std::string text;
  for (const auto& [name, value] : defines) text += " " + name + "=" + value;
  return text;
}

}  // namespace velum
