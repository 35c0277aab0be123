#pragma once
#include <map>
#include <string>

#include "../io/ZarrFiles.h"

namespace velum::io {

/// The files of a folder as ZarrFuzz takes them.
inline std::string recordsOf(const std::filesystem::path& folder) {
  std::string records;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::string key = std::filesystem::relative(entry.path(), folder).string(), bytes;
    std::ifstream file(entry.path(), std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
    records += char(key.size()) + key + bytesOfNumber(std::uint16_t(bytes.size())) + bytes;
  }
  return records;
}

/// An image with labels, in both versions and packed by each codec, by names. @param folder  to work in, removed at the
/// end
inline std::map<std::string, std::string> storeRecords(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (int version : {2, 3})
    for (const char* codec : {"raw", "gzip", "zlib", "zstd", "lz4", "blosc"}) {
      std::filesystem::remove_all(folder);
      ZarrFile file;
      file.version = version;
      file.folder = folder / "0";
      file.shape = {3, 5, 6};
      file.chunk = {2, 2, 3};
      file.codec = codec;
      file.value = [](const Sizes& i) { return double(i[0] + i[1] + i[2]); };
      if (version == 3 && std::string_view(codec) == "zstd") file.shard = {2, 4, 6};
      if (version == 3 && std::string_view(codec) == "raw") file.hasCrc = true;
      file.write();
      file.folder = folder / "labels/a/0";
      file.write();
      Json image = {{{"axes", axesOf("zyx")}, {"datasets", {levelAt("0", {2, 1, 1}, {1, 0, 0})}}}};
      Json channel = {{"label", "a"}, {"color", "00ff00"}, {"window", {{"start", 0}, {"end", 9}}}};
      writeGroup(folder, version, {{"multiscales", image}, {"omero", {{"channels", {channel}}}}});
      writeGroup(folder / "labels", version, {{"labels", {"a"}}});
      Json color = {{"label-value", 1}, {"rgba", {255, 0, 0, 255}}};
      writeGroup(folder / "labels/a", version, {{"multiscales", image}, {"image-label", {{"colors", {color}}}}});
      all[codec + std::to_string(version)] = recordsOf(folder);
    }
  std::filesystem::remove_all(folder);
  return all;
}

}  // namespace velum::io
