#pragma once
#include <memory>
#include <ostream>

#include "core/ReplaceFile.h"

namespace velum::io {

/// A ReplaceFile as a stream, for libraries that write to streams. They may seek. A refused write makes the stream bad,
/// and the file's commit() throws whether the library checks the stream or not.
class SinkStream : public std::ostream {
 public:
  /// The file is borrowed and must outlive the stream; the caller commits the file.
  explicit SinkStream(ReplaceFile& file);
  ~SinkStream() override;

 private:
  class Buffer;
  std::unique_ptr<Buffer> mBuffer;
};

}  // namespace velum::io
