// Numbers and hashes as the text of a case has them.

#include <graze/engine/cases/text/hex_float.h>
#include <graze/engine/files/sha256.h>
#include <gtest/gtest.h>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace graze {
namespace {

using cases::parse_hex_float;
using cases::to_hex_float;

TEST(CaseNumbers, EveryDoubleComesBackBitForBit) {
  std::uint64_t bits = 1;
  for (int i = 0; i < 20000; ++i) {
    bits = bits * 6364136223846793005U + 1442695040888963407U;
    const auto value = std::bit_cast<double>(bits);
    if (!std::isfinite(value)) continue;
    const std::optional<double> back = parse_hex_float(to_hex_float(value));
    ASSERT_TRUE(back) << to_hex_float(value);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), bits);
  }
  using Limits = std::numeric_limits<double>;
  for (double value : {0.0, -0.0, Limits::denorm_min(), Limits::min(), Limits::max(), -1.0, 0.1,
                       std::nextafter(Limits::min(), 0.0)}) {
    const std::optional<double> back = parse_hex_float(to_hex_float(value));
    ASSERT_TRUE(back) << to_hex_float(value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_EQ(to_hex_float(3.0), "0x1.8p+1");
  EXPECT_EQ(to_hex_float(-0.0), "-0x0p+0");
}

TEST(CaseNumbers, OtherSpellingsOfADoubleAreRead) {
  EXPECT_EQ(parse_hex_float("0x3p0"), 3.0);
  EXPECT_EQ(parse_hex_float("+0X0.00018P+17"), 3.0);
  EXPECT_EQ(parse_hex_float("0x1800000000000000000000p-83"), 3.0);
  EXPECT_EQ(parse_hex_float("0x0.0000000000001p-1022"), 0x1p-1074);
}

TEST(CaseNumbers, WhatIsNoDoubleIsRefused) {
  for (const char* text : {"",
                           "1",
                           "0x",
                           "0xp1",
                           "0x1",
                           "0x1p",
                           "0x1p+-1",
                           "0x1p1 ",
                           " 0x1p1",
                           "nan",
                           "inf",
                           "0xinf",
                           "0x1p+1024",
                           "0x1p-1075",
                           "0x1.00000000000008p+0",
                           "0x3p-1075",
                           "0x1p99999999999",
                           "1.5",
                           "--0x1p1",
                           "0x1..8p1",
                           "0x1ffffffffffffffffffp0"}) {
    EXPECT_EQ(parse_hex_float(text), std::nullopt) << text;
  }
}

TEST(CaseHashes, AreThoseOfTheStandard) {
  EXPECT_EQ(files::sha256_of(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(files::sha256_of("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(files::sha256_of(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace graze
