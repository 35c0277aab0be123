#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/Task.h"
#include "core/Volume.h"
#include "io/read/FileBytes.h"
#include "io/read/XmlTree.h"

/// VTK's files in XML, which we read ourselves: VTK's readers allocate whatever a header claims, use arrays that they
/// failed to allocate, and cannot be stopped within a block.
namespace velum::io {

enum class VtkPacking { None, Deflate, Lz4, Lzma };

/// Unpacks a block of LZ4 or LZMA. @return how many bytes the block gave; the block is damaged where that is not the
/// size of `to`
std::size_t unpackByVtk(VtkPacking packing, std::span<const std::byte> from, std::span<std::byte> to);

/// A file's elements, and how its arrays are stored.
class VtkXml {
 public:
  /// @param kind  what the file must hold: "ImageData", "PolyData". @throw InputError when the file holds something
  /// else
  VtkXml(const FileBytes& file, std::string_view kind);

  const FileBytes& file() const { return mFile; }
  /// The element <ImageData> or <PolyData>.
  const XmlElement& data() const { return *mData; }
  bool isBigEndian() const { return mIsBigEndian; }
  std::size_t wordBytes() const { return mWordBytes; }  ///< Bytes of each of the sizes that stand before the values.
  VtkPacking packing() const { return mPacking; }
  const XmlElement* appended() const { return mAppended; }

 private:
  const FileBytes& mFile;
  XmlElement mRoot;
  const XmlElement *mData = nullptr, *mAppended = nullptr;
  bool mIsBigEndian = false;
  std::size_t mWordBytes = 4;
  VtkPacking mPacking = VtkPacking::None;
};

/// An array of a file, not yet read. 64-bit integers come out as doubles.
class VtkArray {
 public:
  /// @throw InputError for a type or a format that is not known
  VtkArray(const VtkXml& xml, const XmlElement& element);

  std::string_view name() const { return mElement.attribute("Name"); }
  /// Name of a component; empty where it has no name.
  std::string_view componentName(int index) const {
    return mElement.attribute("ComponentName" + std::to_string(index));
  }
  SampleType type() const { return mType; }
  bool isWide() const { return mIsWide; }  ///< The file holds 64-bit integers.
  int components() const { return mComponents; }
  /// Checks that the file can hold so many values, and that they are as many as it states; allocates nothing.
  /// @throw InputError
  void check(std::uint64_t values) const;
  /// Fills all of `to`, after a check(). @throw InputError for damaged data; Cancelled
  void read(std::span<std::byte> to, Progress& progress) const;

 private:
  class Source;
  void readText(std::span<std::byte> to, Progress& progress) const;
  void readBlocks(Source& source, std::span<std::byte> to, Progress& progress) const;

  const VtkXml& mXml;
  const XmlElement& mElement;
  SampleType mType = SampleType::UInt8;
  bool mIsWide = false, mIsUnsigned = false, mIsText = false, mIsBase64 = false;
  int mComponents = 1;
  std::uint64_t mFrom = 0, mTo = 0;  ///< Bytes of the file that hold the array; an appended array may end before mTo.
};

}  // namespace velum::io
