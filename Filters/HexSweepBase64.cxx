// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBase64.h"

#include <array>

namespace hexsweep
{
namespace
{
constexpr char Alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned TwelveBits = 1U << 12U;

/// The two characters of every twelve bits: a look at a table instead of four.
constexpr std::array<char, 2 * TwelveBits> pairsOfCharacters()
{
  std::array<char, 2 * TwelveBits> pairs{};
  for (unsigned i = 0; i < TwelveBits; ++i)
  {
    pairs[2 * i] = Alphabet[i >> 6U];
    pairs[2 * i + 1] = Alphabet[i & 63U];
  }
  return pairs;
}

constexpr std::array<char, 2 * TwelveBits> Pairs = pairsOfCharacters();
}

void encodeBase64(const unsigned char* bytes, std::size_t size, char* text)
{
  const auto put = [&](unsigned a, unsigned b, unsigned c) {
    const unsigned high = (a << 4U) | (b >> 4U);
    const unsigned low = ((b & 15U) << 8U) | c;
    text[0] = Pairs[2 * high];
    text[1] = Pairs[2 * high + 1];
    text[2] = Pairs[2 * low];
    text[3] = Pairs[2 * low + 1];
  };
  std::size_t i = 0;
  for (; i + 3 <= size; i += 3, text += 4)
  {
    put(bytes[i], bytes[i + 1], bytes[i + 2]);
  }
  if (i < size)
  {
    const bool two = i + 2 == size;
    put(bytes[i], two ? bytes[i + 1] : 0, 0);
    text[2] = two ? text[2] : '=';
    text[3] = '=';
  }
}
}
