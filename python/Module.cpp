// The module _velum: what the package velum (python/velum) is made of.
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "BoundSession.h"
#include "Lock.h"
#include "Texts.h"
#include "core/Error.h"
#include "gpu/GpuError.h"
#include "io/labels/WriteLabels.h"
#include "io/volumes/WriteVolume.h"
#include "session/command/Command.h"
#include "session/command/PythonLines.h"

namespace velum::python {

namespace py = pybind11;

namespace {

/// The kinds of errors in Python. They live as long as the interpreter, as the module does.
struct ErrorKinds {
  py::handle base, argument, input, driver, cancelled;
};
ErrorKinds& errorKinds() {
  static ErrorKinds kinds;
  return kinds;
}

void raise(py::handle kind, const std::exception& error) { PyErr_SetObject(kind.ptr(), textOf(error.what()).ptr()); }

void translate(std::exception_ptr thrown) {
  const ErrorKinds& kinds = errorKinds();
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const ArgumentError& error) {
    raise(kinds.argument, error);
  } catch (const InputError& error) {
    raise(kinds.input, error);
  } catch (const gpu::GpuError& error) {
    raise(kinds.driver, error);
  } catch (const Cancelled& error) {
    raise(kinds.cancelled, error);
  } catch (const Error& error) {
    raise(kinds.base, error);
  }
}

void bindErrors(py::module_& module) {
  auto make = [&](const char* name, py::handle base) { return py::exception<Error>(module, name, base).release(); };
  ErrorKinds& kinds = errorKinds();
  kinds.base = make("Error", PyExc_RuntimeError);
  kinds.argument = make("ArgumentError", py::make_tuple(kinds.base, py::handle(PyExc_ValueError)));
  kinds.input = make("InputError", kinds.base);
  kinds.driver = make("GpuError", kinds.base);
  kinds.cancelled = make("Cancelled", kinds.base);
  py::register_exception_translator(translate);
}

/// The table of commands: a dictionary each.
py::list commandRows() {
  py::list rows;
  for (const session::Command& command : session::commands()) {
    py::list arguments;
    for (const scene::FieldRow& row : command.arguments())
      arguments.append(py::dict(py::arg("path") = row.path, py::arg("type") = row.type, py::arg("unit") = row.unit,
                                py::arg("range") = row.range, py::arg("doc") = row.doc,
                                py::arg("default") = session::pythonValue(row.defaultValue)));
    std::string example = session::pythonProgram({std::string(command.example)});
    example = example.substr(example.find("s = "));
    example = example.substr(example.find('\n') + 1);
    rows.append(py::dict(py::arg("name") = command.name, py::arg("pythonName") = session::pythonName(command.name),
                         py::arg("doc") = command.doc, py::arg("example") = example.substr(0, example.size() - 1),
                         py::arg("answers") = command.answers, py::arg("arguments") = arguments,
                         py::arg("renamed") = command.renamed));
  }
  return rows;
}

Modality modalityOf(const std::string& name) {
  if (auto modality = enumValue<Modality>(name)) return *modality;
  throw ArgumentError(
      fmt::format("modality '{}' is not one of {}", name, fmt::join(EnumNames<Modality>::kNames, ", ")));
}

void bindVolume(py::module_& module) {
  auto make = [](const py::array& array, std::optional<bool> copy, const py::array_t<double>& affine,
                 const std::string& lengthUnit, const std::string& unit, const std::string& modality, bool isColor,
                 const std::string& name, double seconds) {
    VolumeFacts facts{placeOf(affine, lengthUnit), unit, name, modalityOf(modality), isColor, seconds};
    return Shared<Volume>(volumeOf(array, copy, facts));
  };
  using Held = Shared<Volume>;
  py::class_<Held>(module, "Volume")
      .def(py::init(make))
      .def("array", [](const Held& held) { return arrayOf(held); })
      .def("affine", [](const Held& held) { return arrayOf(held->worldFromVoxel); })
      .def("facts",
           [](const Held& held) {
             const Volume& v = *held;
             return py::dict(py::arg("lengthUnit") = enumName(v.lengthUnit), py::arg("unit") = textOf(v.unit),
                             py::arg("modality") = enumName(v.modality), py::arg("color") = v.isColor,
                             py::arg("name") = textOf(v.name), py::arg("scale") = v.scale, py::arg("offset") = v.offset,
                             py::arg("range") = py::make_tuple(v.range.x, v.range.y),
                             py::arg("timeStepSeconds") = v.timeStepSeconds);
           })
      .def("save", [](const Held& held, const std::string& path) {
        std::vector<std::string> losses;
        {
          Unlocked unlocked;
          Progress progress;
          losses = io::writeVolume(*held, path, progress);
        }
        return textsOf(losses);
      });
}

void bindLabels(py::module_& module) {
  auto make = [](const py::array& array, const py::array_t<double>& affine, const std::string& lengthUnit,
                 const std::map<int, std::string>& names, const std::map<int, std::array<float, 3>>& colors,
                 const std::string& name) {
    return Shared<LabelVolume>(labelsOf(array, {placeOf(affine, lengthUnit), names, colors, name}));
  };
  using Held = Shared<LabelVolume>;
  py::class_<Held>(module, "Labels")
      .def(py::init(make))
      .def("array", [](const Held& held) { return arrayOf(*held); })
      .def("affine", [](const Held& held) { return arrayOf(held->worldFromVoxel()); })
      .def("facts",
           [](const Held& held) {
             py::dict names, colors;
             for (const LabelInfo& row : held->table) {
               names[py::int_(row.id)] = textOf(row.name);
               colors[py::int_(row.id)] = py::make_tuple(row.color.r, row.color.g, row.color.b);
             }
             return py::dict(py::arg("lengthUnit") = enumName(held->lengthUnit()), py::arg("names") = names,
                             py::arg("colors") = colors, py::arg("name") = textOf(held->name));
           })
      .def("save", [](const Held& held, const std::string& path) {
        std::vector<std::string> losses;
        {
          Unlocked unlocked;
          Progress progress;
          losses = io::writeLabels(*held, path, progress);
        }
        return textsOf(losses);
      });
}

void bindSession(py::module_& module) {
  using S = BoundSession;
  auto picture = [](S& session, int width, int height, int samples, bool transparent, bool layers, bool isFine,
                    const std::string& section, bool asBytes) {
    Image image = session.picture({width, height, samples, transparent, layers, isFine, section});
    py::list channels = textsOf(image.channels);
    return py::make_tuple(channels, arrayOf(std::move(image), asBytes));
  };
  auto run = [](S& session, const std::vector<std::string>& lines) {
    S::Told told = session.run(lines);
    return py::make_tuple(told.isAnswer, textsOf(told.lines));
  };
  auto frame = [](S& session, const S::Frames& frames, int place, bool asBytes) {
    Image image = session.frame(frames, place);
    py::list channels = textsOf(image.channels);
    return py::make_tuple(channels, arrayOf(std::move(image), asBytes));
  };
  py::class_<S::Frames>(module, "Frames").def_readonly("count", &S::Frames::count);
  py::class_<S>(module, "Session")
      .def(py::init<const std::string&>())
      .def("_run", run)
      .def("_field", [](S& session, const std::string& path) { return textOf(session.field(path)); })
      .def("_program", [](S& session) { return textOf(session.program()); })
      .def("_openVolume", &S::openVolume)
      .def("_putLabels", &S::putLabels)
      .def("_volume", &S::volume)
      .def("_labels", &S::labels)
      .def("_picture", picture)
      .def("_frames", &S::frames)
      .def("_frame", frame)
      .def("_endFrames", &S::endFrames)
      .def("_measure", &S::measure)
      .def("_count", &S::count)
      .def("_cancel", &S::cancel)
      .def("_close", &S::close)
      .def_readwrite("_listener", &S::listener);
}

}  // namespace

PYBIND11_MODULE(_velum, module) {
  module.attr("version") = VELUM_VERSION;
  bindErrors(module);
  module.def("commands", commandRows);
  module.def("asLine", [](const std::string& line) { return session::parseCall(line).line(); });
  bindVolume(module);
  bindLabels(module);
  bindSession(module);
}

}  // namespace velum::python
