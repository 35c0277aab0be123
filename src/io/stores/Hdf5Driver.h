#pragma once
#include <hdf5.h>

#include <mutex>
#include <optional>

#include "io/stores/Hdf5File.h"

/// How the HDF5 library gets at bytes.
namespace velum::io {

/// Holds the library: everybody who calls it has one, and no two at once. What it has to say is kept, not printed.
class Hdf5Lock {
 public:
  Hdf5Lock();
  /// What went wrong in the call before, in the library's words, in brackets with a blank before; empty where it says
  /// nothing.
  std::string reason() const;

 private:
  std::lock_guard<std::mutex> mHeld;
};

/// An identifier of the library, which is given back at the end.
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Id(hid_t id, Close close) : mId(id), mClose(close) {}
  Hdf5Id(Hdf5Id&& other) noexcept : mId(other.mId), mClose(other.mClose) { other.mId = -1; }
  Hdf5Id& operator=(Hdf5Id&&) = delete;
  ~Hdf5Id() {
    if (mId >= 0) mClose(mId);
  }
  bool isValid() const { return mId >= 0; }
  operator hid_t() const { return mId; }

 private:
  hid_t mId;
  Close mClose;
};

/// Opens a file over FileBytes; invalid where the library refuses it. @param lock  is held
Hdf5Id openByDriver(const Hdf5Lock& lock, const Path& path);

/// Where the library would read the bytes of a chunk, which is not read: the library's own question for that walks over
/// all chunks before it. Nothing where the file has no such chunk. @param origin  first sample of the chunk
/// @throw InputError
std::optional<Hdf5Piece> findChunk(const Hdf5Lock& lock, hid_t dataset, const hsize_t* origin, const Path& path);

}  // namespace velum::io
