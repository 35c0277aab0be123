#pragma once
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "Drawings.h"
#include "SourceFolder.h"
#include "TempFolder.h"
#include "runProgram.h"

namespace velum::vector {

/// What programs of others make of our files; they know the fonts of the project and no others.
class Programs : public testing::Test {
 protected:
  Programs() {
    std::ofstream(mFolder / "fonts.conf")
        << "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig><dir>"
        << (sourceFolder() / "resources/fonts").string() << "</dir><cachedir>" << (mFolder / "cache").string()
        << "</cachedir></fontconfig>";
  }
  static bool has(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
  }
  /// What a command writes, in the folder of the test; empty where it fails.
  std::string run(const std::string& command) const {
    std::string folder = mFolder.path().string();
    return outputOf("cd " + folder + " && HOME=" + folder + " FONTCONFIG_FILE=" + folder + "/fonts.conf " + command +
                    " 2>err.txt");
  }
  Image readPng(const std::string& name) const {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, (mFolder / name).c_str())) return {};
    png.format = PNG_FORMAT_RGB;
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
    png_color white{255, 255, 255};
    png_image_finish_read(&png, &white, bytes.data(), 0, nullptr);
    Image image{int(png.width), int(png.height), {"R", "G", "B"}, {}};
    for (png_byte byte : bytes) image.pixels.push_back(float(byte) / 255.0f);
    return image;
  }

  TempFolder mFolder;
};

/// The mean difference of two pictures, and the share of samples that differ by more than 40 of 255.
struct Difference {
  double mean = 1.0, far = 1.0;
};
inline Difference differenceOf(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) return {};
  double sum = 0.0, far = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    double difference = std::abs(double(a.pixels[i]) - double(b.pixels[i]));
    sum += difference;
    far += difference > 40.0 / 255.0 ? 1.0 : 0.0;
  }
  return {sum / double(a.pixels.size()), far / double(a.pixels.size())};
}

}  // namespace velum::vector
