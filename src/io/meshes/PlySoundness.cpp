#include "PlySoundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "read/FileBytes.h"
#include "velum/core/Error.h"

namespace velum::io {

namespace {

using Path = std::filesystem::path;

struct Property {
  std::string name;
  std::string type;
  std::string countType;  ///< Lists only: of the number before the items.
};

struct Element {
  std::string name;
  double count = 0;
  std::vector<Property> properties;
};

enum class Coding { Ascii, LittleEndian, BigEndian };

struct Header {
  Coding coding = Coding::Ascii;
  std::vector<Element> elements;
};

/// Bytes of a scalar type; 0 for a word that is none.
int bytesOf(std::string_view type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "int32" || type == "uint32" || type == "float" || type == "float32")
    return 4;
  return type == "double" || type == "float64" ? 8 : 0;
}

Property readProperty(std::istringstream& words, const Path& path) {
  Property property;
  words >> property.type;
  if (property.type == "list") words >> property.countType >> property.type;
  words >> property.name;
  if (bytesOf(property.type) == 0 || (!property.countType.empty() && bytesOf(property.countType) == 0))
    refuse(path, fmt::format("has a property of the unknown type '{}'", property.type));
  return property;
}

Header readHeader(std::istream& in, const Path& path) {
  constexpr int kMostLines = 10'000;
  Header header;
  std::string line;
  for (int i = 0; i < kMostLines && std::getline(in, line); ++i) {
    std::istringstream words(line);
    std::string key, value;
    words >> key;
    if (i == 0 && key != "ply") refuse(path, "is not a PLY file");
    if (key == "end_header") return header;
    if (key == "format") {
      words >> value;
      header.coding = value == "ascii"               ? Coding::Ascii
                      : value == "binary_big_endian" ? Coding::BigEndian
                                                     : Coding::LittleEndian;
    } else if (key == "element") {
      Element element;
      words >> element.name >> element.count;
      header.elements.push_back(element);
    } else if (key == "property") {
      if (header.elements.empty()) refuse(path, "has a property before its first element");
      header.elements.back().properties.push_back(readProperty(words, path));
    }
  }
  refuse(path, "has no end of its header");
}

template <class T>
double as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return double(value);
}

class Body {
 public:
  Body(std::istream& in, Coding coding, const Path& path) : mIn(in), mCoding(coding), mPath(path) {}

  double next(std::string_view type) {
    double value = 0;
    if (mCoding == Coding::Ascii) {
      mIn >> value;
    } else {
      char bytes[8] = {};
      int count = bytesOf(type);
      mIn.read(bytes, count);
      if ((mCoding == Coding::BigEndian) == (std::endian::native == std::endian::little))
        std::reverse(bytes, bytes + count);
      value = decode(type, bytes);
    }
    if (!mIn) refuse(mPath, "is cut short");
    return value;
  }

 private:
  static double decode(std::string_view type, const char* bytes) {
    if (type == "double" || type == "float64") return as<double>(bytes);
    if (type.starts_with("float")) return as<float>(bytes);
    bool isUnsigned = type.starts_with("u");
    switch (bytesOf(type)) {
      case 1:
        return isUnsigned ? as<std::uint8_t>(bytes) : as<std::int8_t>(bytes);
      case 2:
        return isUnsigned ? as<std::uint16_t>(bytes) : as<std::int16_t>(bytes);
      default:
        return isUnsigned ? as<std::uint32_t>(bytes) : as<std::int32_t>(bytes);
    }
  }

  std::istream& mIn;
  Coding mCoding;
  const Path& mPath;
};

}  // namespace

void checkPly(const Path& path) {
  double size = double(FileBytes(path).size());
  std::ifstream in(path, std::ios::binary);
  Header header = readHeader(in, path);
  Body body(in, header.coding, path);
  double vertices = 0;
  for (const Element& element : header.elements) {
    if (!(element.count >= 0) || element.count > size)
      refuse(path, fmt::format("the header promises {:.0f} elements, more than the file can hold", element.count));
    if (element.name == "vertex") vertices = element.count;
    for (double i = 0; i < element.count; ++i)
      for (const Property& property : element.properties) {
        if (property.countType.empty()) {
          body.next(property.type);
          continue;
        }
        double items = body.next(property.countType);
        if (!(items >= 0) || items > size)
          refuse(path, fmt::format("has a list of {:.0f} items, more than the file can hold", items));
        bool areIndices = property.name == "vertex_indices" || property.name == "vertex_index";
        for (double item = 0; item < items; ++item)
          if (double index = body.next(property.type); areIndices && !(index >= 0 && index < vertices))
            refuse(path, fmt::format("a face names point {:.0f}, which is not there", index));
      }
  }
}

}  // namespace velum::io
