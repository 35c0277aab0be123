#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace velum {

/// The parts of a .glb, checked as the format's rules say.
struct Glb {
  nlohmann::json json;
  std::string binary;
  explicit Glb(const std::string& bytes) {
    auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      std::memcpy(&value, bytes.data() + at, 4);
      return std::size_t(value);
    };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2u);
    EXPECT_EQ(word(8), bytes.size());
    std::size_t length = word(12);
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = nlohmann::json::parse(bytes.substr(20, length));
    std::size_t second = 20 + length;
    EXPECT_EQ(word(second) % 4, 0u);
    EXPECT_EQ(bytes.substr(second + 4, 4), std::string("BIN\0", 4));
    binary = bytes.substr(second + 8);
    EXPECT_EQ(binary.size(), word(second));
    EXPECT_EQ(json["buffers"].size(), 1u);
    EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
  }
  template <class T>
  std::vector<T> read(const nlohmann::json& number) const {
    const nlohmann::json& accessor = json["accessors"][number.get<std::size_t>()];
    const nlohmann::json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::size_t count = accessor["count"], offset = view["byteOffset"], length = view["byteLength"];
    EXPECT_EQ(offset % 4, 0u);
    EXPECT_EQ(length, count * sizeof(T));
    EXPECT_LE(offset + length, binary.size());
    if (offset + length > binary.size() || length != count * sizeof(T)) return {};
    std::vector<T> values(count);
    std::memcpy(static_cast<void*>(values.data()), binary.data() + offset, length);
    return values;
  }
};

}  // namespace velum
