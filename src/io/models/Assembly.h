#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// The operators of a file (_pdbx_struct_oper_list), and the expressions that combine them.
class Operators {
 public:
  /// @param table  may be null: then there are no operators @throw InputError for an operator that is no rotation
  Operators(const CifTable* table, const Path& path);

  /// Calls @p body with each pose that an expression names, in its order: "1", "1,5", "(1-60)", "(X0)(1-5)", where the
  /// operator on the right is applied first. A range from high to low is empty, and a range that goes beyond the
  /// operators stops at the last.
  /// @throw InputError for an operator that is not there, or too many poses
  void forEach(std::string_view expression, const std::function<void(const Pose&)>& body) const;

 private:
  std::vector<std::uint32_t> listOf(std::string_view group, std::string_view expression) const;
  void addRange(std::int64_t from, std::int64_t to, std::vector<std::uint32_t>& list) const;

  const Path& mPath;
  std::vector<Pose> mPoses;
  std::map<std::string, std::uint32_t, std::less<>> mByName;
  std::map<std::int64_t, std::uint32_t> mByNumber;
};

/// The items of a list: the pieces of text between commas, without blanks around them.
std::vector<std::string_view> itemsOf(std::string_view list);

}  // namespace velum::io
