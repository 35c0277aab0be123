#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// gemmi's parser of CIF behind plain types: its header is C++17 to clang, which will not have a vector of what is not
/// complete in C++20. So are this header and its source.
namespace velum::io {

/// Is told what a text holds, in its order.
class CifListener {
 public:
  virtual ~CifListener() = default;
  virtual void beginBlock(const std::string& name) = 0;
  virtual void takePair(const std::string& tag, const std::string& value) = 0;
  /// @param values  row by row; a multiple of the tags; may be emptied
  virtual void takeLoop(const std::vector<std::string>& tags, std::vector<std::string>& values) = 0;
};

/// @throw std::runtime_error that says where the text is no CIF
void parseCif(const char* text, std::size_t size, CifListener& listener);

bool isNullInCif(const std::string& value);       ///< . or ?
std::string textInCif(const std::string& value);  ///< Without its quotes.

}  // namespace velum::io
