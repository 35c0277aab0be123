#pragma once
#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <vector>

/// Texts for Python. All functions want Python's lock.
namespace velum::python {

/// UTF-8 as a text. Bytes that are none, such as names in files of old programs and paths may have, become U+FFFD.
inline pybind11::str textOf(std::string_view utf8) {
  PyObject* text = PyUnicode_DecodeUTF8(utf8.data(), pybind11::ssize_t(utf8.size()), "replace");
  if (!text) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(text);
}

inline pybind11::list textsOf(const std::vector<std::string>& lines) {
  pybind11::list texts;
  for (const std::string& line : lines) texts.append(textOf(line));
  return texts;
}

}  // namespace velum::python
