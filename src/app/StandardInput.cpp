#include "app/StandardInput.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/Error.h"

namespace velum::app {

namespace fs = std::filesystem;

namespace {

/// A folder that holds the copy of standard input.
class Copy {
 public:
  Copy() {
    std::string folder = (fs::temp_directory_path() / "velum-XXXXXX").string();
    if (!::mkdtemp(folder.data())) throw InputError("standard input: no place for a copy; set TMPDIR to a folder");
    mFolder = folder;
    mFile = mFolder / "standard-input";
    std::ofstream out(mFile, std::ios::binary);
    std::array<char, 1 << 16> bytes;
    std::string head;
    for (std::size_t count; (count = std::fread(bytes.data(), 1, bytes.size(), stdin)) > 0;) {
      if (head.empty()) head.assign(bytes.data(), count < 16 ? count : 16);
      out.write(bytes.data(), std::streamsize(count));
    }
    out.close();
    if (!out)
      throw InputError("standard input: the copy in " + mFolder.string() + " cannot be written; is the disk full?");
    if (head.empty()) throw InputError("standard input: nothing came in");
    giveExtension(head);
  }
  ~Copy() {
    std::error_code error;
    fs::remove_all(mFolder, error);
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  std::string file() const { return mFile.string(); }

 private:
  /// Velum's scenes and pictures are known by their file names, so the copy gets one; all other formats by their
  /// contents.
  void giveExtension(std::string_view head) {
    fs::path named = mFile;
    if (head.starts_with("\x89PNG")) named += ".png";
    if (head.front() == '{') named += ".json";
    fs::rename(mFile, named);
    mFile = named;
  }
  fs::path mFolder, mFile;
};

}  // namespace

std::string fileOfInput(const std::string& input) {
  if (input != kStandardInput) return input;
  static Copy copy;
  return copy.file();
}

}  // namespace velum::app
