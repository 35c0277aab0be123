#pragma once

namespace velum::io {

/// While one of these lives, what is written to the standard error is thrown away, whoever writes it: the codecs behind
/// GDCM and OpenImageIO (OpenJPEG, CharLS, libjpeg, libpng) print what they dislike about a damaged stream, and offer
/// no way to say no. Any thread; cheap enough for each picture of a series.
class StderrQuiet {
 public:
  StderrQuiet();
  ~StderrQuiet();
  StderrQuiet(const StderrQuiet&) = delete;
  StderrQuiet& operator=(const StderrQuiet&) = delete;
};

}  // namespace velum::io
