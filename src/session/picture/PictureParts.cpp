#include "session/picture/PictureParts.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "io/images/ImageFile.h"
#include "session/document/Open.h"

namespace velum::session {

namespace {

namespace fs = std::filesystem;

/// The parts of one picture.
class Parts {
 public:
  /// @param of  what the parts are of: nothing else is put together with them
  Parts(const fs::path& path, const PictureOptions& options, std::string of)
      : mFolder(path.string() + ".parts"), mOptions(options), mOf(std::move(of)) {}

  const fs::path& folder() const { return mFolder; }
  bool isThere(int number) const {
    try {
      return fs::exists(fileOf(number)) && io::readImageDescription(fileOf(number)) == mOf;
    } catch (const InputError&) {
      return false;  // cut off: drawn again
    }
  }
  int countThere() const {
    int there = 0;
    for (int number = 1; number <= mOptions.part.parts; ++number) there += isThere(number) ? 1 : 0;
    return there;
  }
  /// Channels have numbers before their names, as EXR has an order and colours of its own.
  void write(Image rows) const {
    for (std::size_t i = 0; i < rows.channels.size(); ++i)
      rows.channels[i] = fmt::format("{:03}{}", i, rows.channels[i]);
    io::writeImage(rows, fileOf(mOptions.part.number), mOf);
  }
  /// @return nothing where one is damaged, which is removed
  std::optional<Image> whole(Progress& progress) const {
    Image whole;
    for (int number = 1; number <= mOptions.part.parts; ++number) {
      progress.throwIfCancelled();
      Image rows;
      try {
        rows = io::readImage(fileOf(number));
      } catch (const InputError&) {
        fs::remove(fileOf(number));
        return std::nullopt;
      }
      if (number == 1) {
        whole = {mOptions.size.x, mOptions.size.y, rows.channels, {}};
        for (std::string& channel : whole.channels) channel = channel.substr(3);
        whole.pixels.reserve(std::size_t(whole.width) * std::size_t(whole.height) * whole.channels.size());
      }
      std::ranges::copy(rows.pixels, std::back_inserter(whole.pixels));
    }
    return whole;
  }
  /// The picture is written; who comes later has nothing to do.
  void close(const fs::path& picture) const {
    replaceFile(mFolder / kMade, stampOf(picture));
    std::error_code ignored;  // somebody else does the same
    for (int number = 1; number <= mOptions.part.parts; ++number) fs::remove(fileOf(number), ignored);
  }
  /// That very file is still there.
  bool isClosed(const fs::path& picture) const {
    std::ifstream file(mFolder / kMade, std::ios::binary);
    return file && fs::exists(picture) && std::string(std::istreambuf_iterator<char>(file), {}) == stampOf(picture);
  }

 private:
  static constexpr const char* kMade = "made";

  std::string stampOf(const fs::path& picture) const {
    return fmt::format("{}\n{} bytes, written {}\n", mOf, fs::file_size(picture),
                       fs::last_write_time(picture).time_since_epoch().count());
  }
  fs::path fileOf(int number) const { return mFolder / fmt::format("{}-of-{}.exr", number, mOptions.part.parts); }

  fs::path mFolder;
  PictureOptions mOptions;
  std::string mOf;
};

}  // namespace

std::vector<std::string> savePicturePart(render::Renderer& renderer, const scene::Scene& scene,
                                         const scene::Scene& kept, const PictureOptions& options,
                                         const gpu::Limits& limits, const std::filesystem::path& path,
                                         Progress& progress) {
  auto [number, count] = options.part;
  if (count > options.size.y)
    throw ArgumentError(fmt::format("part {}/{}: the picture has {} rows", number, count, options.size.y));
  std::string of = fmt::format("{} in {} parts\n{}", pictureCommand({}, options, {}), count,
                               sceneTextFor(sceneForPicture(scene, options), path));
  Parts parts(path, options, std::move(of));
  const std::vector<std::string> isThere{fmt::format("{}: it is there, of all {} parts", path.string(), count)};
  if (parts.isClosed(path)) return isThere;
  std::error_code error;
  fs::create_directories(parts.folder(), error);
  if (!parts.isThere(number)) parts.write(drawPixels(renderer, scene, options, limits, progress));
  int there = parts.countThere();
  std::optional<Image> whole = there == count ? parts.whole(progress) : std::nullopt;
  if (!whole && parts.isClosed(path)) return isThere;  // another process was quicker
  if (!whole)
    return {fmt::format("{}: {} of {} parts are there; it is put together when all are", path.string(),
                        parts.countThere(), count)};
  savePicture(withLettering(std::move(*whole), scene, options, progress), kept, options, path);
  parts.close(path);
  return {fmt::format("{}: put together of {} parts", path.string(), count)};
}

}  // namespace velum::session
