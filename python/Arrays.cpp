#include "Arrays.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "Lock.h"
#include "core/Error.h"
#include "core/ImageChannels.h"
#include "core/Text.h"
#include "io/labels/LabelTables.h"
#include "io/stores/AxisUnits.h"

namespace velum::python {

namespace py = pybind11;

namespace {

constexpr py::ssize_t kMostSide = 65535;
constexpr int kMostId = 65535;

/// An array over memory that `owner` keeps.
py::array arrayOver(const std::string& type, std::vector<py::ssize_t> shape, const void* data, py::handle owner) {
  return py::array(py::dtype(type), std::move(shape), data, owner);
}

/// Lets numpy copy: it knows all strides, types and byte orders.
void copyInto(py::array target, const py::array& source) {
  py::module_::import("numpy").attr("copyto")(target, source);
}

std::string shapeText(const py::array& array) { return py::str(array.attr("shape")); }

/// Time steps, z, y, x, channels of an array of voxels.
std::vector<py::ssize_t> voxelShape(const py::array& array) {
  std::vector<py::ssize_t> shape(array.shape(), array.shape() + array.ndim());
  if (shape.size() == 3) shape.push_back(1);
  if (shape.size() == 4) shape.insert(shape.begin(), 1);
  if (shape.size() != 5)
    throw ArgumentError(
        fmt::format("an array of shape {} is no volume; shapes are [z,y,x], [z,y,x,channel] and [time,z,y,x,channel]",
                    shapeText(array)));
  if (std::any_of(shape.begin(), shape.end(), [](py::ssize_t side) { return side < 1 || side > kMostSide; }))
    throw ArgumentError(
        fmt::format("an array of shape {} is no volume: a side is 1 to {}", shapeText(array), kMostSide));
  return shape;
}

SampleType sampleTypeOf(const py::array& array) {
  std::string type = py::str(array.dtype().attr("name"));
  if (type == "bool") type = "uint8";
  if (type == "float16") type = "float32";
  if (auto known = enumValue<SampleType>(type)) return *known;
  throw ArgumentError(fmt::format("voxels of type {} are not known; convert them: array.astype(\"float32\")", type));
}

/// Why a volume cannot lie over the samples of an array; empty: it can. Others must not write to them unnoticed: an
/// array and what it is a view of can be made read-only, the rest of a larger array, and memory of other libraries,
/// cannot.
std::string whyNotShared(const py::array& array) {
  if (!enumValue<SampleType>(std::string(py::str(array.dtype().attr("name"))))) return "its type is converted";
  if (!py::cast<bool>(array.dtype().attr("isnative"))) return "its byte order is another";
  if (!py::cast<bool>(array.attr("flags").attr("c_contiguous"))) return "its samples do not lie one after the other";
  if (!py::cast<bool>(array.attr("flags").attr("aligned"))) return "its samples are not aligned";
  py::array at = array;
  for (;;) {
    py::object base = at.base();
    if (!base || base.is_none()) return {};
    if (!py::isinstance<py::array>(base)) {
      bool isMapped = py::isinstance(base, py::module_::import("mmap").attr("mmap"));
      return at.writeable() && !isMapped ? "its memory is not numpy's, and could be written to" : "";
    }
    at = py::reinterpret_borrow<py::array>(base);
    if (at.writeable() && at.nbytes() != array.nbytes()) return "it is a view of a larger array that can be written to";
  }
}

/// Makes an array, and what it is a view of, read-only.
void lock(const py::array& array) {
  for (py::object at = array; at && py::isinstance<py::array>(at); at = at.attr("base"))
    at.attr("flags").attr("writeable") = false;
}

/// Lets go of an array, in whatever thread its volume has ended. An interpreter that ends itself takes it along.
void letGo(PyObject* array) {
  if (!Py_IsInitialized() || _Py_IsFinalizing()) return;
  Locked locked;
  Py_DECREF(array);
}

Bytes bytesOf(const py::array& array) {
  lock(array);
  LentBytes lent;
  lent.owner = std::shared_ptr<const void>(py::object(array).release().ptr(), [](const void* held) {
    letGo(static_cast<PyObject*>(const_cast<void*>(held)));
  });
  lent.data = static_cast<std::byte*>(const_cast<void*>(array.data()));
  lent.size = std::size_t(array.nbytes());
  return bytesOver(std::move(lent));
}

Bytes copiedBytesOf(const py::array& array, const Volume& like, const std::vector<py::ssize_t>& shape) {
  Bytes bytes(timeStepBytes(like) * std::size_t(like.timeSteps));
  py::capsule owner(bytes.data(), [](void*) {});  // the array is gone before the bytes
  copyInto(arrayOver(std::string(enumName(like.type)), shape, bytes.data(), owner),
           array.attr("reshape")(py::cast(shape)));
  return bytes;
}

}  // namespace

Volume volumeOf(const py::array& array, std::optional<bool> copy, const VolumeFacts& facts) {
  auto shape = voxelShape(array);
  Volume volume;
  volume.timeSteps = int(shape[0]);
  volume.dims = {int(shape[3]), int(shape[2]), int(shape[1])};
  volume.channels = int(shape[4]);
  volume.type = sampleTypeOf(array);
  volume.isColor = facts.isColor;
  bool isColorful = volume.type == SampleType::UInt8 && (volume.channels == 3 || volume.channels == 4);
  if (facts.isColor && !isColorful)
    throw ArgumentError(
        fmt::format("an array of shape {} has no colours: these are 3 or 4 channels of uint8", shapeText(array)));
  volume.worldFromVoxel = facts.place.worldFromVoxel;
  volume.lengthUnit = facts.place.lengthUnit;
  volume.unit = facts.unit;
  volume.modality = facts.modality;
  volume.name = facts.name;
  volume.timeStepSeconds = facts.timeStepSeconds;
  std::string reason = whyNotShared(array);
  if (copy == false && !reason.empty())
    throw ArgumentError(fmt::format("copy=False: the array must be copied, as {}", reason));
  bool isShared = copy != true && reason.empty();
  volume.voxels = isShared ? bytesOf(array) : copiedBytesOf(array, volume, shape);
  Unlocked unlocked;
  computeRange(volume);
  return volume;
}

py::array arrayOf(const Shared<Volume>& volume) {
  const Volume& v = *volume;
  std::vector<py::ssize_t> shape{v.dims.z, v.dims.y, v.dims.x};
  if (v.channels > 1 || v.timeSteps > 1) shape.push_back(v.channels);
  if (v.timeSteps > 1) shape.insert(shape.begin(), v.timeSteps);
  py::capsule owner(new Shared<Volume>(volume), [](void* held) { delete static_cast<Shared<Volume>*>(held); });
  py::array array = arrayOver(std::string(enumName(v.type)), shape, v.voxels.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

LabelVolume labelsOf(const py::array& array, const LabelFacts& facts) {
  std::string kind = py::str(array.dtype().attr("kind"));
  if (array.ndim() != 3 || array.size() == 0)
    throw ArgumentError(fmt::format("an array of shape {} has no labels; their shape is [z,y,x]", shapeText(array)));
  if (kind != "b" && kind != "u" && kind != "i")
    throw ArgumentError(fmt::format("labels are whole numbers, not {}", std::string(py::str(array.dtype()))));
  voxelShape(array);
  py::object least = array.attr("min")(), most = array.attr("max")();
  if (least < py::int_(0) || most > py::int_(kMostId))
    throw ArgumentError(fmt::format("labels from {} to {}: ids are 0 to {}", std::string(py::str(least)),
                                    std::string(py::str(most)), kMostId));
  py::array_t<std::uint16_t> ids(std::vector<py::ssize_t>(array.shape(), array.shape() + 3));
  py::module_::import("numpy").attr("copyto")(ids, array, py::arg("casting") = "unsafe");
  glm::ivec3 dims(int(array.shape(2)), int(array.shape(1)), int(array.shape(0)));
  LabelVolume labels(dims, facts.place.worldFromVoxel, facts.place.lengthUnit);
  labels.write({0, 0, 0}, dims, {ids.data(), std::size_t(ids.size())});
  labels.name = facts.name;
  std::vector<LabelInfo> named;
  for (const auto& [id, text] : facts.names) {
    if (id < 1 || id > kMostId)
      throw ArgumentError(fmt::format("names: {} is no label; these are 1 to {}", id, kMostId));
    named.push_back({std::uint16_t(id), text, defaultLabelColor(std::uint16_t(id))});
  }
  labels.table = io::completeTable(std::move(named), labels.idsInUse());
  for (const auto& [id, color] : facts.colors) {
    auto row = std::find_if(labels.table.begin(), labels.table.end(), [id = id](auto& info) { return info.id == id; });
    if (row == labels.table.end()) throw ArgumentError(fmt::format("colors: label {} has no voxel and no name", id));
    row->color = glm::vec3(color[0], color[1], color[2]);
  }
  return labels;
}

py::array arrayOf(const LabelVolume& labels) {
  glm::ivec3 dims = labels.dims();
  py::array_t<std::uint16_t> ids({py::ssize_t(dims.z), py::ssize_t(dims.y), py::ssize_t(dims.x)});
  labels.read({0, 0, 0}, dims, {ids.mutable_data(), std::size_t(ids.size())});
  return ids;
}

py::array arrayOf(Image image, bool asBytes) {
  std::vector<py::ssize_t> shape{image.height, image.width, py::ssize_t(image.channels.size())};
  if (asBytes) {
    py::array_t<std::uint8_t> bytes(shape);
    std::transform(image.pixels.begin(), image.pixels.end(), bytes.mutable_data(), wholeSample<std::uint8_t>);
    return bytes;
  }
  auto* held = new std::vector<float>(std::move(image.pixels));
  py::capsule owner(held, [](void* pixels) { delete static_cast<std::vector<float>*>(pixels); });
  return arrayOver("float32", shape, held->data(), owner);
}

Place placeOf(const py::array_t<double>& array, const std::string& unit) {
  auto millimetres = io::millimetresOf(unit);
  if (!millimetres)
    throw ArgumentError(
        fmt::format("lengthUnit '{}' is no unit of length, as mm, um, nm and angstrom are", printable(unit)));
  if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throw ArgumentError(fmt::format("an affine is a matrix of 4 x 4, not of shape {}", shapeText(array)));
  Place place;
  if (io::isAngstrom(unit)) place.lengthUnit = LengthUnit::Angstrom;
  double factor = io::isAngstrom(unit) ? 1.0 : *millimetres;
  glm::dmat4& affine = place.worldFromVoxel;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) affine[column][row] = array.at(row, column) * (row < 3 ? factor : 1.0);
  double size = std::abs(glm::determinant(glm::dmat3(affine)));
  bool isLast = glm::dvec4(affine[0][3], affine[1][3], affine[2][3], affine[3][3]) == glm::dvec4(0, 0, 0, 1);
  if (!isLast || !std::isfinite(size) || size == 0.0 || !glm::all(glm::lessThan(glm::abs(affine[3]), glm::dvec4(1e15))))
    throw ArgumentError("an affine takes voxels to places: finite numbers, not singular, its last row 0 0 0 1");
  return place;
}

py::array_t<double> arrayOf(const glm::dmat4& affine) {
  py::array_t<double> array({4, 4});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) array.mutable_at(row, column) = affine[column][row];
  return array;
}

}  // namespace velum::python
