#pragma once
#include <memory>
#include <ostream>

#include "core/ReplaceFile.h"

namespace velum::io {

/// A file that replaces another, as a stream for libraries that write to one. They may seek. A refused write makes the
/// stream bad, and the file's commit() throws whether the library looks or not.
class SinkStream : public std::ostream {
 public:
  /// The file is borrowed and must live longer; the caller commits it.
  explicit SinkStream(ReplaceFile& file);
  ~SinkStream() override;

 private:
  class Buffer;
  std::unique_ptr<Buffer> mBuffer;
};

}  // namespace velum::io
