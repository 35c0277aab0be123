#include "vector/Png.h"

#include <png.h>

#include "core/Error.h"

namespace velum::vector {

std::string pngOf(const Image& image, Alpha alpha) {
  std::vector<std::uint8_t> bytes = plateBytes(image, alpha);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = alpha == Alpha::Alone ? PNG_FORMAT_GRAY : alpha == Alpha::With ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&png, file.data(), &size, 0, bytes.data(), 0, nullptr))
    throw Error(ExitCode::Input, std::string("a plate cannot be written as PNG: ") + png.message);
  file.resize(size);
  return file;
}

std::string packedRowsOf(const std::string& png) {
  std::string rows;
  // Behind a head of 8 bytes come chunks: their length, name, bytes, and sum.
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t i = at; i < at + 4; ++i) length = length << 8 | static_cast<unsigned char>(png[i]);
    if (png.compare(at + 4, 4, "IDAT") == 0) rows.append(png, at + 8, length);
    at += length + 12;
  }
  return rows;
}

std::string base64Of(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = i; j < i + 3; ++j)
      three = three << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += i + digit > bytes.size() ? '=' : kDigits[three >> (18 - 6 * digit) & 63u];
  }
  return text;
}

}  // namespace velum::vector
