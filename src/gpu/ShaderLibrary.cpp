#include "gpu/ShaderLibrary.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "gpu/GpuError.h"
#include "gpu/ShaderFiles.h"

namespace velum::gpu {

namespace {

std::string readShader(const std::string& file) {
  if (const char* folder = std::getenv("VELUM_SHADER_DIR")) {
    std::ifstream in(std::string(folder) + "/" + file);
    if (!in) throw GpuError(fmt::format("the shader {}/{} is missing", folder, file));
    return {std::istreambuf_iterator<char>(in), {}};
  }
  for (unsigned i = 0; i < kShaderFileCount; ++i)
    if (file == kShaderFiles[i].path) return kShaderFiles[i].text;
  throw GpuError(fmt::format("the shader {} is not part of the program", file));
}

void append(const std::string& file, std::set<std::string>& seen, ShaderText& out) {
  if (!seen.insert(file).second) return;
  std::istringstream in(readShader(file));
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    constexpr std::string_view kInclude = "#include \"";
    if (line.starts_with(kInclude)) {
      append(line.substr(kInclude.size(), line.find('"', kInclude.size()) - kInclude.size()), seen, out);
      continue;
    }
    out.text += line + "\n";
    out.origin.emplace_back(file, number);
  }
}

}  // namespace

ShaderText expandShader(std::string_view file, const Defines& defines) {
  ShaderText out;
  auto addLine = [&](const std::string& line) {
    out.text += line + "\n";
    out.origin.emplace_back("(defines)", 0);
  };
  addLine("#version 450 core");
  for (const auto& [name, value] : defines) addLine(fmt::format("#define {} {}", name, value));
  std::set<std::string> seen;
  append(std::string(file), seen, out);
  return out;
}

std::string explainLog(const std::string& driverLog, const ShaderText& shader) {
  // Mesa writes "0:12(3): error: ...", NVIDIA "0(12) : error ...".
  static const std::regex kPlace(R"(^\s*\d+[:(](\d+)[\):]?(\(\d+\))?)");
  std::istringstream in(driverLog);
  std::string line, out;
  while (std::getline(in, line)) {
    std::smatch match;
    if (std::regex_search(line, match, kPlace)) {
      std::size_t number = std::stoul(match[1]);
      if (number >= 1 && number <= shader.origin.size()) {
        const auto& [file, fileLine] = shader.origin[number - 1];
        line = fmt::format("{}:{}{}", file, fileLine, match.suffix().str());
      }
    }
    out += line + "\n";
  }
  return out;
}

std::string expandedShader(std::string_view file, const Defines& defines) { return expandShader(file, defines).text; }

std::vector<std::string> shaderEntryPoints() {
  std::vector<std::string> found;
  for (unsigned i = 0; i < kShaderFileCount; ++i) {
    std::string_view path = kShaderFiles[i].path;
    if (path.ends_with(".comp") || path.ends_with(".vert") || path.ends_with(".frag")) found.emplace_back(path);
  }
  return found;
}

}  // namespace velum::gpu
