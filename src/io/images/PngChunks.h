#pragma once
#include <string_view>
#include <vector>

#include "io/read/FileBytes.h"

namespace velum::io {

/// True when all chunks of a PNG file, up to the last, lie within the file. The library allocates the size that a chunk
/// claims before it reads, so that four bytes could ask for two gigabytes.
bool isSoundPng(const FileBytes& file);

/// Puts a text into a PNG file, behind its header: a chunk tEXt. @param png  a whole file  @param keyword  1 to 79
/// letters
void addPngText(std::vector<unsigned char>& png, std::string_view keyword, std::string_view text);

}  // namespace velum::io
