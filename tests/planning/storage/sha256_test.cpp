#include "planning/storage/sha256.h"

#include <gtest/gtest.h>

#include <fstream>

#include "reconstruction/errors.h"

namespace glisson {
namespace {

std::string hashOf(const std::string& text) { return sha256Hex(std::as_bytes(std::span(text.data(), text.size()))); }

TEST(Sha256, AgreesWithTheStandardsVectors) {
  EXPECT_EQ(hashOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hashOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hashOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hashOf(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesOfAnySizeGiveTheHashOfTheWhole) {
  const std::string text(1000, 'q');
  const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
  for (std::size_t piece = 1; piece < 200; piece += 7) {
    Sha256 sha;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      sha.update(bytes.subspan(at, std::min(piece, bytes.size() - at)));
    }
    EXPECT_EQ(sha.hex(), hashOf(text)) << piece;
  }
}

TEST(Sha256, FileHasTheHashOfItsBytes) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "glisson-sha256";
  const std::string text(3000001, 'z');
  std::ofstream(path, std::ios::binary) << text;
  EXPECT_EQ(sha256HexOfFile(path), hashOf(text));
  std::filesystem::remove(path);
  EXPECT_THROW((void)sha256HexOfFile(path), InputError);
  EXPECT_THROW((void)sha256HexOfFile(::testing::TempDir()), InputError);
}

}  // namespace
}  // namespace glisson
