// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Bytes as base64. Private to the module.
 */
#ifndef HexSweepBase64_h
#define HexSweepBase64_h

#include <cstddef>

namespace hexsweep
{
/// Characters that this many bytes become, padding included.
constexpr std::size_t base64Size(std::size_t bytes)
{
  return (bytes + 2) / 3 * 4;
}

/// Writes base64Size(size) characters, no line breaks (RFC 4648, the alphabet with + and /).
void encodeBase64(const unsigned char* bytes, std::size_t size, char* text);
}

#endif
