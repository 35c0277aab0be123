#pragma once

namespace velum::io {

/// While an object of this class lives, everything that any code writes to the standard error is thrown away: the
/// codecs behind GDCM and OpenImageIO (OpenJPEG, CharLS, libjpeg, libpng) print what they dislike about a damaged
/// stream, and offer no way to turn that off. Any thread; cheap enough for each picture of a series.
class StderrQuiet {
 public:
  StderrQuiet();
  ~StderrQuiet();
  StderrQuiet(const StderrQuiet&) = delete;
  StderrQuiet& operator=(const StderrQuiet&) = delete;
};

}  // namespace velum::io
