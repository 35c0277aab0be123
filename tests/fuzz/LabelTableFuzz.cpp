#include <cstdlib>
#include <map>
#include <string>

#include "FuzzFile.h"
#include "core/Error.h"
#include "io/labels/LabelTables.h"
#include "io/labels/ReadLabels.h"

namespace {

void checkTable(const std::vector<velum::LabelInfo>& table) {
  for (const auto& info : table)
    if (!(info.opacity >= 0.0f && info.opacity <= 1.0f)) std::abort();
}

}  // namespace

/// The same bytes as a table beside a file, as XML inside one, and as the key/value pairs of a NRRD.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace velum::io;
  std::string text(reinterpret_cast<const char*>(data), size);
  static FuzzFile file("a.txt");
  file.hold(data, size);
  try {
    checkTable(readLabelTable(file.path()));
  } catch (const velum::Error&) {
  }
  checkTable(parseCaretLabels(text));
  std::map<std::string, std::string> pairs;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t split = text.find(":=", at);
    if (split < end) pairs[text.substr(at, split - at)] = text.substr(split + 2, end - split - 2);
    at = end + 1;
  }
  for (const auto& segment : parseSlicerSegments(pairs)) checkTable({segment.label});
  return 0;
}
