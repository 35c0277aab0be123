#include "io/models/StructureFiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/FileName.h"
#include "io/models/PdbFile.h"
#include "io/read/FileNames.h"

namespace velum::io {

namespace {

constexpr std::string_view kEndings[] = {".pdb", ".pdb.gz", ".ent", ".ent.gz"};
constexpr std::string_view kBeads = ".bin";
/// Names of folders of structures, as cellPACK and its readers have them.
constexpr std::string_view kFolders[] = {"proteins", "structures", "fibre-bases", "atomic", "other", "pdb"};
/// A folder may be somebody's home: no more files are looked at.
constexpr std::size_t kMostSeen = 50000;

bool isStructure(const std::string& name) {
  return name.ends_with(kBeads) ||
         std::any_of(std::begin(kEndings), std::end(kEndings), [&](auto e) { return name.ends_with(e); });
}

}  // namespace

StructureFiles::StructureFiles(const Path& model) {
  Path folder = std::filesystem::absolute(model).lexically_normal().parent_path();
  addFolder(folder, 2);
  std::error_code error;
  std::vector<Path> siblings;
  for (const auto& entry : std::filesystem::directory_iterator(folder.parent_path(), error)) {
    if (++mSeen > kMostSeen) break;
    if (entry.is_directory(error)) siblings.push_back(entry.path());
  }
  std::sort(siblings.begin(), siblings.end());
  siblings.insert(siblings.begin(), folder.parent_path());
  for (const Path& sibling : siblings)
    for (std::string_view name : kFolders) addFolder(sibling / name, 0);
}

void StructureFiles::addFolder(const Path& folder, int depth) {
  std::error_code error;
  std::vector<Path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (++mSeen > kMostSeen) return;
    std::string name = lowerCase(entry.path().filename().string());
    if (depth > 0 && entry.is_directory(error) && !entry.is_symlink(error))
      folders.push_back(entry.path());
    else if (isStructure(name) && entry.is_regular_file(error))
      mByName.try_emplace(name, entry.path());  // what lies nearer is met first
  }
  std::sort(folders.begin(), folders.end());
  for (const Path& next : folders) addFolder(next, depth - 1);
}

std::optional<Path> StructureFiles::find(std::string_view name) const {
  name.remove_prefix(std::min(name.find_last_of("/\\") + 1, name.size()));
  std::string lower = lowerCase(name);
  if (lower.empty() || lower == "none" || lower == "null") return std::nullopt;
  if (auto at = mByName.find(lower); at != mByName.end()) return at->second;
  for (std::string_view ending : kEndings)
    if (auto at = mByName.find(lower + std::string(ending)); at != mByName.end()) return at->second;
  if (auto at = mByName.find(lower + std::string(kBeads)); at != mByName.end()) return at->second;
  return std::nullopt;
}

StructureParts readStructure(const Path& path, bool withCopies) {
  std::string text = textOf(path);
  StructureParts parts;
  if (!lowerCase(path.filename().string()).ends_with(kBeads)) {
    PdbFile file = parsePdb(text, path);
    parts.atoms = ingredientAtoms(file, withCopies);
    parts.isNucleic = isNucleic(file);
    if (parts.atoms.empty()) refuse(path, "has no atoms");
    return parts;
  }
  if (text.empty() || text.size() % sizeof(glm::vec4) != 0)
    refuse(path, fmt::format("is no list of balls of 16 bytes each: it has {} bytes", text.size()));
  static_assert(std::endian::native == std::endian::little);
  parts.beads.resize(text.size() / sizeof(glm::vec4));
  std::memcpy(static_cast<void*>(parts.beads.data()), text.data(), text.size());
  for (const glm::vec4& b : parts.beads)
    if (!(glm::length(glm::vec3(b)) < 1e8f && b.w > 0.0f && b.w < 1e6f)) refuse(path, "has a ball that is none");
  return parts;
}

}  // namespace velum::io
