#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/read/FileBytes.h"

namespace velum::io {

/// An element of an XML file. Of the text inside it only the place in the file is kept.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::uint64_t textAt = 0, textEnd = 0;  ///< Bytes of the file from the opening tag to the next tag.
  std::vector<XmlElement> children;

  /// Value of an attribute; empty where there is none.
  std::string_view attribute(std::string_view key) const;
  /// The first child of that name; null where there is none.
  const XmlElement* child(std::string_view key) const;
};

/// Reads the elements of a file. The texts in elements may be of any length, as they are only skipped. Knows the five
/// entities, comments and processing instructions; a document type is refused.
/// @param last  name of an element whose text runs to the file's end and is not looked at: VTK's binary data
/// @throw InputError for a file that is not XML, is cut short, or has more elements than any header
XmlElement readXml(const FileBytes& file, std::string_view last);

}  // namespace velum::io
