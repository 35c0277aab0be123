#pragma once
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "TempFolder.h"
#include "core/Error.h"
#include "session/film/MakeFilm.h"

namespace velum::session {

/// A film that needs no driver: each moment is a small picture of one colour and a moving dot.
inline FrameSource smallFilm(int count, std::vector<std::pair<int, double>>* asked = nullptr) {
  return {count, [asked](int frame, double share, Progress& progress) {
            progress.report(0.0, "");
            if (asked) asked->emplace_back(frame, share);
            Image image{16, 8, {"R", "G", "B", "A"}, {}};
            for (int i = 0; i < 16 * 8; ++i) {
              bool isDot = i % 16 == (frame + 160) % 16;
              for (float v : {isDot ? 1.0f : float(frame % 256) / 255.0f, float(frame / 256) / 255.0f, 0.25f, 1.0f})
                image.pixels.push_back(v);
            }
            return FilmFrame{std::move(image), {}};
          }};
}

inline FilmOutput outputTo(const std::filesystem::path& path) {
  FilmOutput output{path, {}};
  output.picture.size = {16, 8};
  return output;
}

inline const FilmIdentity kSmallFilm{{"renderer", "none"}, {"scene", "a dot"}};

inline std::string bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The bytes of each frame, in order; "" for one that is not there.
inline std::vector<std::string> framesOf(const std::filesystem::path& output, int count) {
  std::vector<std::string> all;
  for (int i = 0; i < count; ++i) all.push_back(bytesOf(FrameNames(output).frame(i)));
  return all;
}

}  // namespace velum::session
