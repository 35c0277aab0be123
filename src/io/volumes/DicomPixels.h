#pragma once
#include <memory>
#include <span>

#include "core/Volume.h"
#include "io/volumes/DicomFile.h"

namespace velum::io {

/// Type and layout of a DICOM file's samples after decoding.
struct DicomPixelType {
  SampleType type = SampleType::UInt8;
  int channels = 1;
  int columns = 0, rows = 0, frames = 0;
  bool isInverted = false;  ///< MONOCHROME1: the samples were inverted.
  bool operator==(const DicomPixelType&) const = default;
};

/// The decoded samples of a file, all frames. Colour comes as interleaved RGB.
class DicomPixels {
 public:
  /// @throw InputError when the pixels are missing, cut off, or in a form that is not supported
  explicit DicomPixels(const DicomFile& file);
  ~DicomPixels();
  DicomPixels(const DicomPixels&) = delete;
  DicomPixels& operator=(const DicomPixels&) = delete;

  const DicomPixelType& type() const;
  std::size_t byteCount() const;
  /// Decodes into @p to, which has byteCount() bytes, and releases the compressed data. In each sample the bits outside
  /// the stored ones are cleared and the sign is extended, whatever the codec left in them.
  void decode(std::span<std::byte> to);

 private:
  struct State;
  std::unique_ptr<State> mState;
};

}  // namespace velum::io
