#include "io/stores/Hdf5Driver.h"

#include "core/Error.h"

namespace velum::io {

namespace {

std::mutex& libraryLock() {
  static std::mutex lock;
  return lock;
}

/// Where a driver says what it would have read.
thread_local Hdf5Piece* tWanted = nullptr;

/// An open file, as the library knows it: its own part comes first.
struct DriverFile {
  H5FD_t base{};
  std::shared_ptr<const FileBytes> bytes;
  haddr_t end = 0;  ///< of what the library has allocated
};

DriverFile& fileOf(H5FD_t* base) { return *reinterpret_cast<DriverFile*>(base); }
const DriverFile& fileOf(const H5FD_t* base) { return *reinterpret_cast<const DriverFile*>(base); }

H5FD_t* openFile(const char* name, unsigned flags, hid_t, haddr_t) try {
  if (flags & H5F_ACC_RDWR) return nullptr;
  auto file = std::make_unique<DriverFile>();
  file->bytes = std::make_shared<const FileBytes>(name);
  return &file.release()->base;
} catch (const Error&) {
  return nullptr;
}

herr_t closeFile(H5FD_t* base) {
  delete &fileOf(base);
  return 0;
}

herr_t readBytes(H5FD_t* base, H5FD_mem_t type, hid_t, haddr_t at, std::size_t size, void* to) try {
  const DriverFile& file = fileOf(base);
  if (tWanted && type == H5FD_MEM_DRAW) {
    *tWanted = {file.bytes, at, size, 0};
    return 0;
  }
  if (at > file.bytes->size() || size > file.bytes->size() - at) return -1;
  file.bytes->read(at, std::span(static_cast<std::byte*>(to), size));
  return 0;
} catch (const Error&) {
  return -1;
}

/// Two files are the same one where they have the same place: the library keeps each of them once.
int compareFiles(const H5FD_t* a, const H5FD_t* b) { return fileOf(a).bytes->path().compare(fileOf(b).bytes->path()); }

constexpr H5FD_class_t kDriver = {
    .name = "velum",
    .maxaddr = (haddr_t(1) << 63) - 1,
    .fc_degree = H5F_CLOSE_WEAK,
    .open = openFile,
    .close = closeFile,
    .cmp = compareFiles,
    .query =
        [](const H5FD_t*, unsigned long* flags) {
          if (flags) *flags = H5FD_FEAT_ACCUMULATE_METADATA_READ;
          return herr_t(0);
        },
    .get_eoa = [](const H5FD_t* base, H5FD_mem_t) { return fileOf(base).end; },
    .set_eoa =
        [](H5FD_t* base, H5FD_mem_t, haddr_t end) {
          fileOf(base).end = end;
          return herr_t(0);
        },
    .get_eof = [](const H5FD_t* base, H5FD_mem_t) { return haddr_t(fileOf(base).bytes->size()); },
    .read = readBytes,
    .write = [](H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, const void*) { return herr_t(-1); },
    .fl_map = H5FD_FLMAP_SINGLE,
};

/// Says what it finds while it lives.
class Probe {
 public:
  Probe() { tWanted = &found; }
  ~Probe() { tWanted = nullptr; }
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;
  Hdf5Piece found;
};

}  // namespace

Hdf5Lock::Hdf5Lock() : mHeld(libraryLock()) {
  ::H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // a setting of each thread
  ::H5Eclear2(H5E_DEFAULT);
}

std::string Hdf5Lock::reason() const {
  std::string words;
  ::H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned number, const H5E_error2_t* error, void* to) {
        if (number == 0 && error->desc) *static_cast<std::string*>(to) = error->desc;
        return herr_t(0);
      },
      &words);
  constexpr std::size_t kMost = 120;
  if (words.empty() || words.size() > kMost) return {};
  return " (" + words + ")";
}

Hdf5Id openByDriver(const Hdf5Lock&, const Path& path) {
  static const hid_t driver = ::H5FDregister(&kDriver);
  Hdf5Id access(::H5Pcreate(H5P_FILE_ACCESS), ::H5Pclose);
  ::H5Pset_driver(access, driver, nullptr);
  return {::H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), ::H5Fclose};
}

std::optional<Hdf5Piece> findChunk(const Hdf5Lock& lock, hid_t dataset, const hsize_t* origin, const Path& path) {
  hsize_t size = 0;
  bool isAnswered = ::H5Dget_chunk_storage_size(dataset, origin, &size) >= 0;
  std::string reason = isAnswered ? std::string() : lock.reason();
  bool isMissing = isAnswered ? size == 0 : reason.find("is not allocated") != reason.npos;
  if (isMissing) return std::nullopt;
  if (!isAnswered) refuse(path, "the place of a chunk cannot be found: it is damaged" + reason);
  std::uint32_t skipped = 0;
  Probe probe;
  char nothing = 0;  // the driver puts nothing there
  if (::H5Dread_chunk(dataset, H5P_DEFAULT, origin, &skipped, &nothing) < 0 || !probe.found.file)
    refuse(path, "the place of a chunk cannot be found: it is damaged" + lock.reason());
  probe.found.skipped = skipped;
  return probe.found;
}

}  // namespace velum::io
