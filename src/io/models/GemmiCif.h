#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// gemmi's CIF parser behind plain types. clang compiles gemmi's header only as C++17, for in C++20 it refuses the
/// header's vector of an incomplete type; so this header and its source are C++17, too.
namespace velum::io {

/// Receives the contents of a text, in its order.
class CifListener {
 public:
  virtual ~CifListener() = default;
  virtual void beginBlock(const std::string& name) = 0;
  virtual void takePair(const std::string& tag, const std::string& value) = 0;
  /// @param values  row by row, a multiple of the number of tags; the listener may take them out
  virtual void takeLoop(const std::vector<std::string>& tags, std::vector<std::string>& values) = 0;
};

/// @throw std::runtime_error that says where the text is not CIF
void parseCif(const char* text, std::size_t size, CifListener& listener);

bool isNullInCif(const std::string& value);       ///< The value is . or ? (unquoted).
std::string textInCif(const std::string& value);  ///< The value without its quotes.

}  // namespace velum::io
